// SPDX-License-Identifier: MIT
#include "odas/scene/activity.hpp"

#include <algorithm>

namespace odas {

std::vector<std::uint8_t> activity_of(std::span<const float> sound, std::size_t step, int sample_rate) {
  const std::size_t count = sound.size() / step;
  const auto half = static_cast<std::size_t>(sample_rate) / 100;
  std::vector<double> energy(count);
  std::vector<double> heard;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t middle = i * step + step / 2;
    const std::size_t begin = middle - std::min(middle, half);
    const std::size_t end = std::min(sound.size(), middle + half);
    for (std::size_t n = begin; n < end; ++n) {
      energy[i] += static_cast<double>(sound[n]) * static_cast<double>(sound[n]);
    }
    if (energy[i] > 0) heard.push_back(energy[i]);
  }
  std::vector<std::uint8_t> active(count);
  if (heard.empty()) return active;
  const auto loud = heard.begin() + static_cast<std::ptrdiff_t>((heard.size() - 1) * 95 / 100);
  std::nth_element(heard.begin(), loud, heard.end());
  const double threshold = *loud * 1e-3;
  const auto shortest = static_cast<std::size_t>(sample_rate) / 5 / step;
  // Inactive steps. What comes before the first word is no pause, however short all of it is.
  std::size_t since = std::max(count, shortest);
  for (std::size_t i = 0; i < count; ++i) {
    if (energy[i] <= threshold) {
      ++since;
      continue;
    }
    if (since < shortest) std::fill_n(active.begin() + static_cast<std::ptrdiff_t>(i - since), since, 1);
    active[i] = 1;
    since = 0;
  }
  return active;
}

}  // namespace odas
