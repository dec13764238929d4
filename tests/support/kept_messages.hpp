// SPDX-License-Identifier: MIT
#pragma once

#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "odas/studio/messages.hpp"

namespace odas::test {

/// Keeps all that is announced.
class KeptMessages : public Announcer {
 public:
  void announce(const std::string& topic, const nlohmann::json& message) override {
    const std::scoped_lock lock(mutex_);
    all_.emplace_back(topic, message);
  }
  [[nodiscard]] std::vector<nlohmann::json> of(const std::string& topic) const {
    const std::scoped_lock lock(mutex_);
    std::vector<nlohmann::json> found;
    for (const auto& [name, message] : all_) {
      if (name == topic) found.push_back(message);
    }
    return found;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::pair<std::string, nlohmann::json>> all_;
};

}  // namespace odas::test
