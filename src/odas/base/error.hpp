// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace odas {

/// One thing that is wrong (or doubtful) in what the user wrote.
struct Fault {
  enum class Severity { error, warning };
  Severity severity = Severity::error;
  std::string path;  // of the setting: "general.mics[2].mu"; may be empty
  std::string what;  // what is wrong, and what would be right
  std::string file;  // may be empty
  int line = 0;      // 0: unknown
};

/// `file:line: error: path: what`, as compilers say it.
[[nodiscard]] std::string to_string(const Fault& fault);

/// A configuration that cannot be run. Carries every fault, not only the first.
class ConfigError : public std::runtime_error {
 public:
  explicit ConfigError(std::vector<Fault> faults);
  ConfigError(std::string path, std::string what);

  [[nodiscard]] const std::vector<Fault>& faults() const noexcept { return faults_; }

 private:
  std::vector<Fault> faults_;
};

/// The world said no: a device, file or socket. The message says what happened and what to do.
class IoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace odas
