// SPDX-License-Identifier: MIT
#include "odas/studio/hop_ring.hpp"

#include <algorithm>
#include <cmath>

namespace odas {
namespace {

std::size_t size_of(const HopFrame& frame) {
  std::size_t bytes = sizeof frame + frame.full.capacity() + frame.bare.capacity();
  for (const auto& pcm : frame.pcm) bytes += pcm.size() * sizeof(std::int16_t);
  return bytes;
}

std::vector<std::int16_t> pcm_of(GridView<const float> audio, float gain) {
  std::vector<std::int16_t> pcm;
  pcm.reserve(audio.rows() * audio.cols());
  for (std::size_t row = 0; row < audio.rows(); ++row) {
    for (const float x : audio[row]) {
      const float scaled = std::clamp(std::round(x * gain * 32768.0F), -32768.0F, 32767.0F);
      pcm.push_back(static_cast<std::int16_t>(std::isfinite(scaled) ? scaled : 0.0F));
    }
  }
  return pcm;
}

}  // namespace

void HopRing::begin(const StreamInfo& info) {
  const std::lock_guard lock(mutex_);
  info_ = info;
  frames_.clear();
  run_begin_ = end_;
  bytes_ = 0;
  meters_ = MicMeters(info.mics.size(), info.sample_rate);
  reading_ = {};
  power_ = {};
  beams_ = {};
  pulse_ = {};
}

void HopRing::end() {}

void HopRing::demand(const Demand& demand) {
  const std::lock_guard lock(mutex_);
  demand_ = demand;
}

void HopRing::hop(const HopResult& hop) {
  Demand demand;
  StreamInfo const* info = nullptr;
  {
    const std::lock_guard lock(mutex_);
    if (!info_) return;
    demand = demand_;
    info = &*info_;  // changed by `begin` alone, in this thread
  }
  auto frame = std::make_shared<HopFrame>();
  frame->time = hop.time;
  if (demand.hops) append_hop(frame->full, hop);
  if (demand.bare) append_hop(frame->bare, hop, false);
  for (const Track& track : hop.tracks) frame->ids.push_back(track.id);
  for (std::size_t s = 0; s < kAudioStreams; ++s) {
    const auto stream = static_cast<AudioStream>(s);
    if (demand.audio[s]) frame->pcm[s] = pcm_of(audio_of(hop, stream), gain_of(*info, stream));
  }
  const bool read = demand.meters && meters_.add(hop.mics);

  const std::lock_guard lock(mutex_);
  bytes_ += size_of(*frame);
  frames_.push_back(std::move(frame));
  ++end_;
  drop_old();
  if (read) {
    reading_ = meters_.take(hop.time);
    ++readings_;
  }
  if (demand.power && !hop.power.empty()) {
    power_.time = hop.time;
    power_.energy.assign(hop.power.begin(), hop.power.end());
  }
  note_beams(hop);
  pulse_ = {hop.time, std::chrono::system_clock::now()};
}

void HopRing::note_beams(const HopResult& hop) {
  if (hop.reports.empty()) return;
  beams_.time = hop.time;
  beams_.beams.clear();
  for (std::size_t slot = 0; slot < hop.reports.size(); ++slot) {
    if (hop.reports[slot].id != 0) beams_.beams.push_back({slot, hop.reports[slot]});
  }
}

void HopRing::drop_old() {
  while (bytes_ > kRoom && frames_.size() > 1) {
    bytes_ -= size_of(*frames_.front());
    frames_.pop_front();
  }
}

std::optional<StreamInfo> HopRing::run() const {
  const std::lock_guard lock(mutex_);
  return info_;
}

std::uint64_t HopRing::run_id() const {
  const std::lock_guard lock(mutex_);
  return info_ ? info_->run : 0;
}

std::uint64_t HopRing::end_number() const {
  const std::lock_guard lock(mutex_);
  return end_;
}

HopRing::Reading HopRing::read(std::uint64_t next, std::size_t most) const {
  const std::lock_guard lock(mutex_);
  const std::uint64_t oldest = end_ - frames_.size();
  Reading reading;
  reading.run = info_ ? info_->run : 0;
  reading.first = std::clamp(next, oldest, end_);
  reading.lost = reading.first - std::max(std::min(next, reading.first), std::min(run_begin_, reading.first));
  const auto begin = frames_.begin() + static_cast<std::ptrdiff_t>(reading.first - oldest);
  const auto count = std::min<std::uint64_t>(most, end_ - reading.first);
  reading.frames.assign(begin, begin + static_cast<std::ptrdiff_t>(count));
  return reading;
}

std::uint64_t HopRing::meters(MeterReading& to) const {
  const std::lock_guard lock(mutex_);
  to = reading_;
  return readings_;
}

HopIndex HopRing::power(Power& to) const {
  const std::lock_guard lock(mutex_);
  to = power_;
  return power_.time;
}

HopRing::Beams HopRing::beams() const {
  const std::lock_guard lock(mutex_);
  return beams_;
}

HopRing::Pulse HopRing::pulse() const {
  const std::lock_guard lock(mutex_);
  return pulse_;
}

}  // namespace odas
