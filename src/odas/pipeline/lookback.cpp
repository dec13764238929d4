// SPDX-License-Identifier: MIT
#include "odas/pipeline/lookback.hpp"

#include "odas/base/contract.hpp"

namespace odas {

LookBack::LookBack(std::size_t hops, std::size_t mics, std::size_t bins, std::size_t slots)
    : spectra_(hops + 1, Grid<cfloat>(mics, bins)), places_(hops + 1, slots), first_(slots), tracks_(slots) {}

GridView<cfloat> LookBack::begin_hop() noexcept {
  newest_ = oldest();
  return spectra_[newest_];
}

std::span<const Track> LookBack::recall(std::span<const Track> tracks) noexcept {
  ODAS_EXPECT(tracks.size() == tracks_.size());
  for (std::size_t s = 0; s < tracks.size(); ++s) {
    const Track& track = tracks[s];
    if (first_[s].id != track.id) first_[s] = {track.id, track.direction};
    places_[newest_][s] = {track.id, track.direction};
    const Place& then = places_[oldest()][s];
    tracks_[s] = track;
    tracks_[s].direction = then.id == track.id ? then.direction : first_[s].direction;
  }
  return tracks_;
}

GridView<const cfloat> LookBack::spectra() const noexcept { return spectra_[oldest()]; }

void LookBack::reset() noexcept {
  newest_ = 0;
  for (Grid<cfloat>& spectra : spectra_) spectra.fill({});
  places_.fill({});
  for (Place& place : first_) place = {};
}

std::size_t LookBack::memory_bytes() const noexcept {
  const Grid<cfloat>& one = spectra_.front();
  return spectra_.size() * (one.rows() * one.cols() * sizeof(cfloat) + places_.cols() * sizeof(Place));
}

}  // namespace odas
