// SPDX-License-Identifier: MIT
#include "odas/engine/input_health.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace odas {
namespace {

constexpr float kLimit = 0.99F;             // of full scale
constexpr std::uint64_t kRare = 1000;       // one sample in so many at the limit is a loud sound, no clipping
constexpr std::uint64_t kStillSeconds = 5;  // a pause of digital silence may be this long

/// Whether any sample is not `value`.
bool moves(std::span<const float> samples, float value) noexcept {
  return std::any_of(samples.begin(), samples.end(), [&](float x) { return x != value; });
}

std::uint64_t count_at_limit(std::span<const float> samples) noexcept {
  std::uint32_t count = 0;
  for (const float x : samples) count += std::fabs(x) >= kLimit ? 1U : 0U;
  return count;
}

}  // namespace

InputHealth::InputHealth(std::vector<int> map, int sample_rate)
    : map_(std::move(map)),
      mics_(map_.size()),
      window_(static_cast<std::uint64_t>(sample_rate)),
      found_(std::make_unique<Found[]>(map_.size())) {
  for (std::size_t m = 0; m < mics_.size(); ++m) {
    mics_[m].watched = map_[m] != 0;
    same_.emplace_back(m);
  }
  start_window();
}

void InputHealth::start_window() noexcept {
  seen_ = 0;
  for (std::size_t m = 0; m < mics_.size(); ++m) {
    mics_[m].moved = false;
    mics_[m].at_limit = 0;
    for (std::size_t i = 0; i < m; ++i) same_[m][i] = mics_[m].watched && mics_[i].watched;
  }
}

void InputHealth::watch(GridView<const float> block) noexcept {
  ODAS_EXPECT(block.rows() == mics_.size());
  if (block.empty()) return;
  for (std::size_t m = 0; m < mics_.size(); ++m) {
    Mic& mic = mics_[m];
    if (!mic.watched) continue;
    if (seen_ == 0) mic.first = block[m][0];
    if (!mic.moved) mic.moved = moves(block[m], mic.first);
    mic.at_limit += count_at_limit(block[m]);
    for (std::size_t i = 0; i < m; ++i) {
      if (same_[m][i]) same_[m][i] = std::equal(block[m].begin(), block[m].end(), block[i].begin());
    }
  }
  seen_ += block.cols();
  if (seen_ >= window_) {
    judge();
    start_window();
  }
}

void InputHealth::finish() noexcept {
  if (seen_ >= window_ / 4) judge();
  start_window();
  if (!ever_moved_ && still_seconds_ > 0) all_silent_ = true;
}

void InputHealth::judge() noexcept {
  const bool any_moved = std::any_of(mics_.begin(), mics_.end(), [](const Mic& m) { return m.moved; });
  ever_moved_ = ever_moved_ || any_moved;
  still_seconds_ = any_moved ? 0 : still_seconds_ + 1;
  if (still_seconds_ >= kStillSeconds) all_silent_ = true;
  if (!any_moved) return;
  for (std::size_t m = 0; m < mics_.size(); ++m) {
    if (!mics_[m].watched) continue;
    if (!mics_[m].moved) found_[m].kinds |= silent;
    if (mics_[m].at_limit * kRare >= seen_) found_[m].kinds |= clipped;
    for (std::size_t i = 0; i < m && mics_[m].moved; ++i) {
      if (same_[m][i] && found_[m].same_as < 0) found_[m].same_as = static_cast<int>(i);
    }
  }
}

std::string InputHealth::mic_name(std::size_t mic) const {
  return "microphone " + std::to_string(mic + 1) + " (channel " + std::to_string(map_[mic]) + ")";
}

std::vector<std::string> InputHealth::take_warnings() {
  std::vector<std::string> warnings;
  if (all_silent_ && !std::exchange(told_all_silent_, true)) {
    warnings.push_back("all microphones are silent; is the recording empty, or the device muted?");
  }
  for (std::size_t m = 0; m < mics_.size(); ++m) {
    Found& found = found_[m];
    const auto fresh = static_cast<std::uint8_t>(found.kinds & ~found.told_kinds);
    found.told_kinds = static_cast<std::uint8_t>(found.told_kinds | fresh);
    if ((fresh & silent) != 0) warnings.push_back(mic_name(m) + " is silent");
    if ((fresh & clipped) != 0) warnings.push_back(mic_name(m) + " is clipped: the input is too loud");
    const int twin = found.same_as;
    if (twin >= 0 && !std::exchange(found.told_same, true)) {
      warnings.push_back(mic_name(m) + " is the same as " + mic_name(static_cast<std::size_t>(twin)) +
                         ", sample by sample");
    }
  }
  return warnings;
}

}  // namespace odas
