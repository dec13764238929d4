// SPDX-License-Identifier: MIT
#include "odas/base/error.hpp"

namespace odas {

std::string to_string(const Fault& fault) {
  std::string text;
  if (!fault.file.empty()) text += fault.file + ":";
  if (fault.line > 0) text += std::to_string(fault.line) + ":";
  if (!text.empty()) text += " ";
  text += fault.severity == Fault::Severity::error ? "error: " : "warning: ";
  if (!fault.path.empty()) text += fault.path + ": ";
  return text + fault.what;
}

namespace {

std::string join(const std::vector<Fault>& faults) {
  std::string text;
  for (const Fault& fault : faults) text += (text.empty() ? "" : "\n") + to_string(fault);
  return text;
}

}  // namespace

ConfigError::ConfigError(std::vector<Fault> faults)
    : std::runtime_error(join(faults)), faults_(std::move(faults)) {}

ConfigError::ConfigError(std::string path, std::string what)
    : ConfigError(std::vector<Fault>{{Fault::Severity::error, std::move(path), std::move(what), "", 0}}) {}

}  // namespace odas
