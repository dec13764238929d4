// SPDX-License-Identifier: MIT
#include "odas/io/pulse_source.hpp"

#include <algorithm>
#include <array>
#include <thread>
#include <utility>

#include <pulse/pulseaudio.h>

#include "odas/base/error.hpp"
#include "odas/io/pulse_client.hpp"

namespace odas {
namespace {

using std::chrono::milliseconds;

constexpr auto kFirstRetry = milliseconds(100), kLongestRetry = milliseconds(3000);

pa_sample_format_t pulse_format(SampleFormat format) {
  switch (format) {
    case SampleFormat::s8:
    case SampleFormat::u8:
      return PA_SAMPLE_U8;
    case SampleFormat::s16:
      return PA_SAMPLE_S16LE;
    case SampleFormat::s24_3:
      return PA_SAMPLE_S24LE;
    case SampleFormat::s24:
      return PA_SAMPLE_S24_32LE;
    case SampleFormat::s32:
      return PA_SAMPLE_S32LE;
    case SampleFormat::f32:
      return PA_SAMPLE_FLOAT32LE;
  }
  return PA_SAMPLE_S16LE;
}

/// By names where the user gave them, else by numbers alone.
pa_channel_map map_of(const RawConfig& raw) {
  pa_channel_map map;
  const auto channels = static_cast<unsigned>(raw.n_channels);
  pa_channel_map_init_extend(&map, channels, PA_CHANNEL_MAP_AUX);
  for (std::size_t c = 0; c < raw.interface.channelmap.size(); ++c) {
    const std::string& name = raw.interface.channelmap[c];
    map.map[c] = pa_channel_position_from_string(name.c_str());
    if (map.map[c] == PA_CHANNEL_POSITION_INVALID) {
      throw ConfigError("raw.interface.channelmap[" + std::to_string(c) + "]",
                        "is \"" + name +
                            "\", which is no position that PulseAudio knows; front-left, "
                            "front-right, aux0, aux1, ... are");
    }
  }
  return map;
}

}  // namespace

struct PulseSource::Connection {
  PulseClient client;
  pa_stream* stream = nullptr;
  SampleFormat format = SampleFormat::s16;
  std::size_t frame = 0;  // bytes
  std::size_t used = 0;   // bytes of the fragment that is being read

