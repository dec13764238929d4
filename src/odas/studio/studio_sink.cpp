// SPDX-License-Identifier: MIT
#include "odas/studio/studio_sink.hpp"

#include <utility>

namespace odas {

Wanted StudioSink::wanted() const noexcept {
  Wanted all;
  all.categories = all.mics = all.power_map = all.reports = true;
  return all;
}

IoStatus StudioSink::write(const HopResult& hop) {
  if (has_changed_.exchange(false, std::memory_order_acq_rel)) {
    const std::lock_guard lock(mutex_);
    if (const auto info = std::exchange(changed_, std::nullopt)) {
      for (HopListener* listener : listeners_) listener->change(*info);
    }
  }
  for (HopListener* listener : listeners_) listener->hop(hop);
  return {};
}

IoStatus StudioSink::flush() {
  std::uint64_t lost = 0, clipped = 0;
  for (const Sink* sink : others_) {
    lost += sink->lost_records();
    clipped += sink->clipped_samples();
  }
  figures_->lost_records.store(lost, std::memory_order_relaxed);
  figures_->clipped_samples.store(clipped, std::memory_order_relaxed);
  return {};
}

void StudioSink::change(StreamInfo info) {
  const std::lock_guard lock(mutex_);
  changed_ = std::move(info);
  has_changed_.store(true, std::memory_order_release);
}

}  // namespace odas
