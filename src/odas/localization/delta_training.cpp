// SPDX-License-Identifier: MIT
#include "odas/localization/delta_training.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace odas {
namespace {

/// erf, and without the call where it is 1 to the last bit of a float.
float erf(float x) noexcept {
  constexpr float kSaturated = 4;
  if (std::abs(x) < kSaturated) return std::erf(x);
  return std::copysign(1.F, x);
}

class Training {
 public:
  Training(const GeneralConfig& general, const SslConfig& ssl, const ScanLevel& level,
           std::span<const Pair> pairs)
      : level_(level),
        pairs_(pairs),
        patch_size_(SpherePatch(ssl.n_refined_levels).size()),
        x_(level.active_points().size() * patch_size_),
        y_(x_.size()),
        z_(x_.size()),
        mean_(patch_size_),
        scale_(patch_size_),
        high_(patch_size_),
        low_(patch_size_),
        probability_(patch_size_),
        covered_(x_.size(), 0.F),
        area_(pairs.size(), 1.F),
        delta_(pairs.size(), 0) {
    const float r = static_cast<float>(ssl.interp_rate);
    const float rate = static_cast<float>(general.samplerate.mu);
    const float c = general.speedofsound.mu;
    rate_ = rate * r;
    speed_ = c;
    middle_ = static_cast<float>(ssl.interp_rate * general.size.frame_size / 2);
    per_metre_ = rate_ / c;
    speed_variance_ = rate_ * rate_ * general.speedofsound.sigma2 / (c * c * c * c);
    for (const Pair& pair : pairs) {
      baselines_.push_back(position(general.mics[pair.i]) - position(general.mics[pair.j]));
      auto& sum = position_variances_.emplace_back();
      for (std::size_t k = 0; k < sum.size(); ++k) {
        sum[k] = general.mics[pair.i].sigma2[k] + general.mics[pair.j].sigma2[k];
      }
    }
    const SpherePatch patch(ssl.n_refined_levels);
    std::vector<Vec3> directions(patch_size_);
    for (std::size_t a = 0; a < level.active_points().size(); ++a) {
      const std::size_t u = level.active_points()[a];
      patch.place(level.grid().points()[u], level.grid().points()[level.grid().nearest(u)], directions);
      for (std::size_t f = 0; f < patch_size_; ++f) {
        x_[a * patch_size_ + f] = directions[f].x;
        y_[a * patch_size_ + f] = directions[f].y;
        z_[a * patch_size_ + f] = directions[f].z;
      }
    }
    for (std::size_t q = 0; q < pairs.size(); ++q) cover(q, -1, 0);
  }

  std::vector<int> run(float prob_min) {
    while (score() < prob_min) {
      // Of the pairs that can still grow, the one that covers least (the first of equals).
      std::size_t worst = pairs_.size();
      for (std::size_t q = 0; q < pairs_.size(); ++q) {
        if (area_[q] < kFullyCovered && (worst == pairs_.size() || area_[q] < area_[worst])) worst = q;
      }
      if (worst == pairs_.size()) break;
      cover(worst, delta_[worst], delta_[worst] + 1);
      ++delta_[worst];
    }
    return delta_;
  }

 private:
  static constexpr float kFullyCovered = 0.99999F;

  /// The delays of pair `q` from the patch of active point `a`, in interpolated samples.
  void delays(std::size_t q, std::size_t a) noexcept {
    const Vec3 b = baselines_[q];
    const auto& s = position_variances_[q];
    const float* x = x_.data() + a * patch_size_;
    const float* y = y_.data() + a * patch_size_;
    const float* z = z_.data() + a * patch_size_;
    for (std::size_t f = 0; f < patch_size_; ++f) {
      const float d = b.x * x[f] + b.y * y[f] + b.z * z[f];
      const float placement = x[f] * (s[0] * x[f] + s[1] * y[f] + s[2] * z[f]) +
                              y[f] * (s[3] * x[f] + s[4] * y[f] + s[5] * z[f]) +
                              z[f] * (s[6] * x[f] + s[7] * y[f] + s[8] * z[f]);
      const float variance = per_metre_ * per_metre_ * placement + d * d * speed_variance_;
      mean_[f] = -rate_ * d / speed_ + middle_;
      scale_[f] = std::sqrt(2 * variance);
    }
  }

