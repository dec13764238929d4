// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>

#include "odas/array/types.hpp"
#include "odas/pipeline/config.hpp"
#include "odas/pipeline/stage_watch.hpp"
#include "odas/separation/beam_report.hpp"
#include "odas/tracking/target.hpp"

namespace odas {

/// What one hop gave. The views hold until the next hop.
struct HopResult {
  HopIndex time = 0;
  std::span<const Potential> potentials;  // strongest first found first; empty where nobody wants them
  std::span<const Track> tracks;          // [slot]
  // Of the sound `lookback_hops` hops ago, with the tracks of now:
  GridView<const float> separated;     // [slot][hop], full scale 1, processing rate, before gain_sep
  GridView<const float> postfiltered;  // [slot][hop], before gain_pf
  // Of the hop itself, where expressly asked for:
  GridView<const float> mics{};           // [mic][hop]
  std::span<const float> power{};         // [direction of Pipeline::power_grid], E
  std::span<const BeamReport> reports{};  // [slot]: how well separation goes, ten times a second or so
};

/// The whole of hearing, one hop at a time: microphones in, directions, tracks and voices out.
///
/// Shapes: `mics` is [mic][hop] at `general.samplerate.mu`, full scale 1.
/// Delay: separated audio is `voice_delay_s` behind the microphones: `separation_frame - hop_size` samples,
/// and `sss.lookback`. Potentials and tracks are of the hop itself. Errors: the constructor throws
/// ConfigError. A non-finite sample counts as silence and is counted.
class Pipeline {
 public:
  explicit Pipeline(const PipelineConfig& config);
  ~Pipeline();
  Pipeline(Pipeline&&) noexcept;
  Pipeline& operator=(Pipeline&&) noexcept;

  /// Allocates nothing, locks nothing, waits for nobody.
  HopResult process_hop(GridView<const float> mics) noexcept;

  /// `time` goes on by `hops` that are not there: the source has lost them.
  void skip_hops(HopIndex hops) noexcept;

  /// From the next hop on, the fixed directions are these, in place of those of `sst.target` or of an earlier
  /// call (`Tracker::set_targets`). Between hops only, on the thread that calls `process_hop`.
  void set_targets(std::span<const Target> targets) noexcept;
  /// From the next hop on nobody but targets is heard in these directions (Muting). On the same thread.
  void set_muted(std::span<const Target> directions) noexcept;
  /// Targets that are not followed as of the last hop, for want of a slot or for a fault of theirs.
  [[nodiscard]] std::size_t unfollowed_targets() const noexcept;

  /// Whether it can take the place of `before` between two hops: all that goes in and out has the same shape
  /// and the same delay.
  [[nodiscard]] bool can_continue(const Pipeline& before) const noexcept;
  /// Takes the place of `before`, which must not be used again: time, sound on its way, tracks, targets and
  /// muted directions go on; only what the configurations say otherwise is otherwise. Allocates nothing.
  void continue_from(Pipeline& before) noexcept;

  /// From the next hop on, times of the stages are taken by `clock`, which is read within the hop; nullptr:
  /// they are not.
  void time_stages(StageWatch::Clock clock) noexcept;
  /// Of all hops so far, those of a pipeline whose place it took as well.
  [[nodiscard]] const StageTimes& stage_times() const noexcept;

  /// The state after construction, exactly; but for the times of the stages, which go on.
  void reset() noexcept;

  [[nodiscard]] std::size_t mics() const noexcept;
  [[nodiscard]] std::size_t hop_size() const noexcept;
  [[nodiscard]] std::size_t slots() const noexcept;
  [[nodiscard]] int sample_rate() const noexcept;
  /// The directions of `HopResult::power`; empty where nobody wants it.
  [[nodiscard]] std::span<const Vec3> power_grid() const noexcept;
  /// Hops by which separated audio comes later than potentials and tracks; 0 where there is no such audio.
  [[nodiscard]] std::size_t lookback_hops() const noexcept;

  /// Samples that were not finite since the start, and were taken as silence.
  [[nodiscard]] std::uint64_t non_finite_samples() const noexcept;

  /// What `odas check` shows of the plan.
  struct Plan {
    std::size_t pairs = 0;       // all pairs of microphones
    std::size_t pairs_used = 0;  // those that hear at least one common direction
    struct Scan {
      int level = 0;
      std::size_t points = 0;         // directions of the grid
      std::size_t active_points = 0;  // those that at least one pair hears
    };
    std::vector<Scan> scans;
    std::size_t lags = 0;          // of each cross-correlation, after interpolation
    bool half_sphere = false;      // found by itself, the array being flat
    double transform_ms = 0;       // delay of the separated audio: by the overlap of the frames
    double lookback_ms = 0;        // and by the look-back
    std::size_t memory_bytes = 0;  // tables and states, about
  };
  [[nodiscard]] Plan plan() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace odas
