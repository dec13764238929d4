// SPDX-License-Identifier: MIT
#include "odas/localization/links.hpp"

#include <algorithm>
#include <cstdint>

namespace odas {
namespace {

/// The window [left, right] of lags of each pair at a point; empty, and far off, where the pair is deaf.
class Windows {
 public:
  Windows(const ScanLevel& level, std::span<const int> deltas, std::int16_t deaf)
      : left_(level.active_points().size(), level.pairs()), right_(left_.rows(), left_.cols()) {
    for (std::size_t a = 0; a < left_.rows(); ++a) {
      const std::size_t u = level.active_points()[a];
      for (std::size_t q = 0; q < left_.cols(); ++q) {
        const bool hears = level.mask(u)[q] != 0;
        const int lag = level.lags(u)[q];
        left_[a][q] = hears ? static_cast<std::int16_t>(lag - deltas[q]) : deaf;
        right_[a][q] =
            hears ? static_cast<std::int16_t>(lag + deltas[q]) : static_cast<std::int16_t>(deaf - 1);
      }
    }
  }
  [[nodiscard]] std::size_t points() const noexcept { return left_.rows(); }
  [[nodiscard]] std::span<const std::int16_t> left(std::size_t a) const noexcept { return left_[a]; }
  [[nodiscard]] std::span<const std::int16_t> right(std::size_t a) const noexcept { return right_[a]; }

 private:
  Grid<std::int16_t> left_, right_;  // [active point][pair]
};

/// Lags that both points' windows share, summed over pairs.
int overlap(const Windows& a, std::size_t pa, const Windows& b, std::size_t pb) noexcept {
  const std::int16_t* al = a.left(pa).data();
  const std::int16_t* ar = a.right(pa).data();
  const std::int16_t* bl = b.left(pb).data();
  const std::int16_t* br = b.right(pb).data();
  const std::size_t pairs = a.left(pa).size();
  int sum = 0;
  for (std::size_t q = 0; q < pairs; ++q) {
    const int shared = std::min(ar[q], br[q]) - std::max(al[q], bl[q]) + 1;
    sum += std::max(shared, 0);
  }
  return sum;
}

std::size_t nearest_active(const ScanLevel& level, Vec3 direction) noexcept {
  std::size_t best = level.active_points().front();
  for (const std::size_t u : level.active_points()) {
    if (dot(level.grid().points()[u], direction) > dot(level.grid().points()[best], direction)) best = u;
  }
  return best;
}

}  // namespace

std::vector<std::vector<std::size_t>> link_levels(const ScanLevel& coarse, std::span<const int> coarse_deltas,
                                                  const ScanLevel& fine, std::span<const int> fine_deltas,
                                                  int matches) {
  std::vector<std::vector<std::size_t>> links(coarse.grid().size());
  if (coarse.active_points().empty()) return links;
  // Where a pair is deaf its window lies beyond all others, on different sides for the two levels.
  const Windows coarse_windows(coarse, coarse_deltas, 16000);
  const Windows fine_windows(fine, fine_deltas, -16000);
  std::vector<int> scores(coarse_windows.points());
  for (std::size_t f = 0; f < fine_windows.points(); ++f) {
    const std::size_t fine_point = fine.active_points()[f];
    for (std::size_t c = 0; c < scores.size(); ++c) scores[c] = overlap(coarse_windows, c, fine_windows, f);
    int linked = 0;
    for (; linked < matches; ++linked) {
      const auto best = std::max_element(scores.begin(), scores.end());
      if (*best <= 0) break;
      *best = 0;
      links[coarse.active_points()[static_cast<std::size_t>(best - scores.begin())]].push_back(fine_point);
    }
    if (linked == 0) links[nearest_active(coarse, fine.grid().points()[fine_point])].push_back(fine_point);
  }
  return links;
}

}  // namespace odas
