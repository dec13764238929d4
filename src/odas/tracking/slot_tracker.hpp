// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "odas/tracking/association.hpp"
#include "odas/tracking/config.hpp"
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
/// is promoted, so that no id is lost on those that never are; directions have length 1.
template <class Filter>
class SlotTracker final : public Tracker {
 public:
  /// `prototype` is the filter that each slot starts from.
  SlotTracker(const SstConfig& config, const TrackerContext& context, const Filter& prototype);

  void update(std::span<const Potential> potentials, std::span<Track> tracks) noexcept override;
  void reset() noexcept override;

 private:
  enum class Stage : std::uint8_t { free, probation, active, target };
  struct Slot {
    Stage stage = Stage::free;
    std::uint64_t id = 0;  // given when it is first seen from outside
    ShortString<63> tag{};
    Filter filter;
    int hops_on_probation = 0;
    double activity_on_probation = 0;
    int silent_hops = 0;
    double activity = 0;
  };

  void follow_targets() noexcept;
  void associate(std::span<const Potential> potentials) noexcept;
  void follow(std::span<const Potential> potentials) noexcept;
  void remove_lost(std::size_t living) noexcept;
  void open_new(std::span<const Potential> potentials) noexcept;
  [[nodiscard]] double probability_new(std::size_t potential,
                                       std::span<const Potential> potentials) const noexcept;
  [[nodiscard]] double sigma2(Stage stage) const noexcept;
  void start(Slot& slot, Stage stage, const ShortString<63>& tag, Vec3 direction) noexcept;

  SstConfig config_;
  bool dynamic_;
  Filter prototype_;
  Association association_;
  std::vector<Slot> slots_;
  std::uint64_t last_id_ = 0;
};

}  // namespace odas
