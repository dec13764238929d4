// SPDX-License-Identifier: MIT
#include "odas/scene/ideal_mask.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "odas/base/contract.hpp"
#include "odas/dsp/real_fft.hpp"
#include "odas/scene/projection.hpp"

namespace odas {

std::vector<float> ideal_mask_voice(const std::vector<float>& mic, const std::vector<float>& image) {
  constexpr std::size_t kFrame = 512, kHop = 128;
  ODAS_EXPECT(mic.size() == image.size());
  std::vector<float> window(kFrame);
  for (std::size_t n = 0; n < kFrame; ++n) {
    // The square of a sine, four times overlapped, sums to 2.
    window[n] = static_cast<float>(std::sin(std::numbers::pi * (static_cast<double>(n) + 0.5) / kFrame) /
                                   std::numbers::sqrt2);
  }
  RealFft fft(kFrame);
  std::vector<float> voice(mic.size());
  std::vector<cfloat> target(fft.bins().size());
  // Frame i begins kBefore samples before sample i * kHop; what lies outside is silence.
  constexpr std::size_t kBefore = kFrame - kHop;
  const auto transform = [&](const std::vector<float>& sound, std::size_t start) {
    for (std::size_t n = 0; n < kFrame; ++n) {
      const bool inside = start + n >= kBefore && start + n < kBefore + sound.size();
      fft.time()[n] = inside ? window[n] * sound[start + n - kBefore] : 0;
    }
    fft.forward();
  };
  for (std::size_t start = 0; start < mic.size() + kBefore; start += kHop) {
    transform(image, start);
    std::ranges::copy(fft.bins(), target.begin());
    transform(mic, start);
    for (std::size_t k = 0; k < target.size(); ++k) {
      const float s = std::norm(target[k]);
      const float rest = std::norm(fft.bins()[k] - target[k]);
      fft.bins()[k] *= s / std::max(s + rest, 1e-20F);
    }
    fft.inverse();
    for (std::size_t n = 0; n < kFrame; ++n) {
      if (start + n >= kBefore && start + n < kBefore + voice.size()) {
        voice[start + n - kBefore] += window[n] * fft.time()[n];
      }
    }
  }
  return voice;
}

std::optional<double> ideal_mask_sdr_db(const KnownSound& sound) {
  if (sound.images.empty()) return std::nullopt;
  double sum = 0;
  for (const auto& image : sound.images) sum += sdr_db(ideal_mask_voice(sound.mic, image), image);
  return sum / static_cast<double>(sound.images.size());
}

}  // namespace odas
