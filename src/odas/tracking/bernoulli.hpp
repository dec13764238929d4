// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "odas/base/grid.hpp"
#include "odas/tracking/config.hpp"
#include "odas/tracking/departed.hpp"
#include "odas/tracking/observation_model.hpp"
#include "odas/tracking/tracker.hpp"
#include "odas/tracking/walker.hpp"

namespace odas {

/// Follows talkers who come, walk, pause and cross: a labelled multi-Bernoulli filter.
///
/// Method: of each track the probability that it sounds is a Markov chain, and its place a `Walker`. Each
/// hop, potential s of evidence e_s (log likelihood ratio of a source against none) has the hypotheses: no
/// source D; a new one 0.02 exp(e_s) D; track t p_t exp(e_s) C_t(s), with D the density of a direction of
/// which nothing is known, C_t that of the track, p_t the probability that it sounds and is found. What no
/// track explains opens a candidate. Its evidence is summed from hop to hop (a sequential probability ratio
/// test), and its strength, which is that of the hops in which nothing elsewhere was louder: reflections
/// hardly have any. By its strength it is confirmed, the later the nearer it is to a track; chance runs out
/// before. Candidates are not seen and take no slot. A track dies after a silence, the sooner the less
/// strength it had of late and the nearer others are, and later while somebody walks past and hides it.
/// Of two that stay one on the other the younger goes. What has sounded for two seconds and hardly swells is
/// a machine: it is followed on, but as a candidate.
/// Symbols: evidence and covariance of `Potential`; where a localizer does not tell them, ln A(E) / I(E) of
/// the mixtures `sst.active` and `sst.inactive`, and `sst.sigmaR2_active`. Keys that count: nTracks,
/// N_inactive (longest patience), add, memory, target. Source: Reuter, Vo, Vo and Dietmayer, 2014 (LMB);
/// Musicki and Evans, 2004 (joint integrated PDA). Departs in that potentials are assigned each by itself
/// (two may come of one source, as after a reflection), and that the evidence of neighbouring hops, which
/// share their frames, counts for a share of its own. Cost per hop: (tracks + candidates) x potentials
/// exponentials. Delay: none. Fails: two talkers closer than the localizer parts become one.
class BernoulliTracker final : public Tracker {
 public:
  BernoulliTracker(const SstConfig& config, const TrackerContext& context);

  void update(std::span<const Potential> potentials, std::span<Track> tracks) noexcept override;
  void set_targets(std::span<const Target> targets) noexcept override;
  [[nodiscard]] std::size_t unfollowed_targets() const noexcept override { return refused_ + waiting_; }
  void continue_from(const Tracker& before) noexcept override;
  [[nodiscard]] std::uint64_t last_id() const noexcept override { return last_id_; }
  void reset() noexcept override;

 private:
  enum class Stage : std::uint8_t { free, candidate, seen, target };
  struct Source {
    explicit Source(Walker w) : walker(w) {}
    Stage stage = Stage::free;
    std::uint64_t id = 0;
    ShortString<63> tag{};
    Walker walker;
    double sounding = 0;       // probability, by the chain
    double activity = 0;       // probability that a potential of this hop is its own
    double evidence = 0;       // that it is there; natural logarithm
    double strength = 0;       // evidence of hops in which nothing else was louder
    TangentCovariance blur{};  // of its observations, of late
    // Of ln E of its observations, as long as it was heard, over kLoudness at most.
    double heard_s = 0, loudness = 0, loudness_variance = 0;
    int age = 0;  // hops
    int silent_hops = 0;
    int covered_hops = 0;  // in which an older one stood in the same place
  };
  /// Of a source and a potential.
  struct Link {
    Walker::Offset offset{};
    Walker::Fit fit{};
    double weight = 0;  // of the hypothesis that the one comes of the other
    double share = 0;   // its probability
  };

  template <class Action>
  void for_each_live(Action&& action) noexcept;  // action(source, its links)
  void follow_targets() noexcept;
  void associate() noexcept;
  void follow(Source& source, std::span<const Link> links) noexcept;
  void listen(Source& source, std::span<const Link> links) const noexcept;
  [[nodiscard]] static bool is_steady(const Source& source) noexcept;
  void merge() noexcept;
  [[nodiscard]] double distance_to_others(const Source& source, const Source* but = nullptr) const noexcept;
  [[nodiscard]] bool is_passed(const Source& source) const noexcept;
  void bury() noexcept;
  void hide(Source& source) noexcept;
  void confirm() noexcept;
  [[nodiscard]] Source* walked_on(const Source& candidate) noexcept;
  void show(Source& candidate, Source* slot) noexcept;
  void open() noexcept;
  [[nodiscard]] Source* free_slot() noexcept;
  static void clear(Source& source) noexcept;

  SstConfig config_;
  bool dynamic_;
  double dt_, own_share_, diffuse_;
  ObservationModel model_;
  std::vector<Source> slots_, candidates_;
  std::vector<Observation> heard_;  // of this hop; as many as are sound
  Grid<Link> links_;                // [slots, then candidates][potential]
  std::uint64_t last_id_ = 0;
  Departed departed_;
  TargetList first_targets_, targets_;
  std::size_t first_refused_ = 0, refused_ = 0;  // targets at fault
  std::size_t waiting_ = 0;                      // targets without a slot
};

}  // namespace odas
