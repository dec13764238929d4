// SPDX-License-Identifier: MIT
#include "odas/scene/tdoa_bound.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "odas/dsp/real_fft.hpp"
#include "odas/scene/room.hpp"
#include "odas/scene/trajectory.hpp"

namespace odas {
namespace {

constexpr std::size_t kBoundFrame = 512;
constexpr double kLowest = 100, kHighest = 7000;  // Hz

/// Mean power by bin, over the frames whose middle is in a hop that counts.
std::vector<double> spectrum(std::span<const float> sound, std::span<const std::uint8_t> counts,
                             std::size_t hop) {
  RealFft fft(kBoundFrame);
  std::vector<double> power(kBoundFrame / 2 + 1);
  for (std::size_t start = 0; start + kBoundFrame <= sound.size(); start += kBoundFrame / 2) {
    const std::size_t middle = (start + kBoundFrame / 2) / hop;
    if (middle >= counts.size() || counts[middle] == 0) continue;
    for (std::size_t n = 0; n < kBoundFrame; ++n) {
      const double hann = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(n) / kBoundFrame);
      fft.time()[n] = static_cast<float>(hann) * sound[start + n];
    }
    fft.forward();
    for (std::size_t k = 0; k < power.size(); ++k) power[k] += static_cast<double>(std::norm(fft.bins()[k]));
  }
  return power;
}

/// The share of a talker's energy at microphone 1 that came straight.
double direct_share(const Scene& scene, const Room& room, const SceneSource& source) {
  if (scene.rt60 <= 0) return 1;
  const Vec3 from = position_at(source.path, scene.seconds / 2);
  std::vector<float> all(room.response_length(norm(from)));
  std::vector<float> direct(all.size());
  room.add_response(from, scene.mics[0], {}, all);
  room.add_response(from, scene.mics[0], {0, 0}, direct);
  double whole = 0, straight = 0;
  for (std::size_t n = 0; n < all.size(); ++n) {
    whole += static_cast<double>(all[n]) * all[n];
    straight += static_cast<double>(direct[n]) * direct[n];
  }
  return whole > 0 ? std::min(1.0, straight / whole) : 1;
}

double bound(const std::vector<double>& talker, const std::vector<double>& noise, double direct, int rate) {
  const double step = static_cast<double>(rate) / kBoundFrame;  // Hz
  double sum = 0;
  for (std::size_t k = 0; k < talker.size(); ++k) {
    const double f = static_cast<double>(k) * step;
    if (f < kLowest || f > kHighest) continue;
    const double s = direct * talker[k];
    const double n = (1 - direct) * talker[k] + noise[k];
    if (s <= 0) continue;
    const double coherence = std::pow(s / (s + std::max(n, 1e-9 * s)), 2);
    sum += std::pow(2 * std::numbers::pi * f, 2) * coherence / (1 - coherence) * step;
  }
  return sum > 0 ? 1 / std::sqrt(2 * kBoundSeconds * sum) : 1;
}

}  // namespace

std::vector<double> tdoa_bounds(const Scene& scene, const PlayedScene& played) {
  std::vector<float> noise = played.sound.mic;
  for (const auto& image : played.sound.images) {
    for (std::size_t n = 0; n < noise.size(); ++n) noise[n] -= image[n];
  }
  const Room room(scene);
  std::vector<double> bounds;
  std::size_t target = 0;
  for (const SceneSource& source : scene.sources) {
    if (!source.is_target) continue;
    const auto& active = played.truth.sources[target].active;
    bounds.push_back(bound(spectrum(played.sound.images[target], active, scene.hop),
                           spectrum(noise, active, scene.hop), direct_share(scene, room, source),
                           scene.sample_rate));
    ++target;
  }
  return bounds;
}

}  // namespace odas
