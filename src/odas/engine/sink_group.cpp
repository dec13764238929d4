// SPDX-License-Identifier: MIT
#include "odas/engine/sink_group.hpp"

#include <exception>

namespace odas {
namespace {

// A promise of one second needs a little time to be kept.
constexpr auto kFlushPeriod = std::chrono::milliseconds(900);

/// A sink that throws all the same must not bring the thread down.
template <class Call>
IoStatus guarded(Call&& call) {
  try {
    return call();
  } catch (const std::exception& error) { return IoStatus::failed(error.what()); }
}

}  // namespace

SinkGroup::SinkGroup(std::span<Sink* const> sinks) {
  for (Sink* sink : sinks) members_.push_back({sink});
}

void SinkGroup::note(Member& member, const IoStatus& status) {
  if (status.ok()) return;
  member.well = false;
  if (fault_.empty()) fault_ = member.sink->name() + ": " + status.what();
  failed_.store(true, std::memory_order_relaxed);
}

void SinkGroup::write(std::size_t sink, const HopResult& hop) {
  Member& member = members_[sink];
  if (member.well) note(member, guarded([&] { return member.sink->write(hop); }));
}

void SinkGroup::write_all(const HopResult& hop) {
  for (std::size_t s = 0; s < members_.size(); ++s) write(s, hop);
}

void SinkGroup::flush_in_time() {
  const auto now = std::chrono::steady_clock::now();
  if (now - flushed_ < kFlushPeriod) return;
  flushed_ = now;
  for (Member& member : members_) {
    if (member.well) note(member, guarded([&] { return member.sink->flush(); }));
  }
}

void SinkGroup::close() {
  for (Member& member : members_) {
    note(member, guarded([&] { return member.sink->close(); }));
  }
}

void SinkGroup::report(RunSummary& summary, const std::function<void(std::string)>& warn) const {
  for (const Member& member : members_) {
    const std::uint64_t lost = member.sink->lost_records();
    summary.metrics.lost_records += lost;
    if (lost > 0) {
      warn(member.sink->name() + ": " + std::to_string(lost) +
           " hops (of audio: blocks) were lost: nobody was there, or did not read in time");
    }
    const std::uint64_t clipped = member.sink->clipped_samples();
    summary.metrics.clipped_samples += clipped;
    if (clipped > 0) {
      warn(member.sink->name() + ": " + std::to_string(clipped) +
           " samples were louder than full scale and were held at it; a lower gain would keep them");
    }
  }
  if (fault_.empty() || !summary.fault.empty()) return;
  summary.end = RunSummary::End::sink_failed;
  summary.fault = fault_;
}

}  // namespace odas
