// SPDX-License-Identifier: MIT
#include "odas/scene/delay_filter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odas {

DelayFilter::DelayFilter() : table_((kPhases + 1) * kTaps) {
  constexpr double kPi = std::numbers::pi;
  for (std::size_t phase = 0; phase <= kPhases; ++phase) {
    const double fraction = static_cast<double>(phase) / kPhases;
    for (std::size_t tap = 0; tap < kTaps; ++tap) {
      const double t = static_cast<double>(tap) - static_cast<double>(kBefore) - fraction;
      const double sinc = std::abs(t) < 1e-9 ? 1 : std::sin(kPi * t) / (kPi * t);
      const double hann = std::abs(t) < kTaps / 2.0 ? 0.5 + 0.5 * std::cos(2 * kPi * t / kTaps) : 0;
      table_[phase * kTaps + tap] = static_cast<float>(sinc * hann);
    }
  }
}

void DelayFilter::add(float delay, float gain, std::span<float> response) const noexcept {
  const float whole = std::floor(delay);
  const float position = (delay - whole) * static_cast<float>(kPhases);
  const auto phase = std::min(static_cast<std::size_t>(position), kPhases - 1);
  const float share = position - static_cast<float>(phase);
  const float* a = table_.data() + phase * kTaps;
  const float* b = a + kTaps;
  const auto first = static_cast<std::ptrdiff_t>(whole) - static_cast<std::ptrdiff_t>(kBefore);
  const auto size = static_cast<std::ptrdiff_t>(response.size());
  const float gain_a = gain * (1 - share);
  const float gain_b = gain * share;
  if (first >= 0 && first + static_cast<std::ptrdiff_t>(kTaps) <= size) {
    float* out = response.data() + first;
    for (std::size_t tap = 0; tap < kTaps; ++tap) out[tap] += gain_a * a[tap] + gain_b * b[tap];
    return;
  }
  for (std::size_t tap = 0; tap < kTaps; ++tap) {
    const auto at = first + static_cast<std::ptrdiff_t>(tap);
    if (at >= 0 && at < size) response[static_cast<std::size_t>(at)] += gain_a * a[tap] + gain_b * b[tap];
  }
}

}  // namespace odas
