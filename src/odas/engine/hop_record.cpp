// SPDX-License-Identifier: MIT
#include "odas/engine/hop_record.hpp"

#include <algorithm>

namespace odas {
namespace {

/// A part that is not wanted has no room; one that is not computed comes empty.
template <class T>
void copy(std::span<const T> from, std::vector<T>& to) noexcept {
  ODAS_EXPECT(from.empty() || to.empty() || from.size() == to.size());
  std::copy_n(from.begin(), std::min(from.size(), to.size()), to.begin());
}

void copy(GridView<const float> from, Grid<float>& to) noexcept {
  for (std::size_t row = 0; row < std::min(from.rows(), to.rows()); ++row) {
    std::copy_n(from[row].begin(), std::min(from.cols(), to.cols()), to[row].begin());
  }
}

}  // namespace

HopRecord::HopRecord(const Wanted& wanted, const PipelineConfig& config, std::size_t power_directions) {
  const auto hop = static_cast<std::size_t>(config.general.size.hop_size);
  const std::size_t slots = config.sst.slots();
  if (wanted.potentials) potentials_.resize(static_cast<std::size_t>(config.ssl.n_pots));
  if (wanted.tracks) tracks_.resize(slots);
  if (wanted.separated) separated_ = Grid<float>(slots, hop);
  if (wanted.postfiltered) postfiltered_ = Grid<float>(slots, hop);
  if (wanted.mics) mics_ = Grid<float>(config.general.mics.size(), hop);
  if (wanted.power_map) power_.resize(power_directions);
  if (wanted.reports) reports_.resize(slots);
}

void HopRecord::assign(const HopResult& hop) noexcept {
  time_ = hop.time;
  copy(hop.potentials, potentials_);
  copy(hop.tracks, tracks_);
  copy(hop.separated, separated_);
  copy(hop.postfiltered, postfiltered_);
  copy(hop.mics, mics_);
  copy(hop.power, power_);
  copy(hop.reports, reports_);
}

HopResult HopRecord::view() const noexcept {
  return {time_,        potentials_, tracks_, separated_.view(), postfiltered_.view(),
          mics_.view(), power_,      reports_};
}

}  // namespace odas
