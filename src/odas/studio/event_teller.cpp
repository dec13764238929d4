// SPDX-License-Identifier: MIT
#include "odas/studio/event_teller.hpp"

#include <nlohmann/json.hpp>

#include "odas/studio/wire.hpp"

namespace odas {

void EventTeller::begin(const StreamInfo& info) {
  end();
  info_ = info;
  last_ = 0;
}

void EventTeller::end() {
  for (const auto& [id, source] : known_) tell("disappear", source, last_);
  known_.clear();
  info_.reset();
}

void EventTeller::tell(const char* what, const Known& source, HopIndex time) const {
  const Track& track = source.track;
  tell_({{"type", "event"},
         {"event", what},
         {"run", info_->run},
         {"track", track.id},
         {"tag", track.tag.view()},
         {"direction", {track.direction.x, track.direction.y, track.direction.z}},
         {"class", static_cast<int>(source.told)},
         {"at", iso_time(info_->at(time))}});
}

void EventTeller::hop(const HopResult& hop) {
  if (!info_) return;
  last_ = hop.time;
  const auto held = static_cast<HopIndex>(kHeld * info_->sample_rate / static_cast<double>(info_->hop_size));
  for (const Track& track : hop.tracks) {
    if (track.id == 0) continue;
    const auto [found, is_new] = known_.try_emplace(track.id);
    Known& source = found->second;
    source.track = track;
    source.seen = hop.time;
    if (source.heard != track.category) {
      source.heard = track.category;
      source.since = hop.time;
    }
    if (is_new) {
      source.told = track.category;
      tell("appear", source, hop.time);
    } else if (source.heard != source.told && hop.time - source.since >= held) {
      source.told = source.heard;
      tell("class", source, hop.time);
    }
  }
  std::erase_if(known_, [&](const auto& entry) {
    if (entry.second.seen == hop.time) return false;
    tell("disappear", entry.second, hop.time);
    return true;
  });
}

}  // namespace odas
