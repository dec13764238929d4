// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "odas/base/error.hpp"
#include "odas/config/locations.hpp"
#include "odas/config/source_text.hpp"
#include "odas/engine/config.hpp"

namespace libconfig {
class Setting;
}

namespace odas {

/// Carries libconfig's settings into the members of a Configuration by its schema: one recursion for all
/// keys. Takes down where each setting stands, and what is wrong with it.
class SettingReader {
 public:
  SettingReader(const SourceText& source, Locations& locations, std::vector<Fault>& faults)
      : source_(source), locations_(locations), faults_(faults) {}

  void read(const libconfig::Setting& root, Configuration& config) const;

 private:
  using Setting = libconfig::Setting;
  using Structs = std::span<const GroupRef>;  // a group's keys may belong to more than one struct

  void read_group(const Setting* group, const std::string& path, Structs structs) const;
  void read_field(const Setting& setting, const std::string& path, const Field& field, void* object) const;
  void read_list(const Setting& setting, const std::string& path, const ListRef& list) const;
  void read_unknown(const Setting& setting, const std::string& path, Structs structs) const;
  void read_numbers(const Setting& setting, const std::string& path, const Field& field,
                    std::span<float> values) const;
  void read_integers(const Setting& setting, const std::string& path, const Field& field,
                     std::vector<int>& values) const;
  void read_texts(const Setting& setting, const std::string& path, const Field& field,
                  std::vector<std::string>& values) const;

  [[nodiscard]] std::optional<float> number(const Setting& setting, const std::string& path,
                                            const Field& field) const;
  [[nodiscard]] std::optional<int> integer(const Setting& setting, const std::string& path,
                                           const Field& field) const;
  [[nodiscard]] std::optional<std::string> text(const Setting& setting, const std::string& path,
                                                const Field& field) const;
  [[nodiscard]] std::optional<double> in_range(double value, const std::string& path,
                                               const Field& field) const;
  [[nodiscard]] bool is_sequence(const Setting& setting, const std::string& path, const char* of) const;

  void note(const Setting& setting, const std::string& path) const;
  void error(const std::string& path, std::string what) const;
  void warning(const std::string& path, std::string what) const;

  const SourceText& source_;
  Locations& locations_;
  std::vector<Fault>& faults_;
};

}  // namespace odas
