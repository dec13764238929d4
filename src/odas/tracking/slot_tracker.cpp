// SPDX-License-Identifier: MIT
#include "odas/tracking/slot_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "odas/base/contract.hpp"
#include "odas/tracking/kalman.hpp"
#include "odas/tracking/particle.hpp"

namespace odas {
template <class Filter>
SlotTracker<Filter>::SlotTracker(const SstConfig& config, const TrackerContext& context,
                                 const Filter& prototype)
    : config_(config),
      dynamic_(config.add == "dynamic"),
      association_(config, config.slots(), context.potentials, context.heard_share),
      slots_(config.slots(), Slot{{}, prototype}),
      departed_(hops_in(static_cast<double>(config.memory), context.hop_seconds)) {
  first_refused_ = refused_ = first_targets_.assign(targets_of(config));
  targets_ = first_targets_;
}

template <class Filter>
void SlotTracker<Filter>::set_targets(std::span<const Target> targets) noexcept {
  refused_ = targets_.assign(targets);
}

template <class Filter>
void SlotTracker<Filter>::continue_from(const Tracker& before) noexcept {
  last_id_ = before.last_id();
  const auto* same = dynamic_cast<const SlotTracker*>(&before);
  if (same == nullptr || same->slots_.size() != slots_.size()) return;
  targets_ = same->targets_;
  refused_ = same->refused_;
  for (std::size_t t = 0; t < slots_.size(); ++t) {
    const Slot& slot = same->slots_[t];
    static_cast<Life&>(slots_[t]) = slot;
    if (slot.stage != Stage::free) slots_[t].filter.start(slot.filter.direction());
  }
}

template <class Filter>
void SlotTracker<Filter>::reset() noexcept {
  for (Slot& slot : slots_) clear(slot);
  last_id_ = 0;
  departed_.reset();
  targets_ = first_targets_;
  refused_ = first_refused_;
  waiting_ = 0;
}

template <class Filter>
void SlotTracker<Filter>::update(std::span<const Potential> potentials, std::span<Track> tracks) noexcept {
  ODAS_EXPECT(tracks.size() == slots_.size());
  follow_targets();
  const auto living = static_cast<std::size_t>(
      std::count_if(slots_.begin(), slots_.end(), [](const Slot& s) { return s.stage != Stage::free; }));
  associate(potentials);
  follow(potentials);
  departed_.age();
  name_promoted();
  if (dynamic_) {
    open_new(potentials);
    remove_lost(living);
  }
  for (std::size_t t = 0; t < slots_.size(); ++t) {
    const Slot& slot = slots_[t];
    const bool seen = slot.stage == Stage::active || slot.stage == Stage::target;
    tracks[t] =
        seen ? Track{slot.id, slot.tag, slot.filter.direction(), static_cast<float>(slot.activity)} : Track{};
  }
}

template <class Filter>
void SlotTracker<Filter>::follow_targets() noexcept {
  for (Slot& slot : slots_) {
    if (slot.stage == Stage::target && targets_.find(slot.tag) == nullptr) clear(slot);
  }
  waiting_ = 0;
  for (const Target& target : targets_.view()) {
    const auto has_tag = [&](const Slot& s) { return s.stage == Stage::target && s.tag == target.tag; };
    const auto own = std::find_if(slots_.begin(), slots_.end(), has_tag);
    if (own != slots_.end()) {
      if (own->filter.direction() != target.direction) own->filter.start(target.direction);
    } else if (Slot* slot = free_slot()) {
      start(*slot, Stage::target, target.tag, target.direction);
      slot->id = ++last_id_;
    } else {
      ++waiting_;
    }
  }
}

template <class Filter>
void SlotTracker<Filter>::associate(std::span<const Potential> potentials) noexcept {
  for (std::size_t t = 0; t < slots_.size(); ++t) {
    Slot& slot = slots_[t];
    if (slot.stage == Stage::free) {
      association_.set_dead(t);
      continue;
    }
    if (slot.stage != Stage::target) slot.filter.predict();
    for (std::size_t s = 0; s < potentials.size(); ++s) {
      association_.set_track(t, s, slot.filter.log_likelihood(potentials[s].direction, sigma2(slot.stage)));
    }
  }
  association_.solve(potentials);
}

template <class Filter>
void SlotTracker<Filter>::follow(std::span<const Potential> potentials) noexcept {
  for (std::size_t t = 0; t < slots_.size(); ++t) {
    Slot& slot = slots_[t];
    if (slot.stage == Stage::free) continue;
    slot.activity = association_.activity(t);
    if (slot.stage == Stage::target) continue;
    slot.filter.update(potentials, association_.from_track(t), slot.activity, sigma2(slot.stage));
    if (slot.stage == Stage::active) {
      slot.silent_hops =
          slot.activity >= static_cast<double>(config_.theta_inactive) ? 0 : slot.silent_hops + 1;
    } else {
      ++slot.hops_on_probation;
      slot.activity_on_probation += slot.activity;
      const double mean = slot.activity_on_probation / slot.hops_on_probation;
      if (slot.hops_on_probation >= config_.n_prob && mean >= static_cast<double>(config_.theta_prob)) {
        slot.stage = Stage::active;
        slot.silent_hops = 0;
      }
    }
  }
}

template <class Filter>
void SlotTracker<Filter>::name_promoted() noexcept {
  const auto has_no_name = [](const Slot& s) { return s.stage == Stage::active && s.id == 0; };
  // Those that are known go first, the nearest pair of all before any other: two who come back at once
  // near each other do not take each other's names.
  for (;;) {
    Slot* known = nullptr;
    Departed::Match best{0, -1};
    for (Slot& slot : slots_) {
      if (!has_no_name(slot)) continue;
      const auto match = departed_.nearest(slot.filter.direction());
      if (!match || match->cosine <= best.cosine) continue;
      known = &slot;
      best = *match;
    }
    if (known == nullptr) break;
    const Departed::Source source = departed_.take(best.place);
    known->id = source.id;
    // Into its old slot, the channel where it is listened for, if nobody is seen there.
    Slot& old = slots_[source.slot];
    if (old.stage == Stage::free || old.stage == Stage::probation || has_no_name(old)) std::swap(*known, old);
  }
  for (Slot& slot : slots_) {
    if (has_no_name(slot)) slot.id = ++last_id_;
  }
}

template <class Filter>
void SlotTracker<Filter>::remove_lost(std::size_t living) noexcept {
  if (living == 0) return;
  const int patience = config_.patience(living);
  for (std::size_t t = 0; t < slots_.size(); ++t) {
    Slot& slot = slots_[t];
    const bool failed = slot.stage == Stage::probation && slot.hops_on_probation >= config_.n_prob;
    const bool lost = slot.stage == Stage::active && slot.silent_hops >= patience;
    if (lost) departed_.add(slot.id, slot.filter.direction(), t);
    if (failed || lost) clear(slot);
  }
}

template <class Filter>
void SlotTracker<Filter>::open_new(std::span<const Potential> potentials) noexcept {
  for (std::size_t s = 0; s < potentials.size(); ++s) {
    if (probability_new(s, potentials) <= static_cast<double>(config_.theta_new)) continue;
    Slot* slot = free_slot();
    if (slot == nullptr) return;
    start(*slot, Stage::probation, "dynamic", potentials[s].direction);
  }
}

template <class Filter>
double SlotTracker<Filter>::probability_new(std::size_t potential,
                                            std::span<const Potential> potentials) const noexcept {
  double least = association_.is_new(potential);
  for (const Slot& slot : slots_) {
    const bool just_born = slot.stage == Stage::probation && slot.hops_on_probation == 0;
    if (!just_born) continue;
    const double fit = slot.filter.log_likelihood(potentials[potential].direction, sigma2(slot.stage));
    least = std::min(least, association_.is_new_beside(potential, fit));
  }
  return least;
}

template <class Filter>
double SlotTracker<Filter>::sigma2(Stage stage) const noexcept {
  if (stage == Stage::probation) return static_cast<double>(config_.sigma_r2_prob);
  if (stage == Stage::target) return static_cast<double>(config_.sigma_r2_target);
  return static_cast<double>(config_.sigma_r2_active);
}

template <class Filter>
typename SlotTracker<Filter>::Slot* SlotTracker<Filter>::free_slot() noexcept {
  const auto is_free = [](const Slot& s) { return s.stage == Stage::free; };
  const auto slot = std::find_if(slots_.begin(), slots_.end(), is_free);
  return slot == slots_.end() ? nullptr : &*slot;
}

template <class Filter>
void SlotTracker<Filter>::start(Slot& slot, Stage stage, const ShortString<63>& tag,
                                Vec3 direction) noexcept {
  clear(slot);
  slot.stage = stage;
  slot.tag = tag;
  slot.filter.start(direction);
}

template class SlotTracker<Kalman>;
template class SlotTracker<Particle>;

}  // namespace odas
