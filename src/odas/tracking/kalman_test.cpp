// SPDX-License-Identifier: MIT
#include "odas/tracking/kalman.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "support/plane_wave.hpp"
#include <gtest/gtest.h>

namespace odas::kalman_test {
namespace {

constexpr double kHop = 0.008;

/// The filter as the books write it: six states, full matrices.
class Oracle {
 public:
  using Matrix = std::array<std::array<double, 6>, 6>;
  Oracle(double sigma_q, Vec3 start) : q_(sigma_q * sigma_q) {
    x_ = {static_cast<double>(start.x), static_cast<double>(start.y), static_cast<double>(start.z), 0, 0, 0};
    for (std::size_t i = 0; i < 6; ++i) p_[i][i] = q_;
  }
  void predict() {
    Matrix f{};
    for (std::size_t i = 0; i < 6; ++i) f[i][i] = 1;
    for (std::size_t i = 0; i < 3; ++i) f[i][i + 3] = kHop;
    std::array<double, 6> x{};
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) x[i] += f[i][j] * x_[j];
    }
    x_ = x;
    Matrix p{};
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) {
        for (std::size_t k = 0; k < 6; ++k) {
          for (std::size_t l = 0; l < 6; ++l) p[i][j] += f[i][k] * p_[k][l] * f[j][l];
        }
      }
    }
    p_ = p;
    for (std::size_t i = 3; i < 6; ++i) p_[i][i] += q_;
    const double s = x_[0] * x_[3] + x_[1] * x_[4] + x_[2] * x_[5];
    const double n2 = x_[0] * x_[0] + x_[1] * x_[1] + x_[2] * x_[2];
    for (std::size_t i = 0; i < 3; ++i) {
      x_[i + 3] -= x_[i] * s / n2;
      x_[i] /= std::sqrt(n2);
    }
  }
  /// H P H' + R is diagonal here, but nothing of this oracle relies on it beyond the inverse.
  void update(Vec3 z, double activity, double r) {
    const std::array<double, 3> d{static_cast<double>(z.x) - x_[0], static_cast<double>(z.y) - x_[1],
                                  static_cast<double>(z.z) - x_[2]};
    std::array<std::array<double, 3>, 6> k{};
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 3; ++j) k[i][j] = p_[i][j] / (p_[j][j] + r);
    }
    const Matrix old = p_;
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 3; ++j) x_[i] += activity * k[i][j] * d[j];
      for (std::size_t c = 0; c < 6; ++c) {
        for (std::size_t j = 0; j < 3; ++j) p_[i][c] -= activity * k[i][j] * old[j][c];
      }
    }
  }
  [[nodiscard]] Vec3 direction() const {
    return normalized({static_cast<float>(x_[0]), static_cast<float>(x_[1]), static_cast<float>(x_[2])});
  }

 private:
  double q_;
  std::array<double, 6> x_{};
  Matrix p_{};
};

TEST(Kalman, Agrees_with_the_six_dimensional_filter) {
  Kalman filter({}, kHop);
  const Vec3 start = direction_of(20, 10);
  filter.start(start);
  Oracle oracle(0.001F, start);
  for (int hop = 0; hop < 500; ++hop) {
    filter.predict();
    oracle.predict();
    const Potential seen{direction_of(20 + 0.1F * static_cast<float>(hop), 10), 0.5F};
    const double activity = hop % 3 == 0 ? 0.2 : 0.95;
    const double probability = 0.9;
    filter.update({&seen, 1}, {&probability, 1}, activity, 0.0225);
    oracle.update(seen.direction, activity, 0.0225);
    ASSERT_LT(norm(filter.direction() - oracle.direction()), 1e-6F) << hop;
  }
}

TEST(Kalman, Likelihood_is_the_density_of_a_Gaussian) {
  Kalman filter({0.1F}, kHop);
  filter.start({0, 0, 1});
  const double variance = 0.1F * 0.1F + 0.02;
  const Vec3 z{0.1F, 0, 0.9F};
  const double d2 = 0.01 + 0.01;
  const double expected = std::log(std::pow(2 * std::numbers::pi * variance, -1.5)) - d2 / (2 * variance);
  EXPECT_NEAR(filter.log_likelihood(z, 0.02), expected, 1e-4);
}

TEST(Kalman, Follows_a_walk_and_takes_the_likeliest_potential) {
  Kalman filter({}, kHop);
  filter.start(direction_of(0, 0));
  for (int hop = 0; hop < 800; ++hop) {
    filter.predict();
    const Potential seen[]{{direction_of(180, 0), 0.5F},
                           {direction_of(0.05F * static_cast<float>(hop), 0), 0.5F}};
    const double probability[]{0.1, 0.9};
    filter.update(seen, probability, 1, 0.0025);
  }
  EXPECT_LT(test::angle_deg(filter.direction(), direction_of(40, 0)), 3);
  EXPECT_NEAR(norm(filter.direction()), 1, 1e-5);
}

TEST(Kalman, Keeps_its_direction_while_nothing_is_active) {
  Kalman filter({}, kHop);
  filter.start(direction_of(30, 0));
  const Potential seen{direction_of(90, 0), 0.5F};
  const double probability = 0;
  for (int hop = 0; hop < 100; ++hop) {
    filter.predict();
    filter.update({&seen, 1}, {&probability, 1}, 0, 0.0025);
  }
  EXPECT_LT(test::angle_deg(filter.direction(), direction_of(30, 0)), 0.01F);
}

}  // namespace
}  // namespace odas::kalman_test
