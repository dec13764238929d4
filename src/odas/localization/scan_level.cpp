// SPDX-License-Identifier: MIT
#include "odas/localization/scan_level.hpp"

#include <algorithm>
#include <cmath>

namespace odas {

ScanLevel::ScanLevel(const GeneralConfig& config, const Directivity& directivity, std::span<const Pair> pairs,
                     int level, int interp_rate)
    : grid_(level),
      lags_(grid_.size(), pairs.size()),
      mask_(grid_.size(), pairs.size()),
      active_pairs_(grid_.size(), 0),
      min_lag_(pairs.size(), 0),
      max_lag_(pairs.size(), 0) {
  const float scale = static_cast<float>(config.samplerate.mu * interp_rate) / config.speedofsound.mu;
  std::vector<float> gains(config.mics.size());
  for (std::size_t u = 0; u < grid_.size(); ++u) {
    const Vec3 direction = grid_.points()[u];
    const float filter = directivity.filters(direction);
    for (std::size_t m = 0; m < gains.size(); ++m) gains[m] = directivity.mic(m, direction) * filter;
    for (std::size_t q = 0; q < pairs.size(); ++q) {
      const auto [i, j] = pairs[q];
      const Vec3 baseline = position(config.mics[i]) - position(config.mics[j]);
      const auto lag = static_cast<int>(std::lround(-scale * dot(baseline, direction)));
      lags_[u][q] = static_cast<std::int16_t>(lag);
      min_lag_[q] = u == 0 ? lag : std::min(min_lag_[q], lag);
      max_lag_[q] = u == 0 ? lag : std::max(max_lag_[q], lag);
      mask_[u][q] = gains[i] * gains[j] >= config.gain_min ? 1 : 0;
      active_pairs_[u] += mask_[u][q];
    }
    if (active_pairs_[u] > 0) active_points_.push_back(u);
  }
}

}  // namespace odas
