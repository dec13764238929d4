// SPDX-License-Identifier: MIT
#include "odas/studio/client_feed.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>

#include <fmt/format.h>

namespace odas {
namespace {

constexpr std::size_t kMostHops = 250;        // of a message: two seconds
constexpr std::size_t kMostSamples = 0xFFFF;  // of a packet, as its header counts them

WireMessage text_of(std::string text) {
  return {false, std::make_shared<const std::string>(std::move(text))};
}

void put_level(std::string& to, float db) { fmt::format_to(std::back_inserter(to), "{:.1f}", db); }

}  // namespace

std::string beams_text(const HopRing::Beams& beams) {
  std::string text;
  const auto put = [&](float db) {
    text += ',';
    if (std::isfinite(db)) {
      put_level(text, db);
    } else {
      text += "null";
    }
  };
  for (const auto& [slot, report] : beams.beams) {
    fmt::format_to(std::back_inserter(text), "{}[{},{}", text.empty() ? "" : ",", slot, report.id);
    put(report.snr_db);
    put(report.white_noise_gain_db);
    put(report.condition_db);
    text += ']';
  }
  return text;
}

ClientFeed::ClientFeed(const HopRing& ring, std::function<std::string(std::uint64_t)> health)
    : ring_(ring), health_(std::move(health)) {}

void ClientFeed::subscribe(Subscription subscription, Clock::time_point now) {
  const bool had_hops = subscription_.rate_of("hops") > 0;
  std::vector<Voice> voices;
  for (const Subscription::Audio& wanted : subscription.audio) {
    const auto same = std::find_if(voices_.begin(), voices_.end(),
                                   [&](const Voice& voice) { return voice.wanted == wanted; });
    voices.push_back(same != voices_.end() ? *same : Voice{wanted});
  }
  if (voices_.empty()) next_sound_ = ring_.end_number();
  voices_ = std::move(voices);
  if (!had_hops) next_hop_ = ring_.end_number();
  subscription_ = std::move(subscription);
  due_.clear();
  for (const auto& topic : subscription_.topics) due_[topic.first] = now;
}

void ClientFeed::put(std::shared_ptr<const std::string> text, bool may_be_lost) {
  text_bytes_ += text->size();
  texts_.push_back({std::move(text), may_be_lost});
  while (texts_.size() > kMostTexts || text_bytes_ > kMostTextBytes) {
    const auto oldest =
        std::find_if(texts_.begin(), texts_.end(), [](const Text& waiting) { return waiting.may_be_lost; });
    if (oldest == texts_.end()) return;
    text_bytes_ -= oldest->bytes->size();
    texts_.erase(oldest);
    ++lost_;
  }
}

std::optional<WireMessage> ClientFeed::next(Clock::time_point now) {
  if (!texts_.empty()) {
    WireMessage message{false, std::move(texts_.front().bytes)};
    texts_.pop_front();
    text_bytes_ -= message.bytes->size();
    return message;
  }
  meet_run();
  if (!info_) return is_due("health", now) ? std::optional(text_of(health_(lost_))) : std::nullopt;
  if (sound_.empty() && !voices_.empty()) read_audio();
  if (!sound_.empty()) {
    WireMessage message = std::move(sound_.front());
    sound_.pop_front();
    return message;
  }
  // What is due and has nothing new to say stays due.
  const auto try_topic = [&](const char* topic, auto make) -> std::optional<WireMessage> {
    const auto due = due_.find(topic);
    if (due == due_.end() || now < due->second) return std::nullopt;
    const double rate = subscription_.rate_of(topic);
    if (rate <= 0) return std::nullopt;
    auto message = make();
    if (message) {
      const auto period =
          std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / rate));
      due->second = std::max(due->second + period, now);
    }
    return message;
  };
  if (auto message = try_topic("hops", [&] { return hops(); })) return message;
  if (auto message = try_topic("meters", [&] { return meters(); })) return message;
  if (auto message = try_topic("power", [&] { return power(); })) return message;
  if (auto message = try_topic("beams", [&] { return beams(); })) return message;
  return try_topic("health", [&] { return std::optional(text_of(health_(lost_))); });
}

bool ClientFeed::is_due(const std::string& topic, Clock::time_point now) {
  const double rate = subscription_.rate_of(topic);
  const auto due = due_.find(topic);
  if (rate <= 0 || due == due_.end() || now < due->second) return false;
  due->second = now + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / rate));
  return true;
}

void ClientFeed::meet_run() {
  if (ring_.run_id() == run_) return;
  info_ = ring_.run();
  run_ = info_ ? info_->run : 0;
  readings_ = 0;
  power_time_ = beams_time_ = 0;
  sound_.clear();
  for (Voice& voice : voices_) voice = Voice{voice.wanted};
}

std::optional<WireMessage> ClientFeed::hops() {
  const HopRing::Reading reading = ring_.read(next_hop_, kMostHops);
  if (reading.run != run_) return std::nullopt;
  next_hop_ = reading.first;
  if (reading.lost > 0) {
    lost_ += reading.lost;
    return text_of(fmt::format(R"({{"type":"gap","run":{},"hops":{}}})", run_, reading.lost));
  }
  std::string text = fmt::format(R"({{"type":"hops","run":{},"hops":[)", run_);
  const std::size_t empty = text.size();
  for (const HopRing::Frame& frame : reading.frames) {
    const std::string& hop = subscription_.potentials ? frame->full : frame->bare;
    if (hop.empty()) continue;  // of before somebody asked
    if (text.size() > empty) text += ',';
    text += hop;
  }
  next_hop_ += reading.frames.size();
  if (text.size() == empty) return std::nullopt;
  return text_of(text + "]}");
}

