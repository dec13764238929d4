// SPDX-License-Identifier: MIT
#include "odas/studio/session_recorder.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "odas/io/pcm.hpp"
#include "odas/io/voices_sink.hpp"
#include "odas/studio/little_endian.hpp"
#include "odas/studio/own_file.hpp"

namespace odas {
namespace {

using std::chrono::system_clock;

constexpr std::size_t kPacket = 1024;  // samples, about: 24 bytes of head are then nothing
constexpr std::size_t kPcmBytes = 2;

}  // namespace

SessionRecorder::SessionRecorder(const std::filesystem::path& folder, Streams audio)
    : file_(free_name(folder, compact_time(system_clock::now()), ".mcap"), "odas"), audio_(audio) {
  run_ = file_.add_channel({"run", "json"});
  hops_ = file_.add_channel({"hops", "json"});
  for (std::size_t i = 0; i < kAudioStreams; ++i) {
    sound_[i] = file_.add_channel({std::string("audio/") + name_of(static_cast<AudioStream>(i)), "odas"});
  }
  std::size_t i = 0;
  for (const char* topic : {"log", "event", "transcript"}) {
    texts_[i++] = {topic, file_.add_channel({topic, "json"})};
  }
}

std::string SessionRecorder::name() const { return std::filesystem::path(file_.where()).filename().string(); }

void SessionRecorder::put(std::uint16_t channel, double time_s, std::span<const char> data) {
  const auto since = std::chrono::duration_cast<std::chrono::nanoseconds>(info_->start.time_since_epoch());
  const auto ns = since.count() + std::llround(time_s * 1e9);
  IoStatus status = file_.write(channel, static_cast<std::uint64_t>(std::max<std::int64_t>(ns, 0)), data);
  if (status_.ok()) status_ = std::move(status);
}

IoStatus SessionRecorder::begin(const StreamInfo& info, HopIndex last) {
  if (info_) {
    for (auto& packets : packets_) {
      for (Packet& packet : packets) put_packet(packet, AudioHeader::kLast);
      packets.clear();
    }
  }
  info_ = info;
  last_ = last;
  put(run_, static_cast<double>(last * info.hop_size) / info.sample_rate, run_message(info).dump());
  return status();
}

IoStatus SessionRecorder::hop(const HopResult& hop) {
  if (!info_ || hop.time <= last_) return {};
  text_.clear();
  append_hop(text_, hop);
  put(hops_, static_cast<double>((hop.time - 1) * info_->hop_size) / info_->sample_rate, text_);
  for (std::size_t i = 0; i < kAudioStreams; ++i) {
    if (audio_[i]) hear(hop, static_cast<AudioStream>(i));
  }
  seconds_ += static_cast<double>((last_ == 0 ? 1 : hop.time - last_) * info_->hop_size) / info_->sample_rate;
  last_ = hop.time;
  return status();
}

void SessionRecorder::hear(const HopResult& hop, AudioStream stream) {
  const GridView<const float> audio = audio_of(hop, stream);
  const bool raw = stream == AudioStream::raw;
  std::vector<Packet>& packets = packets_[static_cast<std::size_t>(stream)];
  const std::size_t rows = raw ? audio.rows() : std::min(audio.rows(), hop.tracks.size());
  if (packets.size() < rows) packets.resize(rows);
  bytes_.resize(audio.cols() * kPcmBytes);
  for (std::size_t i = 0; i < rows; ++i) {
    Packet& packet = packets[i];
    const auto id = static_cast<std::uint32_t>(raw ? i + 1 : hop.tracks[i].id);
    if (packet.header.track != id) put_packet(packet, AudioHeader::kLast);
    const std::uint64_t index = (hop.time - 1) * info_->hop_size;
    const std::uint64_t expected = packet.header.index + packet.samples.size() / kPcmBytes;
    const bool torn = packet.header.track == id && index != expected;
    if (torn) put_packet(packet, 0);
    if (packet.samples.empty()) {
      packet.header = {stream, id,
                       index,  static_cast<std::uint32_t>(info_->sample_rate),
                       0,      torn ? AudioHeader::kGap : std::uint16_t{0}};
    }
    if (id == 0) continue;
    encode_pcm(GridView<const float>(audio[i].data(), 1, audio.cols()), gain_of(*info_, stream), 16, bytes_);
    put_bytes(packet.samples, bytes_);
    if (packet.samples.size() >= kPacket * kPcmBytes) put_packet(packet, 0);
  }
}

void SessionRecorder::put_packet(Packet& packet, std::uint16_t flags) {
  AudioHeader& header = packet.header;
  const bool last = (flags & AudioHeader::kLast) != 0;
  // A voice that ends is told so, even if all of it has been written.
  if (header.track == 0 || (packet.samples.empty() && !last)) return;
  header.samples = static_cast<std::uint16_t>(packet.samples.size() / kPcmBytes);
  header.flags = static_cast<std::uint16_t>(header.flags | flags);
  message_.clear();
  append_header(message_, header);
  put_bytes(message_, packet.samples);
  const double delay = header.stream == AudioStream::raw ? 0 : info_->voice_delay_s;
  put(sound_[static_cast<std::size_t>(header.stream)],
      static_cast<double>(header.index) / info_->sample_rate - delay, message_);
  header.index += header.samples;
  header.flags = 0;
  packet.samples.clear();
  if (last) header.track = 0;
}

IoStatus SessionRecorder::add(const std::string& topic, const nlohmann::json& message) {
  const auto found =
      std::find_if(texts_.begin(), texts_.end(), [&](const auto& text) { return text.first == topic; });
  if (!info_ || found == texts_.end()) return {};
  put(found->second, static_cast<double>(last_ * info_->hop_size) / info_->sample_rate,
      message.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  return status();
}

IoStatus SessionRecorder::flush() {
  for (auto& packets : packets_) {
    for (Packet& packet : packets) put_packet(packet, 0);
  }
  IoStatus written = status();
  IoStatus flushed = file_.flush();
  return written.ok() ? flushed : written;
}

IoStatus SessionRecorder::close() {
  IoStatus flushed = flush();
  IoStatus closed = file_.close();
  return flushed.ok() ? closed : flushed;
}

}  // namespace odas
