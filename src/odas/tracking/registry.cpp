// SPDX-License-Identifier: MIT
#include <array>

#include "odas/base/error.hpp"
#include "odas/tracking/bernoulli.hpp"
#include "odas/tracking/kalman.hpp"
#include "odas/tracking/particle.hpp"
#include "odas/tracking/slot_tracker.hpp"
#include "odas/tracking/tracker.hpp"

namespace odas {
namespace {

using Made = std::unique_ptr<Tracker>;

Made kalman(const SstConfig& config, const TrackerContext& context) {
  return std::make_unique<SlotTracker<Kalman>>(config, context, Kalman(config.kalman, context.hop_seconds));
}
Made particle(const SstConfig& config, const TrackerContext& context) {
  return std::make_unique<SlotTracker<Particle>>(config, context,
                                                 Particle(config.particle, context.hop_seconds));
}
Made bernoulli(const SstConfig& config, const TrackerContext& context) {
  return std::make_unique<BernoulliTracker>(config, context);
}

struct Row {
  std::string_view name;
  Made (*make)(const SstConfig&, const TrackerContext&);
};
constexpr std::array kTrackers{Row{"kalman", kalman}, Row{"particle", particle}, Row{"bernoulli", bernoulli}};

}  // namespace

std::unique_ptr<Tracker> make_tracker(const SstConfig& config, const TrackerContext& context) {
  if (config.slots() > 0 && config.n_inactive.empty()) {
    throw ConfigError("sst.N_inactive", "is empty, must have at least one number");
  }
  std::string names;
  for (const Row& row : kTrackers) {
    if (row.name == config.mode) return row.make(config, context);
    names += (names.empty() ? "" : ", ") + std::string(row.name);
  }
  throw ConfigError("sst.mode", "\"" + config.mode + "\" is not there; allowed: " + names);
}

std::vector<std::string_view> tracker_names() {
  std::vector<std::string_view> names;
  for (const Row& row : kTrackers) names.push_back(row.name);
  return names;
}

}  // namespace odas
