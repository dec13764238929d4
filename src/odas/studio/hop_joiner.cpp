// SPDX-License-Identifier: MIT
#include "odas/studio/hop_joiner.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace odas {
namespace {

constexpr std::array kVoices{AudioStream::separated, AudioStream::postfiltered};
constexpr std::chrono::milliseconds kForPotentials{50};
constexpr HopIndex kLongestJump = 1'000'000;  // hops: beyond it a stamp is nonsense, or another run
constexpr double kUsualMost = 0.5;            // s: the streams of one program are never further apart

}  // namespace

HopJoiner::HopJoiner(const Config& config, HopListener& to, Say say)
    : config_(config), to_(to), say_(std::move(say)) {
  const Resampler check(config_.channels, config_.sound_rate, config_.rate, kMostFrames, config_.hop);
}

void HopJoiner::begin(StreamKind kind, Clock::time_point now) {
  if (kind == StreamKind::potentials) {
    has_potentials_ = true;
    last_potential_ = 0;
    potentials_.clear();
  }
  if (kind != StreamKind::tracks) return;
  end_run();
  has_run_ = false;
  tracks_begun_ = now;
}

void HopJoiner::begin(AudioStream stream, Clock::time_point now) {
  Sound& sound = of(stream);
  sound = {};
  sound.connected = true;
  sound.begun = now;
  sound.to_hops = std::make_unique<Resampler>(config_.channels, config_.sound_rate, config_.rate, kMostFrames,
                                              config_.hop);
  if (running_) match(stream);
}

void HopJoiner::end(StreamKind kind) {
  if (kind == StreamKind::potentials) has_potentials_ = false;
  if (kind != StreamKind::tracks) return;
  end_run();
}

void HopJoiner::end(AudioStream stream) {
  // What has come is still given to its hops.
  of(stream).connected = false;
}

void HopJoiner::begin_run(const StreamRecord& first) {
  running_ = true;
  // Stamps that begin anew within a connection: the sound does not say where it does.
  const bool is_first = !std::exchange(has_run_, true);
  from_the_start_ = is_first && first.time == 1;
  slots_ = first.is_line ? std::max(first.tracks.size(), config_.channels) : first.tracks.size();
  last_ = first.time - 1;
  second_ = {};
  StreamInfo info;
  info.run = ++run_;
  info.name = config_.name;
  info.source = config_.source;
  info.kind = StreamInfo::Kind::odas;
  info.sample_rate = config_.rate;
  info.hop_size = config_.hop;
  info.slots = slots_;
  const double before = static_cast<double>((first.time - 1) * config_.hop) / config_.rate;
  info.start =
      std::chrono::system_clock::now() -
      std::chrono::duration_cast<std::chrono::system_clock::duration>(std::chrono::duration<double>(before));
  to_.begin(info);
  for (const AudioStream stream : kVoices) {
    if (of(stream).connected) match(stream);
  }
}

void HopJoiner::end_run() {
  if (!running_) return;
  while (!waiting_.empty()) give_one();
  running_ = false;
  to_.end();
}

void HopJoiner::match(AudioStream stream) {
  Sound& sound = of(stream);
  const auto apart = sound.begun > tracks_begun_ ? sound.begun - tracks_begun_ : tracks_begun_ - sound.begun;
  if (!from_the_start_ || apart > kTogether) {
    part(stream,
         "it was joined under way, and whose voices these are cannot be told: start the sender again, "
         "after this");
  } else if (config_.channels != slots_) {
    part(stream, fmt::format("tracks have {} rows and the sound {} channels: say how many it has", slots_,
                             config_.channels));
  } else {
    sound.matched = true;
  }
}

void HopJoiner::part(AudioStream stream, const std::string& why) {
  Sound& sound = of(stream);
  sound.matched = false;
  sound.waiting.clear();
  say_("warning", fmt::format("the voices '{}' are not shown: {}", name_of(stream), why));
}

void HopJoiner::add(const StreamRecord& record, Clock::time_point now) {
  if (record.kind == StreamKind::potentials) {
    last_potential_ = record.time;
    potentials_.push_back(record);
    if (potentials_.size() > kMostWaiting) potentials_.pop_front();
    return;
  }
  if (record.kind != StreamKind::tracks || record.time == 0) return;
  const bool goes_on =
      running_ && record.time > last_ && record.time - last_ < kLongestJump && record.tracks.size() == slots_;
  // jsonl leaves empty slots out: then fewer rows are no other run.
  const bool is_line = running_ && record.is_line && record.time > last_;
  if (!goes_on && !is_line) {
    end_run();
    begin_run(record);
  }
  last_ = record.time;
  waiting_.push_back({record, now});
  waiting_.back().record.tracks.resize(slots_);
}

