// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace odas {

/// How often potentials had which energy E, in steps of a thousandth: what mixtures are fitted to, and what
/// is drawn. E outside of its range counts at the border; what is not finite does not count.
class EnergyHistogram {
 public:
  static constexpr double kLow = -0.25, kWidth = 0.001;
  static constexpr std::size_t kBins = 1500;

  void add(double energy, double times = 1) noexcept {
    if (!std::isfinite(energy)) return;
    const double bin = std::fmin(std::fmax((energy - kLow) / kWidth, 0), kBins - 1);
    counts_[static_cast<std::size_t>(bin)] += times;
    total_ += times;
  }
  void add(const EnergyHistogram& other, double times = 1) noexcept {
    for (std::size_t bin = 0; bin < kBins; ++bin) counts_[bin] += times * other.counts_[bin];
    total_ += times * other.total_;
  }

  /// E in the middle of a bin.
  [[nodiscard]] static constexpr double energy(std::size_t bin) noexcept {
    return kLow + kWidth * (static_cast<double>(bin) + 0.5);
  }
  [[nodiscard]] double count(std::size_t bin) const noexcept { return counts_[bin]; }
  [[nodiscard]] double total() const noexcept { return total_; }
  /// The E below which this share of all lies; 0 where nothing was added.
  [[nodiscard]] double quantile(double share) const noexcept {
    double sum = 0;
    for (std::size_t bin = 0; bin < kBins && total_ > 0; ++bin) {
      sum += counts_[bin];
      if (sum > 0 && sum >= share * total_) return energy(bin);
    }
    return 0;
  }

 private:
  std::array<double, kBins> counts_{};
  double total_ = 0;
};

}  // namespace odas
