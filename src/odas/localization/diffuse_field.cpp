// SPDX-License-Identifier: MIT
#include "odas/localization/diffuse_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odas {
namespace {

bool all_open(const GeneralConfig& general) {
  return std::all_of(general.mics.begin(), general.mics.end(), is_omni);
}

double sinc(double x) { return x < 1e-6 ? 1 : std::sin(x) / x; }

}  // namespace

DiffuseField::DiffuseField(const GeneralConfig& general, std::span<const Pair> pairs, const LagTable& table,
                           float bin_hz) {
  constexpr float kSame = 0.05F;  // of the distance: sinc changes by as little
  if (!all_open(general)) return;
  std::vector<float> distances;
  for (const auto& [i, j] : pairs) {
    const float d = norm(position(general.mics[i]) - position(general.mics[j]));
    const auto same = std::find_if(distances.begin(), distances.end(),
                                   [d](float other) { return std::abs(d - other) <= kSame * other; });
    class_.push_back(static_cast<std::size_t>(same - distances.begin()));
    if (same == distances.end()) distances.push_back(d);
  }
  re_ = Grid<float>(1 + distances.size(), padded(table.bins()));
  im_ = Grid<float>(re_.rows(), re_.cols());
  patterns_ = Grid<float>(distances.size(), 2 * table.half_lags() + 1);
  for (std::size_t c = 0; c < distances.size(); ++c) {
    products_.push_back({0, 1 + c});
    for (std::size_t k = 0; k < table.bins(); ++k) {
      const double f = static_cast<double>(k) * static_cast<double>(bin_hz);
      const double wave_number = 2 * std::numbers::pi * f / static_cast<double>(general.speedofsound.mu);
      re_[1 + c][k] = static_cast<float>(sinc(wave_number * static_cast<double>(distances[c])));
    }
  }
}

void DiffuseField::subtract(std::span<const float> share, const LagTable& table,
                            std::span<const std::uint16_t> bins, std::span<float> scratch,
                            GridView<float> correlations) noexcept {
  if (class_.empty()) return;
  std::copy(share.begin(), share.end(), re_[0].begin());
  lag_products(re_, im_, products_, table, bins, scratch, patterns_);
  for (std::size_t q = 0; q < class_.size(); ++q) {
    float* x = correlations[q].data();
    const float* pattern = patterns_[class_[q]].data();
    for (std::size_t n = 0; n < patterns_.cols(); ++n) x[n] -= pattern[n];
  }
}

}  // namespace odas