std::optional<WireMessage> ClientFeed::meters() {
  MeterReading reading;
  const std::uint64_t number = ring_.meters(reading);
  if (number == readings_ || reading.mics.empty()) return std::nullopt;
  readings_ = number;
  std::string text = fmt::format(R"({{"type":"meters","run":{},"t":{},"mics":[)", run_, reading.time);
  for (const MeterReading::Mic& mic : reading.mics) {
    text += '[';
    put_level(text, mic.rms_db);
    text += ',';
    put_level(text, mic.peak_db);
    fmt::format_to(std::back_inserter(text), ",{}", mic.flags);
    if (mic.same_as != 0) fmt::format_to(std::back_inserter(text), ",{}", mic.same_as);
    text += "],";
  }
  text.back() = ']';
  return text_of(text + "}");
}

std::optional<WireMessage> ClientFeed::power() {
  HopRing::Power power;
  if (ring_.power(power) == power_time_ || power.energy.empty()) return std::nullopt;
  power_time_ = power.time;
  float scale = 1e-6F;
  for (const float energy : power.energy) scale = std::max(scale, energy);
  std::string bytes(AudioHeader::kSize, '\0');
  bytes[0] = 2;
  bytes[1] = bytes[2] = 1;
  const auto count = static_cast<std::uint32_t>(power.energy.size());
  std::memcpy(&bytes[4], &count, 4);
  std::memcpy(&bytes[8], &power.time, 8);
  std::memcpy(&bytes[16], &scale, 4);
  for (const float energy : power.energy) {
    bytes += static_cast<char>(static_cast<unsigned char>(std::clamp(energy / scale, 0.0F, 1.0F) * 255));
  }
  return WireMessage{true, std::make_shared<const std::string>(std::move(bytes))};
}

std::optional<WireMessage> ClientFeed::beams() {
  const HopRing::Beams beams = ring_.beams();
  if (beams.time == beams_time_) return std::nullopt;
  beams_time_ = beams.time;
  return text_of(
      fmt::format(R"({{"type":"beams","run":{},"t":{},"beams":[{}]}})", run_, beams.time, beams_text(beams)));
}

void ClientFeed::read_audio() {
  const HopRing::Reading reading = ring_.read(next_sound_, kMostHops);
  if (reading.run != run_) return;
  next_sound_ = reading.first + reading.frames.size();
  if (reading.lost > 0) lost_ += voices_.size();
  for (Voice& voice : voices_) {
    std::string packet;
    AudioHeader header;
    for (const HopRing::Frame& frame : reading.frames) add_sound(voice, *frame, *info_, packet, header);
    close_packet(packet, header);
  }
}

void ClientFeed::add_sound(Voice& voice, const HopFrame& frame, const StreamInfo& info, std::string& packet,
                           AudioHeader& header) {
  const bool raw = voice.wanted.stream == AudioStream::raw;
  const std::vector<std::int16_t>& pcm = frame.pcm[static_cast<std::size_t>(voice.wanted.stream)];
  const auto at = std::find(frame.ids.begin(), frame.ids.end(), voice.wanted.track);
  const std::size_t row = raw ? voice.wanted.track - 1U : static_cast<std::size_t>(at - frame.ids.begin());
  const std::size_t hop = info.hop_size;
  const bool is_there = voice.wanted.track != 0 && (raw || at != frame.ids.end());
  if (!is_there || (row + 1) * hop > pcm.size()) {
    if (voice.heard && !is_there) {  // the track has ended
      if (packet.empty()) header = {voice.wanted.stream, voice.wanted.track, voice.next_index};
      header.flags |= AudioHeader::kLast;
      header.rate = static_cast<std::uint32_t>(info.sample_rate);
      close_packet(packet, header);
      header = {};
      voice.heard = false;
    }
    return;
  }
  const std::uint64_t index = (frame.time - 1) * hop;
  const bool follows = voice.heard && index == voice.next_index;
  if (!packet.empty() && (!follows || header.samples + hop > kMostSamples)) close_packet(packet, header);
  if (packet.empty()) {
    header = {voice.wanted.stream, voice.wanted.track, index, static_cast<std::uint32_t>(info.sample_rate)};
    if (voice.heard && !follows) header.flags |= AudioHeader::kGap;
  }
  packet.append(reinterpret_cast<const char*>(pcm.data() + row * hop), hop * sizeof(std::int16_t));
  header.samples = static_cast<std::uint16_t>(header.samples + hop);
  voice.heard = true;
  voice.next_index = index + hop;
}

/// Sends what there is: samples, or the end of a track.
void ClientFeed::close_packet(std::string& packet, const AudioHeader& header) {
  if (packet.empty() && (header.flags & AudioHeader::kLast) == 0) return;
  std::vector<char> bytes;
  append_header(bytes, header);
  std::string whole(bytes.begin(), bytes.end());
  whole += packet;
  sound_.push_back({true, std::make_shared<const std::string>(std::move(whole))});
  packet.clear();
}

}  // namespace odas
