// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "odas/dsp/echo_canceller.hpp"
#include "odas/dsp/resampler.hpp"
#include "odas/engine/config.hpp"
#include "odas/engine/input_health.hpp"

namespace odas {

/// From the blocks of a source to the hops of the pipeline: picks the microphones among the channels (0 is
/// silence), watches their health, brings them to the processing rate and hop size, and takes out of them
/// what the machine itself plays, where `mapping.reference` tells.
class FrontEnd {
 public:
  /// `channels` of the source. Throws ConfigError where the map asks for a channel that is not there.
  FrontEnd(const Configuration& config, std::size_t channels, int source_rate);

  /// Takes [channel][at most raw.hopSize]; then pop all hops.
  void push(GridView<const float> block) noexcept;
  /// Gives [mic][hop].
  [[nodiscard]] bool pop(GridView<float> hop) noexcept;

  /// The input has ended: what is still held back can be popped, and then, with `pop_rest`, a last hop that
  /// is filled up with silence. False where nothing is left.
  void finish() noexcept;
  [[nodiscard]] bool pop_rest(GridView<float> hop) noexcept;

  [[nodiscard]] std::size_t mics() const noexcept { return mics_; }
  [[nodiscard]] std::size_t block_size() const noexcept { return mapped_.cols(); }
  [[nodiscard]] InputHealth& health() noexcept { return health_; }
  /// Samples that were not finite and were replaced by silence here, before a filter could smear them.
  [[nodiscard]] std::uint64_t non_finite_samples() const noexcept { return non_finite_; }
  /// EchoCanceller::return_loss_db; 0 where nothing is known of what the machine plays.
  [[nodiscard]] double echo_return_loss_db() const noexcept {
    return canceller_ ? canceller_->return_loss_db() : 0;
  }

 private:
  static constexpr std::size_t kSilence = static_cast<std::size_t>(-1);

  void clean(GridView<float> hop) noexcept;

  std::size_t mics_;
  std::vector<std::size_t> map_;  // [mic, then reference]: channel, from 0, or kSilence
  bool resamples_;
  Grid<float> mapped_;  // [mic, then reference][raw hop]
  InputHealth health_;
  Resampler resampler_;
  Grid<float> resampled_;  // [mic, then reference][hop], where there is a reference
  std::optional<EchoCanceller> canceller_;
  std::uint64_t non_finite_ = 0;
};

}  // namespace odas
