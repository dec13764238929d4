// SPDX-License-Identifier: MIT
// What tests of the Studio's parts share.
#pragma once

#include <mutex>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "odas/studio/document.hpp"
#include "odas/studio/messages.hpp"

namespace odas::test {

/// Keeps what is announced.
class HeardMessages final : public Announcer {
 public:
  void announce(const std::string& topic, const nlohmann::json& message) override {
    const std::lock_guard lock(mutex_);
    topics_.push_back(topic);
    messages_.push_back(message);
  }
  [[nodiscard]] std::vector<nlohmann::json> messages() const {
    const std::lock_guard lock(mutex_);
    return messages_;
  }
  [[nodiscard]] std::vector<std::string> topics() const {
    const std::lock_guard lock(mutex_);
    return topics_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> topics_;
  std::vector<nlohmann::json> messages_;
};

inline std::string sample_file() { return std::string(ODAS_SOURCE_DIR) + "/configs/sample.cfg"; }
inline Document sample_document() { return read_document(sample_file()); }

}  // namespace odas::test
