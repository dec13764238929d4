// SPDX-License-Identifier: MIT
#include "odas/engine/metrics.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace odas {
namespace {

using std::chrono::nanoseconds;

// Bins are the octave of the time in units of 1/4 us and its next two bits: 2^k * (4 + quarter) units.
constexpr std::uint64_t kUnit = 250;  // ns

std::size_t bin_of(std::uint64_t ns, std::size_t bins) noexcept {
  const std::uint64_t units = std::max<std::uint64_t>(ns / kUnit, 4);
  const auto octave = static_cast<std::size_t>(std::bit_width(units)) - 3;  // 0 for 1 us .. 2 us
  const auto quarter = static_cast<std::size_t>(units >> octave) & 3U;
  return std::min(4 * octave + quarter, bins - 1);
}

std::uint64_t upper_edge(std::size_t bin) noexcept {
  const std::size_t next = bin + 1;
  return (std::uint64_t{4 + next % 4} << (next / 4)) * kUnit;
}

}  // namespace

void TimeHistogram::add(nanoseconds time) noexcept {
  const auto ns = static_cast<std::uint64_t>(std::max<nanoseconds::rep>(time.count(), 0));
  ++bins_[bin_of(ns, bins_.size())];
  max_ = std::max(max_, time);
  total_ += time;
}

nanoseconds TimeHistogram::quantile(double q) const noexcept {
  const std::uint64_t all = std::accumulate(bins_.begin(), bins_.end(), std::uint64_t{0});
  const auto wanted = static_cast<std::uint64_t>(std::ceil(q * static_cast<double>(all)));
  std::uint64_t seen = 0;
  for (std::size_t bin = 0; bin < bins_.size() && all > 0; ++bin) {
    seen += bins_[bin];
    if (seen >= wanted && seen > 0) {
      return std::min(nanoseconds(static_cast<nanoseconds::rep>(upper_edge(bin))), max_);
    }
  }
  return nanoseconds(0);
}

TimeHistogram TimeHistogram::since(const TimeHistogram& earlier) const noexcept {
  TimeHistogram later = *this;
  for (std::size_t bin = 0; bin < bins_.size(); ++bin) later.bins_[bin] -= earlier.bins_[bin];
  later.total_ -= earlier.total_;
  return later;
}

double Metrics::real_time_share() const noexcept {
  const std::chrono::duration<double> busy = hop_time.total();
  return sound_seconds > 0 ? busy.count() / sound_seconds : 0;
}

}  // namespace odas
