// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "odas/base/error.hpp"
#include "odas/config/locations.hpp"
#include "odas/engine/config.hpp"

namespace odas {

/// Where checks say what they find.
class CheckReport {
 public:
  CheckReport(const Locations& locations, std::vector<Fault>& faults)
      : locations_(locations), faults_(faults) {}

  void error(std::string path, std::string what);
  void warning(std::string path, std::string what);

  /// No error so far at this path, in what it holds, or in what holds it: it makes sense to compare it.
  [[nodiscard]] bool sound(const std::string& path) const;
  /// Whether the user wrote it.
  [[nodiscard]] bool written(const std::string& path) const { return locations_.has(path); }

 private:
  const Locations& locations_;
  std::vector<Fault>& faults_;
};

/// What no single key can tell: whether the keys of a configuration go together. Appends to `faults`.
void check_configuration(const Configuration& config, const Locations& locations, std::vector<Fault>& faults);

/// Its parts: raw, mapping and general; sne to classify; where everything comes from and goes to.
void check_array(const Configuration& config, CheckReport& report);
void check_stages(const Configuration& config, CheckReport& report);
void check_interfaces(const Configuration& config, CheckReport& report);

/// What the outputs of a configuration ask for.
[[nodiscard]] Wanted wanted_of(const Configuration& config);

}  // namespace odas
