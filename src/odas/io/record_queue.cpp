// SPDX-License-Identifier: MIT
#include "odas/io/record_queue.hpp"

#include <algorithm>

#include "odas/base/contract.hpp"

namespace odas {

bool RecordQueue::put(std::span<const char> record) {
  if (!has_room(record.size())) return false;
  if (record.empty()) return true;
  if (sent_ >= room_) {
    bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(sent_));
    sent_ = 0;
  }
  bytes_.insert(bytes_.end(), record.begin(), record.end());
  sizes_.push_back(record.size());
  return true;
}

void RecordQueue::pop(std::size_t count) {
  ODAS_EXPECT(count <= bytes_.size() - sent_);
  sent_ += count;
  while (count > 0) {
    const std::size_t gone = std::min(count, sizes_.front());
    sizes_.front() -= gone;
    count -= gone;
    if (sizes_.front() == 0) sizes_.pop_front();
  }
  if (!empty()) return;
  bytes_.clear();
  sent_ = 0;
}

}  // namespace odas
