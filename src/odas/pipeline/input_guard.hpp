// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "odas/array/types.hpp"

namespace odas {

/// Keeps samples out that no microphone can have meant: NaN, infinities, and values so far over full scale
/// (120 dB) that their powers would overflow. They count as silence, so that they never reach any state.
class InputGuard {
 public:
  InputGuard(std::size_t channels, std::size_t hop_size) : clean_(channels, hop_size) {}

  /// The hop [mic][hop] itself where all is well, else a mended copy that holds until the next call.
  [[nodiscard]] GridView<const float> pass(GridView<const float> hop) noexcept;

  /// Samples refused since the start.
  [[nodiscard]] std::uint64_t refused() const noexcept { return refused_; }
  void reset() noexcept { refused_ = 0; }

 private:
  Grid<float> clean_;
  std::uint64_t refused_ = 0;
};

}  // namespace odas
