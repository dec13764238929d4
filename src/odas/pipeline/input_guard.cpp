// SPDX-License-Identifier: MIT
#include "odas/pipeline/input_guard.hpp"

#include <algorithm>
#include <cmath>

namespace odas {
namespace {

constexpr float kLoudest = 1e6F;

bool is_sane(float x) noexcept { return std::abs(x) <= kLoudest; }  // false for NaN

/// Without a branch in the loop, so that it costs next to nothing while all is well.
std::uint64_t count_insane(std::span<const float> x) noexcept {
  std::uint32_t count = 0;
  for (const float sample : x) count += is_sane(sample) ? 0U : 1U;
  return count;
}

}  // namespace

GridView<const float> InputGuard::pass(GridView<const float> hop) noexcept {
  std::uint64_t insane = 0;
  for (std::size_t m = 0; m < hop.rows(); ++m) insane += count_insane(hop[m]);
  if (insane == 0) return hop;
  refused_ += insane;
  for (std::size_t m = 0; m < hop.rows(); ++m) {
    std::transform(hop[m].begin(), hop[m].end(), clean_[m].begin(),
                   [](float x) { return is_sane(x) ? x : 0.F; });
  }
  return clean_;
}

}  // namespace odas
