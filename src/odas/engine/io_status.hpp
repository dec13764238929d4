// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>

namespace odas {

/// How it went with the world outside: well, or a message that says what happened and what to do.
/// A value and no exception, for a full disk is no surprise to a program that writes.
class [[nodiscard]] IoStatus {
 public:
  IoStatus() = default;
  [[nodiscard]] static IoStatus failed(std::string what) {
    IoStatus status;
    status.what_ = std::move(what);
    return status;
  }

  [[nodiscard]] bool ok() const noexcept { return what_.empty(); }
  [[nodiscard]] const std::string& what() const noexcept { return what_; }

 private:
  std::string what_;
};

}  // namespace odas
