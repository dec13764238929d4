// SPDX-License-Identifier: MIT
#include "odas/base/error.hpp"
#include "odas/tracking/kalman.hpp"
#include "odas/tracking/slot_tracker.hpp"
#include "odas/tracking/tracker.hpp"

namespace odas {

std::unique_ptr<Tracker> make_tracker(const SstConfig& config, const TrackerContext& context) {
  if (config.mode == "kalman") {
    return std::make_unique<SlotTracker<Kalman>>(config, context, Kalman(config.kalman, context.hop_seconds));
  }
  throw ConfigError("sst.mode", "\"" + config.mode + "\" is no tracker; there is kalman");
}

}  // namespace odas