  ~Connection() {
    if (stream == nullptr) return;
    pa_stream_disconnect(stream);
    pa_stream_unref(stream);
  }
};

PulseSource::PulseSource(const RawConfig& raw)
    : raw_(raw), channels_(static_cast<std::size_t>(raw.n_channels)), away_(raw.fs) {
  if (raw.n_channels > static_cast<int>(PA_CHANNELS_MAX)) {
    throw ConfigError("raw.nChannels", "is " + std::to_string(raw.n_channels) + ", PulseAudio has at most " +
                                           std::to_string(PA_CHANNELS_MAX));
  }
  static_cast<void>(map_of(raw));  // names of positions that are none are said first
  const Refusal refusal = connect(Clock::now() + std::chrono::seconds(5), true);
  if (refusal.misfit) throw ConfigError("raw", refusal.why);
  if (!refusal.why.empty()) throw IoError(refusal.why);
}

PulseSource::~PulseSource() = default;

PulseSource::Refusal PulseSource::connect(Clock::time_point deadline, bool first) {
  const std::string& name = raw_.interface.source;
  const std::string what = "cannot open the source " + name + " of PulseAudio: ";
  auto connection = std::make_unique<Connection>();
  PulseClient& client = connection->client;
  if (const std::string fault = client.connect(deadline, first); !fault.empty()) {
    return {what + fault + "; does a server run for this user? pactl info says"};
  }
  const std::optional<PulseDevice> device = client.source(name, deadline);
  if (!device) return {what + "there is none of this name; 'odas devices' lists those that are there"};

  CaptureOffer any = device->offer;  // the server converts, but it has no more microphones than there are
  any.min_channels = 1;
  any.channels.clear();
  any.rates.clear();
  any.min_rate = 1;
  any.max_rate = static_cast<int>(PA_RATE_MAX);
  any.formats = wanted_formats(raw_);
  if (const std::string wrong = misfit(name, raw_, any); !wrong.empty()) return {wrong, true};
  const bool best = raw_.format == "auto";
  connection->format = best ? device->offer.formats.front() : wanted_formats(raw_).front();
  if (connection->format == SampleFormat::s8) connection->format = SampleFormat::u8;
  connection->frame = channels_ * bytes_of(connection->format);
  if (first && device->offer.min_rate != raw_.fs) {
    notice_ = name + " has " + std::to_string(device->offer.min_rate) +
              " Hz, which PulseAudio resamples to " + std::to_string(raw_.fs) +
              "; raw.fS = " + std::to_string(device->offer.min_rate) + " would leave that to odas";
  }

  const pa_sample_spec spec{pulse_format(connection->format), static_cast<std::uint32_t>(raw_.fs),
                            static_cast<std::uint8_t>(raw_.n_channels)};
  const pa_channel_map map = map_of(raw_);
  connection->stream = pa_stream_new(client.context(), "microphones", &spec, &map);
  if (connection->stream == nullptr) return {what + client.error()};
  pa_buffer_attr buffer;
  std::fill_n(reinterpret_cast<unsigned char*>(&buffer), sizeof buffer, static_cast<unsigned char>(0xFF));
  buffer.fragsize = static_cast<std::uint32_t>(connection->frame * static_cast<std::size_t>(raw_.hop_size));
  // Not to be moved to another microphone when ours is pulled out: we wait for it.
  unsigned flags = PA_STREAM_ADJUST_LATENCY | PA_STREAM_DONT_MOVE | PA_STREAM_NO_REMIX_CHANNELS;
  if (raw_.interface.channelmap.empty()) flags |= PA_STREAM_NO_REMAP_CHANNELS;
  if (pa_stream_connect_record(connection->stream, device->name.c_str(), &buffer,
                               static_cast<pa_stream_flags_t>(flags)) < 0) {
    return {what + client.error()};
  }
  for (;;) {
    const pa_stream_state_t state = pa_stream_get_state(connection->stream);
    if (state == PA_STREAM_READY) break;
    if (!PA_STREAM_IS_GOOD(state)) return {what + client.error()};
    if (Clock::now() >= deadline) return {what + "no answer"};
    client.run(deadline - Clock::now());
  }
  connection_ = std::move(connection);
  heard_ = Clock::now();
  return {};
}

ReadResult PulseSource::read(GridView<float> block) {
  ReadResult result;
  result.notice = std::exchange(notice_, "");
  const Clock::time_point deadline = Clock::now() + kReadPatience;
  while (result.frames == 0 && result.lost == 0) {
    if (!connection_) {
      reconnect(result);
      return result;
    }
    PulseClient& client = connection_->client;
    if (!client.good() || pa_stream_get_state(connection_->stream) != PA_STREAM_READY) {
      lose(client.good() ? "was taken away" : "is gone with its server (" + client.error() + ")", result);
      return result;
    }
    take(block, result);
    if (result.frames > 0 || Clock::now() >= deadline) return result;
    client.run(deadline - Clock::now());
  }
  return result;
}

/// What has come, up to a block. A hole in it ends the block: the frames lost come before those of the
/// next.
void PulseSource::take(GridView<float> block, ReadResult& result) {
  Connection& c = *connection_;
  while (result.frames < block.cols()) {
    const void* data = nullptr;
    std::size_t bytes = 0;
    if (pa_stream_peek(c.stream, &data, &bytes) < 0 || bytes == 0) return;
    heard_ = Clock::now();
    if (data == nullptr) {
      if (result.frames > 0) return;
      result.lost += bytes / c.frame;
      pa_stream_drop(c.stream);
      continue;
    }
    const std::size_t n = std::min((bytes - c.used) / c.frame, block.cols() - result.frames);
    decode_samples({static_cast<const char*>(data) + c.used, n * c.frame}, c.format,
                   GridView<float>(block.data() + result.frames, block.rows(), n, block.stride()));
    result.frames += n;
    c.used += n * c.frame;
    if (c.used + c.frame <= bytes) return;
    c.used = 0;
    pa_stream_drop(c.stream);
  }
}

void PulseSource::lose(const std::string& why, ReadResult& result) {
  result.notice += raw_.interface.source + " " + why + "; waiting until it is back";
  connection_.reset();
  away_.start(heard_);
  pause_ = kFirstRetry;
  next_try_ = Clock::now() + pause_;
}

void PulseSource::reconnect(ReadResult& result) {
  const Clock::time_point now = Clock::now();
  if (now < next_try_) {
    std::this_thread::sleep_for(std::min<Clock::duration>(next_try_ - now, kReadPatience));
    result.lost += away_.take(Clock::now());
    return;
  }
  // One that does not fit is another device: ours may yet come.
  const bool back = connect(now + milliseconds(500), false).why.empty();
  result.lost += away_.take(Clock::now());
  if (back) {
    away_.stop();
    result.notice += raw_.interface.source + " is back";
    return;
  }
  pause_ = std::min<Clock::duration>(2 * pause_, kLongestRetry);
  next_try_ = Clock::now() + pause_;
}

}  // namespace odas
