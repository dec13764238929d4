// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "odas/dsp/resampler.hpp"
#include "odas/engine/config.hpp"
#include "odas/engine/input_health.hpp"

namespace odas {

/// From the blocks of a source to the hops of the pipeline: picks the microphones among the channels (0 is
/// silence), watches their health, and brings them to the processing rate and hop size.
class FrontEnd {
 public:
  /// `channels` of the source. Throws ConfigError where the map asks for a channel that is not there.
  FrontEnd(const Configuration& config, std::size_t channels, int source_rate);

  /// Takes [channel][at most raw.hopSize]; then pop all hops.
  void push(GridView<const float> block) noexcept;
  /// Gives [mic][hop].
  [[nodiscard]] bool pop(GridView<float> hop) noexcept { return resampler_.pop(hop); }

  /// The input has ended: what is still held back can be popped, and then, with `pop_rest`, a last hop that
  /// is filled up with silence. False where nothing is left.
  void finish() noexcept;
  [[nodiscard]] bool pop_rest(GridView<float> hop) noexcept { return resampler_.pop_rest(hop) > 0; }

  [[nodiscard]] std::size_t mics() const noexcept { return map_.size(); }
  [[nodiscard]] std::size_t block_size() const noexcept { return mapped_.cols(); }
  [[nodiscard]] InputHealth& health() noexcept { return health_; }
  /// Samples that were not finite and were replaced by silence here, before a filter could smear them.
  [[nodiscard]] std::uint64_t non_finite_samples() const noexcept { return non_finite_; }

 private:
  static constexpr std::size_t kSilence = static_cast<std::size_t>(-1);

  std::vector<std::size_t> map_;  // [mic]: channel, from 0, or kSilence
  bool resamples_;
  Grid<float> mapped_;  // [mic][raw hop]
  InputHealth health_;
  Resampler resampler_;
  std::uint64_t non_finite_ = 0;
};

}  // namespace odas
