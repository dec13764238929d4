// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "odas/tracking/association.hpp"
#include "odas/tracking/config.hpp"
#include "odas/tracking/departed.hpp"
#include "odas/tracking/tracker.hpp"

namespace odas {

/// Birth, probation, life and death of tracks in a fixed number of slots, over any filter that follows one
/// source.
///
/// Method, each hop: predict; associate the potentials; update each filter by what it was given; a track on
/// probation is promoted after N_prob hops if it was active enough, else removed; an active one is removed
/// after N_inactive silent hops in a row; a potential that is new with more than theta_new opens a track on
/// probation in the first free slot. Only promoted tracks and targets are seen from outside.
/// Source: Grondin and Michaud, 2019, section 4; ODAS (its mod_sst).
/// Departures from ODAS: several tracks may be born in one hop, as long as the later ones are not explained
/// by those just born (ODAS wrote all into the same slot and the last one won); a track gets its id when it
/// is promoted, so that no id is lost on those that never are; directions have length 1; targets come, move
/// and go while running; a source that comes back may be known again (`sst.memory`), the nearest one first.
template <class Filter>
class SlotTracker final : public Tracker {
 public:
  /// `prototype`: the filter of each slot.
  SlotTracker(const SstConfig& config, const TrackerContext& context, const Filter& prototype);

  void update(std::span<const Potential> potentials, std::span<Track> tracks) noexcept override;
  void set_targets(std::span<const Target> targets) noexcept override;
  [[nodiscard]] std::size_t unfollowed_targets() const noexcept override { return refused_ + waiting_; }
  void continue_from(const Tracker& before) noexcept override;
  [[nodiscard]] std::uint64_t last_id() const noexcept override { return last_id_; }
  void reset() noexcept override;

 private:
  enum class Stage : std::uint8_t { free, probation, active, target };
  struct Life {
    Stage stage = Stage::free;
    std::uint64_t id = 0;  // given when it is first seen from outside
    ShortString<63> tag{};
    int hops_on_probation = 0;
    double activity_on_probation = 0;
    int silent_hops = 0;
    double activity = 0;
  };
  /// The filter outlives the track: what it has allocated serves the next one.
  struct Slot : Life {
    Filter filter;
  };

  void follow_targets() noexcept;
  void associate(std::span<const Potential> potentials) noexcept;
  void follow(std::span<const Potential> potentials) noexcept;
  void name_promoted() noexcept;
  void remove_lost(std::size_t living) noexcept;
  void open_new(std::span<const Potential> potentials) noexcept;
  [[nodiscard]] double probability_new(std::size_t potential,
                                       std::span<const Potential> potentials) const noexcept;
  [[nodiscard]] double sigma2(Stage stage) const noexcept;
  [[nodiscard]] Slot* free_slot() noexcept;
  static void start(Slot& slot, Stage stage, const ShortString<63>& tag, Vec3 direction) noexcept;
  static void clear(Slot& slot) noexcept { static_cast<Life&>(slot) = Life{}; }

  SstConfig config_;
  bool dynamic_;
  Association association_;
  std::vector<Slot> slots_;
  std::uint64_t last_id_ = 0;
  Departed departed_;
  TargetList first_targets_, targets_;
  std::size_t first_refused_ = 0, refused_ = 0;  // targets at fault
  std::size_t waiting_ = 0;                      // targets without a slot
};

}  // namespace odas
