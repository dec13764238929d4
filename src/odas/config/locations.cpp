// SPDX-License-Identifier: MIT
#include "odas/config/locations.hpp"

namespace odas {

Location Locations::find(std::string_view path) const {
  while (!path.empty()) {
    if (const auto found = lines_.find(path); found != lines_.end()) return found->second;
    const std::size_t cut = path.find_last_of(".[");
    path = cut == std::string_view::npos ? std::string_view{} : path.substr(0, cut);
  }
  return {file_, 0};
}

Fault Locations::locate(Fault fault) const {
  if (!fault.file.empty()) return fault;
  Location where = find(fault.path);
  fault.file = std::move(where.file);
  fault.line = where.line;
  return fault;
}

ConfigError Locations::locate(const ConfigError& error) const {
  std::vector<Fault> faults = error.faults();
  for (Fault& fault : faults) fault = locate(std::move(fault));
  return ConfigError(std::move(faults));
}

}  // namespace odas
