// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "odas/classification/classifier.hpp"
#include "odas/classification/config.hpp"
#include "odas/classification/pitch.hpp"

namespace odas {

/// Speech is voiced, and its pitch moves: a hum has a pitch that stands, and noise has none.
///
/// Method, per slot and hop: t: pitch period of the last frame (PitchDetector), d = t - t_prev;
///   slope s <- (1 - alpha) s + alpha d where |d| and |d_prev| are under deltaTauMax, s = d where only |d|
///   is, else 0; v = 1 if tauMin <= t <= tauMax and |s| > phiMin, else 0; r <- (1 - gamma) r + gamma v;
///   speech while r > r0.
/// Source: ODAS 10. Departs (fault B18): the answer is that of now, not that of the first moment that
///   looked like speech; an empty slot is `undefined`, and not what the one before was; only live slots are
///   computed; noise without a pitch is not speech (`voicingMin`).
/// Shapes: see Classifier. Delay: half a frame, and 1 / gamma hops to make up its mind.
/// Cost per hop: two transforms of a frame for each live slot.
/// Errors: throws ConfigError where the frame is odd, less than a hop or less than what the peak test needs.
/// Fails: whispering is not speech; a gliding siren is.
class PitchClassifier final : public Classifier {
 public:
  PitchClassifier(const ClassifyConfig& config, std::size_t hop_size, std::size_t slots);

  void classify(GridView<const float> separated, std::span<Track> tracks) noexcept override;
  void reset() noexcept override;

 private:
  struct Slot {
    std::uint64_t id = 0;
    std::vector<float> frame;  // the last N samples
    std::size_t heard = 0;     // how many of them are sound
    float period = 0;          // t; 0: none
    float step = 0;            // d
    float slope = 0;           // s
    float voiced_share = 0;    // r
  };

  void forget(Slot& slot) noexcept;
  void listen(Slot& slot, std::span<const float> hop) noexcept;
  void follow_pitch(Slot& slot, float period) const noexcept;

  ClassifyConfig config_;
  std::size_t hop_size_;
  PitchDetector detector_;
  std::vector<Slot> slots_;
};

}  // namespace odas
