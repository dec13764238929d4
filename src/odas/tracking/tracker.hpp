// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "odas/array/types.hpp"
#include "odas/tracking/config.hpp"

namespace odas {

/// Follows sources: from each hop's potentials to tracks with an identity.
class Tracker {
 public:
  virtual ~Tracker() = default;

  /// Writes every slot of `tracks`; those without a confirmed source get id 0. Allocates nothing.
  virtual void update(std::span<const Potential> potentials, std::span<Track> tracks) noexcept = 0;
  /// The state after construction, exactly.
  virtual void reset() noexcept = 0;
};

/// What a tracker needs to know of the other stages.
struct TrackerContext {
  double hop_seconds = 0;      // between two updates
  double heard_share = 1;      // of the sphere, that the localizer searches
  std::size_t potentials = 0;  // per hop
};

/// The tracker that `sst.mode` names. Throws ConfigError for a name that is not in the table.
[[nodiscard]] std::unique_ptr<Tracker> make_tracker(const SstConfig& config, const TrackerContext& context);

}  // namespace odas
