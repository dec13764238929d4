// SPDX-License-Identifier: MIT
#include "odas/separation/steering.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "odas/array/geometry.hpp"
#include "odas/base/contract.hpp"

namespace odas {
namespace {

// Bins in a block: the row is the outer product of phases between blocks and phases within one.
constexpr std::size_t kBlock = 16;

bool is_finite(Vec3 u) noexcept { return std::isfinite(u.x) && std::isfinite(u.y) && std::isfinite(u.z); }

double project(Vec3 p, Vec3 u) noexcept {
  return double{p.x} * double{u.x} + double{p.y} * double{u.y} + double{p.z} * double{u.z};
}

}  // namespace

Steering::Steering(const GeneralConfig& general)
    : bins_(static_cast<std::size_t>(general.size.frame_size) / 2 + 1),
      radians_per_metre_(2 * M_PI * general.samplerate.mu /
                         (general.size.frame_size * static_cast<double>(general.speedofsound.mu))),
      gain_min_(general.gain_min),
      directivity_(general) {
  for (const MicConfig& mic : general.mics) positions_.push_back(position(mic));
}

void Steering::gains(Vec3 u, std::span<float> gains) const noexcept {
  ODAS_EXPECT(gains.size() == mics());
  const bool heard = is_finite(u);
  for (std::size_t m = 0; m < gains.size(); ++m) {
    const float gain = heard ? directivity_.mic(m, u) : 0;
    gains[m] = gain >= gain_min_ ? gain : 0;
  }
}

void Steering::row(std::size_t mic, Vec3 u, float gain, std::span<cfloat> row) const noexcept {
  ODAS_EXPECT(row.size() == bins_);
  const double step = radians_per_metre_ * project(positions_[mic], u);

  // Within a block, twice: {re, im, ...} and, turned by a quarter, {-im, re, ...}, so that
  // z * block = Re z * within + Im z * turned runs over plain floats.
  std::array<float, 2 * kBlock> within;
  std::array<float, 2 * kBlock> turned;
  const double c = std::cos(step);
  const double s = std::sin(step);
  double re = 1;
  double im = 0;
  for (std::size_t b = 0; b < kBlock; ++b) {
    within[2 * b] = turned[2 * b + 1] = static_cast<float>(re);
    within[2 * b + 1] = static_cast<float>(im);
    turned[2 * b] = static_cast<float>(-im);
    const double next = re * c - im * s;
    im = re * s + im * c;
    re = next;
  }

  auto* out = reinterpret_cast<float*>(row.data());
  const double block_c = re;
  const double block_s = im;
  double x = static_cast<double>(gain);
  double y = 0;
  for (std::size_t left = 2 * row.size(); left > 0;) {
    const auto fx = static_cast<float>(x);
    const auto fy = static_cast<float>(y);
    const std::size_t n = std::min(left, 2 * kBlock);
    if (n == 2 * kBlock) {  // of known length, for the compiler
      for (std::size_t i = 0; i < 2 * kBlock; ++i) out[i] = fx * within[i] + fy * turned[i];
    } else {
      for (std::size_t i = 0; i < n; ++i) out[i] = fx * within[i] + fy * turned[i];
    }
    out += n;
    left -= n;
    const double next = x * block_c - y * block_s;
    y = x * block_s + y * block_c;
    x = next;
  }
}

}  // namespace odas
