// SPDX-License-Identifier: MIT
#include "odas/separation/presence_noise.hpp"

#include <algorithm>
#include <cmath>

#include "odas/base/contract.hpp"
#include "odas/dsp/tiny_power.hpp"

namespace odas {
namespace {

// From the prior SNR of 15 dB of the paper: there, noise and speech are as likely.
constexpr float kThreshold = 3.6F;
constexpr float kMostRatio = 1e4F;  // to the fourth power it is still a float
constexpr float kLearnSeconds = 0.13F;
constexpr float kPresenceSeconds = 0.08F;
constexpr float kStuck = 0.99F;
constexpr std::size_t kFirstHops = 5;  // are taken for noise, whatever they are

}  // namespace

PresenceNoise::PresenceNoise(std::size_t bins, float hop_seconds)
    : learn_(1 - std::exp(-hop_seconds / kLearnSeconds)),
      mean_(1 - std::exp(-hop_seconds / kPresenceSeconds)),
      noise_(bins),
      presence_(bins, 0.5F) {}

void PresenceNoise::update(std::span<const float> power) noexcept {
  ODAS_EXPECT(power.size() == noise_.size());
  if (hops_ < kFirstHops) {
    ++hops_;
    for (std::size_t k = 0; k < noise_.size(); ++k) {
      noise_[k] += (power[k] - noise_[k]) / static_cast<float>(hops_);
    }
    return;
  }
  for (std::size_t k = 0; k < noise_.size(); ++k) {
    const float ratio = std::min(power[k] / (kThreshold * noise_[k] + kTinyPower), kMostRatio);
    const float square = ratio * ratio;
    float present = square * square / (1 + square * square);
    presence_[k] += mean_ * (present - presence_[k]);
    present = presence_[k] > kStuck ? std::min(present, kStuck) : present;
    noise_[k] += learn_ * (1 - present) * (power[k] - noise_[k]);
  }
}

void PresenceNoise::take_over(const PresenceNoise& other) noexcept {
  hops_ = other.hops_;
  std::ranges::copy(other.noise_, noise_.begin());
  std::ranges::copy(other.presence_, presence_.begin());
}

void PresenceNoise::reset() noexcept {
  hops_ = 0;
  std::ranges::fill(noise_, 0.F);
  std::ranges::fill(presence_, 0.5F);
}

}  // namespace odas