bool HopJoiner::is_full_of(AudioStream stream) const noexcept {
  return sounds_[static_cast<std::size_t>(stream)].waiting.size() >= kMostWaiting;
}

void HopJoiner::add(AudioStream stream, GridView<const float> block) {
  Sound& sound = of(stream);
  if (!sound.to_hops) return;
  sound.to_hops->push(block);
  Grid<float> hop(config_.channels, config_.hop);
  while (sound.to_hops->pop(hop)) {
    // Before the first tracks it is not known yet whether it fits them.
    const bool may_fit = sound.matched || (!running_ && sound.next + sound.waiting.size() <= kMostWaiting);
    if (may_fit) {
      sound.waiting.push_back(hop);
    } else {
      ++sound.next;
    }
  }
}

bool HopJoiner::is_ready(const Waiting& head, Clock::time_point now) {
  const HopIndex time = head.record.time;
  if (has_potentials_ && last_potential_ < time && now - head.since < kForPotentials) return false;
  for (const AudioStream stream : kVoices) {
    Sound& sound = of(stream);
    if (!sound.matched || sound.next + sound.waiting.size() > time) continue;
    if (!sound.connected) {
      sound.matched = false;  // it has gone, and nothing of it is left
    } else if (now - head.since > kPatience) {
      part(stream, "it has stopped coming, and goes on without saying where");
    } else {
      return false;
    }
  }
  return true;
}

void HopJoiner::give(Clock::time_point now) {
  watch_for_slips(now);
  while (!waiting_.empty() && is_ready(waiting_.front(), now)) give_one();
}

void HopJoiner::give_one() {
  const StreamRecord record = std::move(waiting_.front().record);
  waiting_.pop_front();
  HopResult hop;
  hop.time = record.time;
  hop.tracks = record.tracks;
  std::vector<Potential> potentials;
  while (!potentials_.empty() && potentials_.front().time <= record.time) {
    if (potentials_.front().time == record.time) potentials = potentials_.front().potentials;
    potentials_.pop_front();
  }
  hop.potentials = potentials;
  std::array<Grid<float>, 2> voices;
  for (const AudioStream stream : kVoices) {
    Sound& sound = of(stream);
    if (!sound.matched) continue;
    // Hops whose tracks were lost have no voice.
    for (; sound.next < record.time && !sound.waiting.empty(); ++sound.next) sound.waiting.pop_front();
    if (sound.next != record.time || sound.waiting.empty()) continue;
    voices[static_cast<std::size_t>(stream)] = std::move(sound.waiting.front());
    sound.waiting.pop_front();
    ++sound.next;
  }
  hop.separated = voices[0].view();
  hop.postfiltered = voices[1].view();
  to_.hop(hop);
}

/// Sound that was lost on its way makes all that follows too early. While everything comes as it is heard,
/// sound and tracks stay as far apart as they were: a second in which they are further apart than before, at
/// their nearest, tells. (What is read from a file comes faster, and nothing can be told.)
void HopJoiner::watch_for_slips(Clock::time_point now) {
  if (!running_) return;
  const double hop_s = static_cast<double>(config_.hop) / config_.rate;
  const auto ahead = [&](const Sound& sound) {
    return (static_cast<double>(sound.next + sound.waiting.size() - 1) - static_cast<double>(last_)) * hop_s;
  };
  if (second_ == Clock::time_point{}) {
    second_ = now;
    second_from_ = last_;
    for (Sound& sound : sounds_) sound.ahead = ahead(sound);
  }
  for (Sound& sound : sounds_) sound.ahead = std::max(sound.ahead, ahead(sound));
  const std::chrono::duration<double> passed = now - second_;
  if (passed.count() < 1) return;
  const double pace = static_cast<double>(last_ - second_from_) * hop_s / passed.count();
  const bool as_heard = pace > 0.7 && pace < 1.5;
  for (const AudioStream stream : kVoices) {
    Sound& sound = of(stream);
    if (!sound.matched || !sound.connected || !as_heard) continue;
    if (!sound.usual) {
      sound.usual = sound.ahead;
      if (std::abs(sound.ahead) > kUsualMost) part(stream, "sound and tracks are not of the same time");
    } else if (sound.ahead < *sound.usual - kSlip) {
      part(stream, fmt::format("{:.0f} ms of sound are missing, or its rate is not {} Hz",
                               1000 * (*sound.usual - sound.ahead), config_.sound_rate));
    } else if (sound.ahead > *sound.usual + kSlip) {
      part(stream, fmt::format("there are {:.0f} ms of sound too much: is its rate {} Hz?",
                               1000 * (sound.ahead - *sound.usual), config_.sound_rate));
    }
  }
  second_ = {};
}

}  // namespace odas
