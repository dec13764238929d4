// SPDX-License-Identifier: MIT
#include "odas/config/checks.hpp"

#include <algorithm>

namespace odas {

namespace {

/// "general.mics" holds "general.mics[2].mu"; it does not hold "general.micsX".
bool holds(const std::string& outer, const std::string& inner) {
  return inner.starts_with(outer) &&
         (inner.size() == outer.size() || inner[outer.size()] == '.' || inner[outer.size()] == '[');
}

}  // namespace

void CheckReport::error(std::string path, std::string what) {
  faults_.push_back(locations_.locate({Fault::Severity::error, std::move(path), std::move(what), "", 0}));
}

void CheckReport::warning(std::string path, std::string what) {
  faults_.push_back(locations_.locate({Fault::Severity::warning, std::move(path), std::move(what), "", 0}));
}

bool CheckReport::sound(const std::string& path) const {
  return std::none_of(faults_.begin(), faults_.end(), [&](const Fault& fault) {
    return fault.severity == Fault::Severity::error && (holds(path, fault.path) || holds(fault.path, path));
  });
}

void check_configuration(const Configuration& config, const Locations& locations,
                         std::vector<Fault>& faults) {
  CheckReport report(locations, faults);
  check_array(config, report);
  check_stages(config, report);
  check_interfaces(config, report);
}

Wanted wanted_of(const Configuration& config) {
  Wanted wanted;
  wanted.potentials = is_wanted(config.potential);
  wanted.tracks = is_wanted(config.tracked);
  wanted.separated = is_wanted(config.separated);
  wanted.postfiltered = is_wanted(config.postfiltered);
  wanted.categories = is_wanted(config.category) || (config.pipeline.classify.in_tracks && wanted.tracks);
  return wanted;
}

}  // namespace odas
