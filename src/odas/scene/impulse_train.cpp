// SPDX-License-Identifier: MIT
#include "odas/scene/impulse_train.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "odas/base/contract.hpp"
#include "odas/scene/delay_filter.hpp"

namespace odas {
namespace {

constexpr std::size_t kWidth = ImpulseTrain::kOver * DelayFilter::kTaps;  // grid points that a sample hears
constexpr std::size_t kBefore = kWidth / 2;                               // of them before the sample itself
constexpr std::size_t kLanes = 8;

}  // namespace

ImpulseTrain::ImpulseTrain(std::size_t samples) : kernel_(kWidth), grid_(kOver * samples + kWidth + 4) {
  for (std::size_t i = 0; i < kWidth; ++i) {
    const double t = (static_cast<double>(i) - static_cast<double>(kBefore)) / kOver;  // samples
    const double x = std::numbers::pi * t;
    const double sinc = i == kBefore ? 1 : std::sin(x) / x;
    kernel_[i] = static_cast<float>(sinc * (0.5 + 0.5 * std::cos(2 * x / DelayFilter::kTaps)));
  }
}

void ImpulseTrain::clear() noexcept { std::fill(grid_.begin(), grid_.end(), 0.F); }

void ImpulseTrain::add(float delay, float gain) noexcept {
  // The grid begins kBefore points before the first sample.
  const float place = delay * static_cast<float>(kOver);
  const auto whole = static_cast<std::size_t>(place);
  const std::size_t first = whole + kBefore - 1;
  if (first + 4 > grid_.size()) return;
  const float f = place - static_cast<float>(whole);
  const float a = f + 1, b = f - 1, c = f - 2;
  float* at = grid_.data() + first;
  at[0] -= gain * f * b * c * (1 / 6.F);
  at[1] += gain * a * b * c * 0.5F;
  at[2] -= gain * a * f * c * 0.5F;
  at[3] += gain * a * f * b * (1 / 6.F);
}

void ImpulseTrain::render(std::span<float> response) const noexcept {
  ODAS_EXPECT(response.size() * kOver + kWidth + 4 == grid_.size());
  for (std::size_t n = 0; n < response.size(); ++n) {
    const float* from = grid_.data() + n * kOver;
    std::array<float, kLanes> sums{};  // side by side, so that the compiler may take them together
    for (std::size_t i = 0; i < kWidth; i += kLanes) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) sums[lane] += kernel_[i + lane] * from[i + lane];
    }
    for (const float sum : sums) response[n] += sum;
  }
}

}  // namespace odas