  /// Probability of each of these delays to lie within lag +- (delta + 1/2), in `probability_`.
  void probabilities(int lag, int delta) noexcept {
    const float half = static_cast<float>(delta) + 0.5F;
    const float high = static_cast<float>(lag) + middle_ + half;
    const float low = static_cast<float>(lag) + middle_ - half;
    for (std::size_t f = 0; f < patch_size_; ++f) {
      high_[f] = (high - mean_[f]) / scale_[f];
      low_[f] = (low - mean_[f]) / scale_[f];
    }
    for (std::size_t f = 0; f < patch_size_; ++f) probability_[f] = 0.5F * (erf(high_[f]) - erf(low_[f]));
  }

  /// Takes pair `q` from one delta to another (from -1: it counted for nothing so far).
  void cover(std::size_t q, int from, int to) noexcept {
    float sum = 0;
    std::size_t count = 0;
    for (std::size_t a = 0; a < level_.active_points().size(); ++a) {
      const std::size_t u = level_.active_points()[a];
      if (level_.mask(u)[q] == 0) continue;
      const int lag = level_.lags(u)[q];
      float* covered = covered_.data() + a * patch_size_;
      delays(q, a);
      if (from >= 0) {
        probabilities(lag, from);
        for (std::size_t f = 0; f < patch_size_; ++f) covered[f] -= probability_[f];
      }
      probabilities(lag, to);
      for (std::size_t f = 0; f < patch_size_; ++f) {
        covered[f] += probability_[f];
        sum += probability_[f];
      }
      count += patch_size_;
    }
    area_[q] = count > 0 ? sum / static_cast<float>(count) : 1.F;
  }

  /// How well the worst direction of the worst point is covered.
  [[nodiscard]] float score() const noexcept {
    float worst = std::numeric_limits<float>::infinity();
    for (std::size_t a = 0; a < level_.active_points().size(); ++a) {
      const auto first = covered_.begin() + static_cast<std::ptrdiff_t>(a * patch_size_);
      const float least = *std::min_element(first, first + static_cast<std::ptrdiff_t>(patch_size_));
      worst = std::min(worst, least / static_cast<float>(level_.active_pairs(level_.active_points()[a])));
    }
    return worst;
  }

  const ScanLevel& level_;
  std::span<const Pair> pairs_;
  std::size_t patch_size_;
  std::vector<float> x_, y_, z_;  // [active point x patch]: the directions, so that loops become vectors
  // [patch]: the delays of one pair, counted from the middle of ODAS's array of lags on (pairs that mirror
  // each other tie, and the rounding that this costs decides which of them grows first); the bounds of its
  // window in units of sqrt(2) sigma; its probability to lie between them.
  std::vector<float> mean_, scale_, high_, low_, probability_;
  std::vector<float> covered_;  // [active point x patch]: sum over pairs of the probability
  std::vector<float> area_;     // [pair]: mean probability
  std::vector<int> delta_;      // [pair]
  std::vector<Vec3> baselines_;
  std::vector<std::array<float, 9>> position_variances_;
  float rate_ = 0;            // samples per second, interpolated
  float speed_ = 0;           // of sound
  float middle_ = 0;          // lag 0 in ODAS's array of lags
  float per_metre_ = 0;       // samples
  float speed_variance_ = 0;  // of the delay, per metre squared
};

}  // namespace

std::vector<int> train_deltas(const GeneralConfig& general, const SslConfig& ssl, const ScanLevel& level,
                              std::span<const Pair> pairs) {
  return Training(general, ssl, level, pairs).run(ssl.prob_min);
}

}  // namespace odas
