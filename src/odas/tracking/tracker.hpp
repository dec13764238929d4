// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "odas/array/types.hpp"
#include "odas/tracking/config.hpp"
#include "odas/tracking/target.hpp"

namespace odas {

/// Follows sources: from each hop's potentials to tracks with an identity.
/// Errors: a potential that is not finite counts as none.
class Tracker {
 public:
  virtual ~Tracker() = default;

  /// Writes every slot of `tracks`; those without a confirmed source get id 0. Allocates nothing.
  virtual void update(std::span<const Potential> potentials, std::span<Track> tracks) noexcept = 0;
  /// From the next hop on these are the fixed directions, in place of those before: a track follows its tag
  /// to its new direction, a target that is not among them frees its slot, a new one takes the first free
  /// slot, now or as soon as there is one; the first targets go first. Allocates nothing.
  virtual void set_targets(std::span<const Target> targets) noexcept = 0;
  /// Targets that are not followed as of the last hop: no slot was free, or they were at fault
  /// (`TargetList::assign`).
  [[nodiscard]] virtual std::size_t unfollowed_targets() const noexcept = 0;
  /// Goes on where `before` stands, which has as many slots: with its targets, and later ids than its own.
  /// If it is a tracker of the same kind, its tracks go on, too; others are found anew. Allocates nothing.
  virtual void continue_from(const Tracker& before) noexcept = 0;
  /// The latest that was given; 0: none yet.
  [[nodiscard]] virtual std::uint64_t last_id() const noexcept = 0;
  /// The state after construction, exactly: the targets of the configuration too.
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
/// The names that can be made.
[[nodiscard]] std::vector<std::string_view> tracker_names();

}  // namespace odas
