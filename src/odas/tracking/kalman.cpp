// SPDX-License-Identifier: MIT
#include "odas/tracking/kalman.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odas {
namespace {

constexpr double kTiny = 1e-20;

}  // namespace

void Kalman::start(Vec3 direction) noexcept {
  p_[0] = static_cast<double>(direction.x);
  p_[1] = static_cast<double>(direction.y);
  p_[2] = static_cast<double>(direction.z);
  std::fill_n(v_, 3, 0.0);
  pp_ = vv_ = q_;
  pv_ = 0;
}

void Kalman::predict() noexcept {
  for (int i = 0; i < 3; ++i) p_[i] += dt_ * v_[i];
  pp_ += dt_ * (2 * pv_ + dt_ * vv_);
  pv_ += dt_ * vv_;
  vv_ += q_;
  const double along = p_[0] * v_[0] + p_[1] * v_[1] + p_[2] * v_[2];
  const double n2 = p_[0] * p_[0] + p_[1] * p_[1] + p_[2] * p_[2];
  for (int i = 0; i < 3; ++i) {
    v_[i] -= p_[i] * along / (n2 + kTiny);
    p_[i] /= std::sqrt(n2) + kTiny;
  }
}

double Kalman::log_likelihood(Vec3 z, double sigma2) const noexcept {
  const double dx = static_cast<double>(z.x) - p_[0];
  const double dy = static_cast<double>(z.y) - p_[1];
  const double dz = static_cast<double>(z.z) - p_[2];
  const double variance = pp_ + sigma2;
  return -1.5 * std::log(2 * std::numbers::pi * variance) - (dx * dx + dy * dy + dz * dz) / (2 * variance);
}

void Kalman::update(std::span<const Potential> potentials, std::span<const double> probability,
                    double activity, double sigma2) noexcept {
  if (!(activity > 0)) return;
  const auto best = static_cast<std::size_t>(std::max_element(probability.begin(), probability.end()) -
                                             probability.begin());
  const Vec3 z = potentials[best].direction;
  const double innovation[3]{static_cast<double>(z.x) - p_[0], static_cast<double>(z.y) - p_[1],
                             static_cast<double>(z.z) - p_[2]};
  const double gain_p = activity * pp_ / (pp_ + sigma2);
  const double gain_v = activity * pv_ / (pp_ + sigma2);
  for (int i = 0; i < 3; ++i) {
    p_[i] += gain_p * innovation[i];
    v_[i] += gain_v * innovation[i];
  }
  vv_ -= gain_v * pv_;
  pv_ -= gain_p * pv_;
  pp_ -= gain_p * pp_;
}

Vec3 Kalman::direction() const noexcept {
  return normalized({static_cast<float>(p_[0]), static_cast<float>(p_[1]), static_cast<float>(p_[2])});
}

}  // namespace odas
