// SPDX-License-Identifier: MIT
#include "odas/tracking/bernoulli.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "odas/base/contract.hpp"

namespace odas {
namespace {

// Talkers and rooms: docs/tracking.md says how they were chosen.
constexpr double kIndependent = 0.064;               // s between two observations that tell anew
constexpr double kFound = 0.63;                      // a source that sounds is among the potentials
constexpr double kNew = 0.02;                        // prior of a new source, to that of none
constexpr double kFallsSilent = 0.3, kSpeaks = 0.4;  // s, means: until a voice pauses, and is back
constexpr double kOpens = 0.73;                      // evidence of a potential that opens a candidate
constexpr double kGivenUp = -0.8;                    // nats, of a candidate
constexpr double kMost = 7;                          // nats; evidence is not counted beyond
constexpr double kConfirmed = 0.8, kSure = 5;        // nats: of hops that it led; of all hops, at most
constexpr double kBeside = 25;                       // nats more of hops that it led, beside a track,
constexpr double kReflects = 20 * kDegree;           // of azimuth, and how far off that fades
constexpr double kPatience = 0.18;                   // s of silence, at least
constexpr double kEarned = 0.2;                      // s more for each nat of its strength, if alone
constexpr double kAlone = 68 * kDegree;              // of azimuth: other tracks are farther off than that
constexpr double kForgotten = 3.6;                   // s: strength is of late
constexpr double kHidden = 3;                        // s of silence at least, of whom somebody walks past,
constexpr double kPasses = 27 * kDegree;             // of azimuth: this near
constexpr double kMine = 1.35;  // as much likelier than another's an observation is when it moves a track
constexpr double kEchoes = 40 * kDegree;  // of elevation, floor and ceiling from their talker
constexpr double kGoesOn = 0.73;          // s of silence in which who walks walks on
constexpr double kPause = 0.11, kPace = 30 * kDegree, kFarthest = 28 * kDegree;  // s, rad/s: where to by then
// Speech swells and fades: the deviation of ln E over two seconds is 1, of a fan or a motor 0.45.
constexpr double kLoudness = 2;                                // s
constexpr double kSteady = 0.6;                                // deviation; less of it does not speak
constexpr double kSoon = 1, kOverlap = 0.1, kLongOverlap = 4;  // s

/// Nearer than two people stand. Where elevation is worse heard than azimuth, what floor and ceiling send
/// back, at the azimuth of their talker, is in one place with them.
bool one_place(Walker::Offset apart, TangentCovariance blur) {
  const double echoes = blur.north > 2 * blur.east ? kEchoes : kSamePlace;
  return std::abs(apart.east) < kSamePlace &&
         std::abs(apart.north) < echoes + 3.5 * std::sqrt(static_cast<double>(blur.north));
}

double sigmoid(double x) { return 1 / (1 + std::exp(-x)); }

}  // namespace

BernoulliTracker::BernoulliTracker(const SstConfig& config, const TrackerContext& context)
    : config_(config),
      dynamic_(config.add == "dynamic"),
      dt_(context.hop_seconds),
      own_share_(std::min(context.hop_seconds / kIndependent, 1.0)),
      diffuse_(1 / (4 * std::numbers::pi * context.heard_share)),
      model_(config),
      slots_(config.slots(), Source(Walker(context.hop_seconds))),
      candidates_(2 * context.potentials, Source(Walker(context.hop_seconds))),
      links_(slots_.size() + candidates_.size(), context.potentials),
      departed_(hops_in(static_cast<double>(config.memory), context.hop_seconds)) {
  heard_.reserve(context.potentials);
  first_refused_ = refused_ = first_targets_.assign(targets_of(config));
  targets_ = first_targets_;
}

void BernoulliTracker::set_targets(std::span<const Target> targets) noexcept {
  refused_ = targets_.assign(targets);
}

void BernoulliTracker::continue_from(const Tracker& before) noexcept {
  last_id_ = before.last_id();
  const auto* same = dynamic_cast<const BernoulliTracker*>(&before);
  if (same == nullptr || same->slots_.size() != slots_.size()) return;
  targets_ = same->targets_;
  refused_ = same->refused_;
  std::copy(same->slots_.begin(), same->slots_.end(), slots_.begin());
}

void BernoulliTracker::reset() noexcept {
  for (Source& source : slots_) clear(source);
  for (Source& source : candidates_) clear(source);
  last_id_ = 0;
  departed_.reset();
  targets_ = first_targets_;
  refused_ = first_refused_;
  waiting_ = 0;
}

void BernoulliTracker::clear(Source& source) noexcept {
  const Walker walker = source.walker;
  source = Source(walker);
}

void BernoulliTracker::update(std::span<const Potential> potentials, std::span<Track> tracks) noexcept {
  ODAS_EXPECT(tracks.size() == slots_.size());
  follow_targets();
  ODAS_EXPECT(potentials.size() <= links_.cols());
  model_.take(potentials, heard_);
  associate();
  for_each_live([&](Source& source, std::span<const Link> links) { follow(source, links); });
  departed_.age();
  if (dynamic_) {
    merge();
    bury();
    confirm();
    open();
  }
  for (std::size_t t = 0; t < slots_.size(); ++t) {
    const Source& source = slots_[t];
    tracks[t] = Track{};
    if (source.stage == Stage::free) continue;
    tracks[t] = {source.id, source.tag, source.walker.direction(), static_cast<float>(source.activity)};
    if (source.stage == Stage::seen) tracks[t].covariance = source.walker.covariance();
  }
}

template <class Action>
void BernoulliTracker::for_each_live(Action&& action) noexcept {
  std::size_t row = 0;
  for (auto* sources : {&slots_, &candidates_}) {
    for (Source& source : *sources) {
      const std::span<Link> links = links_[row++].first(heard_.size());
      if (source.stage != Stage::free) action(source, links);
    }
  }
}

void BernoulliTracker::follow_targets() noexcept {
  for (Source& source : slots_) {
    if (source.stage == Stage::target && targets_.find(source.tag) == nullptr) clear(source);
  }
  waiting_ = 0;
  const TangentCovariance spread{config_.sigma_r2_target, config_.sigma_r2_target, 0};
  for (const Target& target : targets_.view()) {
    const auto has_tag = [&](const Source& s) { return s.stage == Stage::target && s.tag == target.tag; };
    const auto own = std::find_if(slots_.begin(), slots_.end(), has_tag);
    if (own != slots_.end()) {
      if (own->walker.direction() != target.direction) own->walker.start(target.direction, spread);
    } else if (Source* slot = free_slot()) {
      slot->stage = Stage::target;
      slot->id = ++last_id_;
      slot->tag = target.tag;
      slot->walker.start(target.direction, spread);
    } else {
      ++waiting_;
    }
  }
}

void BernoulliTracker::associate() noexcept {
  for (Observation& heard : heard_) heard.others = diffuse_ * (1 + kNew * heard.old_ratio);
  for_each_live([&](Source& source, std::span<Link> links) {
    if (source.stage != Stage::target) source.walker.predict(source.silent_hops * dt_ < kGoesOn);
    const double off = std::min(dt_ / kFallsSilent, 0.5);
    const double on = std::min(dt_ / kSpeaks, 0.5);
    source.sounding += on * (1 - source.sounding) - off * source.sounding;
    for (std::size_t s = 0; s < heard_.size(); ++s) {
      Link& link = links[s];
      link.offset = source.walker.offset_of(heard_[s].direction);
      link.fit = source.walker.fit(link.offset, heard_[s].covariance);
      link.weight = source.sounding * kFound * heard_[s].old_ratio * link.fit.density;
      heard_[s].others += link.weight;
    }
  });
  for_each_live([&](Source& source, std::span<Link> links) {
    for (std::size_t s = 0; s < heard_.size(); ++s) {
      links[s].share = links[s].weight / heard_[s].others;
      heard_[s].known += links[s].share;
      if (source.stage == Stage::candidate) continue;
      heard_[s].seen += links[s].share;
      heard_[s].seen_fit += links[s].fit.density;
    }
  });
}

void BernoulliTracker::follow(Source& source, std::span<const Link> links) noexcept {
  double silent = 1;             // probability that no potential is its own
  double sounds = 1 - kFound;    // likelihood ratio: it sounds, to it does not
  double is_there = 1 - kFound;  // the same without what the place itself tells: reflections stay, too
  double leads = 1 - kFound;     // and of what nothing was louder than
  const bool is_candidate = source.stage == Stage::candidate;
  for (std::size_t s = 0; s < links.size(); ++s) {
    const Link& link = links[s];
    const Observation& heard = heard_[s];
    const double taken = is_candidate ? heard.seen : heard.seen - link.share;
    const double here = kFound * link.fit.density / link.fit.peak * std::clamp(1 - taken, 0.0, 1.0);
    silent *= 1 - link.share;
    sounds += kFound * heard.old_ratio * link.fit.density / (heard.others - link.weight);
    is_there += here * (is_candidate ? heard.new_ratio : heard.old_ratio);
    if (heard.leads) leads += here * heard.ratio;
    if (source.stage == Stage::target || link.share < 1e-3) continue;
    // What may be another's as well moves neither, whoever of them spoke last: where two meet the localizer
    // finds one direction, between them. They keep their ways until it can only be the one's.
    double sure = std::max(link.share - std::max(taken, 0.0), 0.0);
    if (!is_candidate) sure *= std::clamp(1 + kMine * (1 - heard.seen_fit / link.fit.density), 0.0, 1.0);
    // Of its height an observation tells as much as is usual here. By its own covariance the high ones would
    // count most, for near the plane of a flat array peaks are widest.
    TangentCovariance covariance = heard.covariance;
    covariance.north = source.blur.north;
    source.walker.observe(link.offset, covariance, own_share_ * sure * link.fit.clean * heard.pull);
    source.blur.east += 0.05F * static_cast<float>(link.share) * (heard.covariance.east - source.blur.east);
    source.blur.north +=
        0.05F * static_cast<float>(link.share) * (heard.covariance.north - source.blur.north);
  }
  if (source.stage != Stage::target) source.walker.settle();
  listen(source, links);
  source.activity = 1 - silent;
  const double before = is_candidate ? 1 : source.sounding;
  const double gain = own_share_ * std::log(1 - before + before * is_there);
  source.evidence = std::min(source.evidence + gain, kMost);
  source.strength += own_share_ * std::max(std::log(leads), 0.0);
  if (source.stage == Stage::seen) source.strength -= std::min(dt_ / kForgotten, 1.0) * source.strength;
  const double odds = std::log(std::max(source.sounding, 1e-9) / std::max(1 - source.sounding, 1e-9));
  source.sounding = std::clamp(sigmoid(odds + own_share_ * std::log(sounds)), 1e-3, 1 - 1e-3);
  source.silent_hops = source.sounding > 0.5 ? 0 : source.silent_hops + 1;
  ++source.age;
}

/// How much its loudness varies while it is heard.
void BernoulliTracker::listen(Source& source, std::span<const Link> links) const noexcept {
  constexpr double kOwn = 0.5;
  for (std::size_t s = 0; s < links.size(); ++s) {
    if (links[s].share < kOwn || heard_[s].loudness == 0) continue;
    source.heard_s = std::min(source.heard_s + dt_, kLoudness);
    const double step = dt_ / source.heard_s;
    const double change = heard_[s].loudness - source.loudness;
    source.loudness += step * change;
    source.loudness_variance += step * ((1 - step) * change * change - source.loudness_variance);
    break;
  }
}

/// What sounds for long and hardly swells is a machine.
bool BernoulliTracker::is_steady(const Source& source) noexcept {
  return source.heard_s >= kLoudness && source.loudness_variance < kSteady * kSteady;
}

/// Of two in one place the younger goes: at once if it is not seen yet, else when it has stayed too long for
/// somebody who walks past.
void BernoulliTracker::merge() noexcept {
  const auto covered = [&](const Source& source) {
    return std::any_of(slots_.begin(), slots_.end(), [&](const Source& older) {
      if (&older == &source || older.stage == Stage::free || older.age <= source.age) return false;
      return one_place(older.walker.offset_of(source.walker.direction()),
                       older.blur.north > source.blur.north ? older.blur : source.blur);
    });
  };
  for (Source& candidate : candidates_) {
    if (candidate.stage != Stage::free && covered(candidate)) clear(candidate);
  }
  for (std::size_t t = 0; t < slots_.size(); ++t) {
    Source& source = slots_[t];
    if (source.stage != Stage::seen) continue;
    source.covered_hops = covered(source) ? source.covered_hops + 1 : 0;
    const double limit = source.age * dt_ < kSoon ? kOverlap : kLongOverlap;
    if (source.covered_hops * dt_ > limit) clear(source);
  }
}

/// Of azimuth, to the nearest other track.
double BernoulliTracker::distance_to_others(const Source& source, const Source* but) const noexcept {
  double nearest = std::numbers::pi;
  for (const Source& other : slots_) {
    if (&other == &source || &other == but || other.stage == Stage::free) continue;
    nearest = std::min(nearest, azimuth_between(other.walker.direction(), source.walker.direction()));
  }
  return nearest;
}

/// Somebody walks past, and while they are in one place the louder one is heard.
bool BernoulliTracker::is_passed(const Source& source) const noexcept {
  constexpr double kSurely = 0.7;
  return std::any_of(slots_.begin(), slots_.end(), [&](const Source& other) {
    return &other != &source && other.stage == Stage::seen &&
           std::max(other.walker.walking(), source.walker.walking()) > kSurely &&
           azimuth_between(other.walker.direction(), source.walker.direction()) < kPasses;
  });
}

void BernoulliTracker::bury() noexcept {
  for (Source& candidate : candidates_) {
    if (candidate.stage != Stage::free && candidate.evidence < kGivenUp) clear(candidate);
  }
  const auto living = static_cast<std::size_t>(
      std::count_if(slots_.begin(), slots_.end(), [](const Source& s) { return s.stage != Stage::free; }));
  for (std::size_t t = 0; t < slots_.size(); ++t) {
    Source& source = slots_[t];
    if (source.stage != Stage::seen) continue;
    if (is_steady(source)) {
      departed_.add(source.id, source.walker.direction(), t);
      hide(source);
      continue;
    }
    // Near another it may be what is left of one that the other follows now.
    const double near = distance_to_others(source) / kAlone;
    const double alone = 1 - std::exp(-near * near);
    const double least = is_passed(source) ? kHidden : kPatience;
    const double earned = (least + kEarned * alone * source.strength) / std::max(dt_, 1e-6);
    const double patience = std::min(earned, static_cast<double>(config_.patience(living)));
    if (source.silent_hops < patience) continue;
    departed_.add(source.id, source.walker.direction(), t);
    clear(source);
  }
}

/// Goes on as a candidate, so that it is known where it sounds.
void BernoulliTracker::hide(Source& source) noexcept {
  const auto place = std::find_if(candidates_.begin(), candidates_.end(),
                                  [](const Source& s) { return s.stage == Stage::free; });
  if (place != candidates_.end()) {
    *place = source;
    place->stage = Stage::candidate;
    place->id = 0;
    place->tag = {};
  }
  clear(source);
}

/// A reflection is seldom louder than its talker, never for long, and mostly beside him: hops count that
/// nothing else led, and the nearer to a track the more of them it takes. But who walked on is not beside
/// himself.
void BernoulliTracker::confirm() noexcept {
  for (Source& candidate : candidates_) {
    if (candidate.stage == Stage::free || is_steady(candidate)) continue;
    Source* const before = walked_on(candidate);
    const double apart = distance_to_others(candidate, before);
    const double needed = kConfirmed + kBeside * std::exp(-apart / kReflects);
    const bool led = candidate.strength >= needed && candidate.evidence >= std::min(needed, kSure);
    if (led || (apart > kAlone && candidate.evidence >= kMost)) show(candidate, before);
  }
}

/// Somebody who fell silent as they walked, this way, and may be here by now.
BernoulliTracker::Source* BernoulliTracker::walked_on(const Source& candidate) noexcept {
  const auto is_it = [&](const Source& source) {
    const double silence = source.silent_hops * dt_;
    const double ahead = source.walker.offset_of(candidate.walker.direction()).east;
    return source.stage == Stage::seen && silence >= kPause && source.walker.walking() > 0.5 &&
           ahead * source.walker.turning() > 0 &&
           azimuth_between(source.walker.direction(), candidate.walker.direction()) <
               std::min(kSamePlace + kPace * silence, kFarthest);
  };
  const auto source = std::find_if(slots_.begin(), slots_.end(), is_it);
  return source == slots_.end() ? nullptr : &*source;
}

/// In the place of who walked on to here (`slot`); or else in its old slot, the channel where it is listened
/// for, if it is known and nobody else is there.
void BernoulliTracker::show(Source& candidate, Source* slot) noexcept {
  std::uint64_t id = 0;
  if (slot != nullptr) {
    id = slot->id;
    candidate.strength += slot->strength;
  } else {
    slot = free_slot();
    if (slot == nullptr) return;
    if (const auto known = departed_.nearest(candidate.walker.direction())) {
      const Departed::Source source = departed_.take(known->place);
      id = source.id;
      if (slots_[source.slot].stage == Stage::free) slot = &slots_[source.slot];
    }
  }
  *slot = candidate;
  slot->stage = Stage::seen;
  slot->tag = "dynamic";
  slot->id = id != 0 ? id : ++last_id_;
  clear(candidate);
}

void BernoulliTracker::open() noexcept {
  for (const Observation& heard : heard_) {
    if (heard.known > 0.5 || heard.new_ratio < std::exp(kOpens)) continue;
    const auto place = std::find_if(candidates_.begin(), candidates_.end(),
                                    [](const Source& s) { return s.stage == Stage::free; });
    if (place == candidates_.end()) return;
    // Not twice in one place.
    const bool is_there = std::any_of(candidates_.begin(), candidates_.end(), [&](const Source& s) {
      return s.stage != Stage::free && s.age == 0 &&
             one_place(s.walker.offset_of(heard.direction), heard.covariance);
    });
    if (is_there) continue;
    place->stage = Stage::candidate;
    place->sounding = 0.5;
    place->blur = heard.covariance;
    place->walker.start(heard.direction, heard.covariance);
  }
}

BernoulliTracker::Source* BernoulliTracker::free_slot() noexcept {
  const auto is_free = [](const Source& s) { return s.stage == Stage::free; };
  const auto slot = std::find_if(slots_.begin(), slots_.end(), is_free);
  return slot == slots_.end() ? nullptr : &*slot;
}

}  // namespace odas
