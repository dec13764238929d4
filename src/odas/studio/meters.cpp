// SPDX-License-Identifier: MIT
#include "odas/studio/meters.hpp"

#include <algorithm>
#include <cmath>

namespace odas {
namespace {

constexpr float kLimit = 0.99F;        // of full scale
constexpr std::uint64_t kRare = 1000;  // one sample in so many at the limit is a loud sound, no clipping
constexpr float kFloor = -120;         // dB

float db_of_power(double power) {
  return power > 0 ? std::max(kFloor, static_cast<float>(10 * std::log10(power))) : kFloor;
}

}  // namespace

MicMeters::MicMeters(std::size_t mics, int sample_rate)
    : second_(static_cast<std::uint64_t>(sample_rate)), mics_(mics) {
  for (std::size_t m = 0; m < mics; ++m) mics_[m].same_for.resize(m);
}

bool MicMeters::add(GridView<const float> block) {
  if (block.rows() != mics_.size() || block.cols() == 0) return false;
  for (std::size_t m = 0; m < mics_.size(); ++m) {
    Mic& mic = mics_[m];
    const std::span<const float> x = block[m];
    double sum = 0;
    for (const float v : x) {
      const float magnitude = std::fabs(v);
      sum += static_cast<double>(v) * static_cast<double>(v);
      mic.peak = std::max(mic.peak, magnitude);
      if (magnitude >= kLimit) ++mic.at_limit;
    }
    mic.sum += sum;
    const bool still = std::all_of(x.begin(), x.end(), [&](float v) { return v == x[0]; });
    mic.still = !still ? 0 : (x[0] == mic.last ? mic.still : 0) + x.size();
    mic.last = x.back();
    for (std::size_t i = 0; i < m; ++i) {
      const bool same = std::equal(x.begin(), x.end(), block[i].begin());
      mic.same_for[i] = same ? mic.same_for[i] + x.size() : 0;
    }
  }
  samples_ += block.cols();
  return samples_ * kReadingsPerSecond >= second_;
}

MeterReading MicMeters::take(HopIndex time) {
  MeterReading reading;
  reading.time = time;
  const bool one_moves =
      std::any_of(mics_.begin(), mics_.end(), [&](const Mic& mic) { return mic.still < second_; });
  for (Mic& mic : mics_) {
    MeterReading::Mic shown;
    shown.rms_db = db_of_power(mic.sum / static_cast<double>(std::max<std::uint64_t>(samples_, 1)));
    shown.peak_db = db_of_power(static_cast<double>(mic.peak) * static_cast<double>(mic.peak));
    const bool dead = one_moves && mic.still >= second_;
    if (mic.at_limit > 0 && mic.at_limit * kRare >= samples_) shown.flags |= MeterReading::clipped;
    if (dead) shown.flags |= MeterReading::dead;
    const auto twin = std::find_if(mic.same_for.begin(), mic.same_for.end(),
                                   [&](std::uint64_t samples) { return samples >= second_; });
    if (mic.still < second_ && twin != mic.same_for.end()) {
      shown.flags |= MeterReading::duplicate;
      shown.same_as = static_cast<int>(twin - mic.same_for.begin()) + 1;
    }
    reading.mics.push_back(shown);
    mic.sum = 0;
    mic.peak = 0;
    mic.at_limit = 0;
  }
  samples_ = 0;
  return reading;
}

}  // namespace odas
