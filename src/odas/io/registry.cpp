// SPDX-License-Identifier: MIT
#include "odas/io/registry.hpp"

#include <array>
#include <string_view>
#include <utility>

#include "odas/base/error.hpp"
#include "odas/io/audio_sink.hpp"
#include "odas/io/dial_writer.hpp"
#include "odas/io/listen_writer.hpp"
#include "odas/io/record_sink.hpp"
#include "odas/io/terminal_writer.hpp"
#include "odas/io/udp_writer.hpp"
#include "odas/io/voices_sink.hpp"
#include "odas/io/wav_writer.hpp"

namespace odas {
namespace {

// From a recording, a peer who reads is waited for; one who does not, no longer than this.
constexpr std::chrono::milliseconds kDialPatience{1000};

using Writer = std::unique_ptr<ByteWriter>;

/// What a writer is made of: the place, who asks, and what its messages begin with ("sst.tracked: ").
struct WriterOrder {
  const InterfaceConfig& to;
  const SinkOptions& options;
  std::string stream;

  [[nodiscard]] std::function<void(const std::string&)> say() const {
    if (!options.say) return {};
    return [told = options.say, stream = stream](const std::string& what) { told(stream + ": " + what); };
  }
  [[nodiscard]] PeerManners manners() const {
    return {options.live ? std::chrono::milliseconds(0) : kDialPatience, options.stop, say()};
  }
};

Writer to_file(const WriterOrder& order) { return std::make_unique<FileWriter>(order.to.path); }
Writer to_standard_output(const WriterOrder& order) {
  return std::make_unique<TerminalWriter>(order.options.stop, 1, !order.options.live);
}
Writer to_peer(const WriterOrder& order) {
  return std::make_unique<DialWriter>(order.to.ip, order.to.port, order.manners());
}
Writer to_clients(const WriterOrder& order) {
  return std::make_unique<ListenWriter>(order.to.ip, order.to.port, order.to.token, order.manners());
}
Writer to_udp(const WriterOrder& order) {
  return std::make_unique<UdpWriter>(order.to.ip, order.to.port, order.say());
}

// One line a place to write to.
struct WriterKind {
  std::string_view name;
  Writer (*make)(const WriterOrder&);
};
constexpr std::array kWriters{
    WriterKind{"file", to_file},
    WriterKind{"terminal", to_standard_output},
    WriterKind{"socket", to_peer},
    WriterKind{"stdout", to_standard_output},
    WriterKind{"socket_listen", to_clients},
    WriterKind{"udp", to_udp},
};

// One line a format of text.
struct EncoderKind {
  using Make = std::unique_ptr<HopEncoder> (*)(const StreamClock&);
  std::string_view name;
  Make potentials, tracks, categories;
};
constexpr std::array kEncoders{
    EncoderKind{"json", [](const StreamClock&) { return make_odas_json_potentials(); },
                [](const StreamClock&) { return make_odas_json_tracks(); },
                [](const StreamClock&) { return make_odas_json_categories(); }},
    EncoderKind{"jsonl", make_json_lines_potentials, make_json_lines_tracks, make_json_lines_categories},
    EncoderKind{"binary", [](const StreamClock&) { return make_binary_potentials(); }, nullptr, nullptr},
};

template <class Table>
const auto* find(const Table& table, std::string_view name) {
  for (const auto& row : table) {
    if (row.name == name) return &row;
  }
  return static_cast<decltype(&table[0])>(nullptr);
}

/// Makes the sinks, and keeps what is wrong of all of them.
class SinkMaker {
 public:
  SinkMaker(const Configuration& config, const SinkOptions& options)
      : pipeline_(config.pipeline),
        options_(options),
        clock_{static_cast<double>(config.pipeline.general.size.hop_size) /
                   config.pipeline.general.samplerate.mu,
               options.start} {}

  void add_text(const std::string& stream, const TextOutputConfig& output,
                EncoderKind::Make EncoderKind::*kind) {
    for (const Place& place : places_of(stream, output)) {
      const EncoderKind* encoder = find(kEncoders, place.format);
      const WriterKind* writer = writer_of(place);
      if (writer == nullptr) continue;
      if (encoder == nullptr || encoder->*kind == nullptr) {
        refuse(place.path,
               "has the format \"" + place.format + "\", which this stream cannot be; use \"json\"");
        continue;
      }
      orders_.push_back([=, this] {
        return std::make_unique<RecordSink>(stream, (encoder->*kind)(clock_),
                                            writer->make({*place.interface, options_, stream}));
      });
    }
  }

  void add_audio(const std::string& stream, const AudioOutputConfig& output, AudioSink::Stream which,
                 float gain) {
    const GeneralConfig& general = pipeline_.general;
    const AudioSink::Format format{which,
                                   pipeline_.sst.slots(),
                                   static_cast<std::size_t>(general.size.hop_size),
                                   general.samplerate.mu,
                                   gain,
                                   false};
    for (const Place& place : places_of(stream, output)) {
      const InterfaceConfig& to = *place.interface;
      if (to.type == "voices") {
        orders_.push_back([=, this, &to] {
          return std::make_unique<VoicesSink>(to.path, which, pipeline_, gain, options_.start);
        });
      } else if (to.type == "file" && to.path.ends_with(".wav")) {
        AudioSink::Format wav = format;
        wav.unsigned_bytes = output.n_bits == 8;
        orders_.push_back([=, &to, &output] {
          return std::make_unique<AudioSink>(
              wav, output,
              std::make_unique<WavWriter>(to.path, WavWriter::Format{output.fs, wav.slots, output.n_bits}));
        });
      } else if (const WriterKind* writer = writer_of(place)) {
        orders_.push_back([=, this, &to, &output] {
          return std::make_unique<AudioSink>(format, output, writer->make({to, options_, stream}));
        });
      }
    }
  }

  /// All of them, or none: throws before the first is opened.
  [[nodiscard]] std::vector<std::unique_ptr<Sink>> make() {
    if (!faults_.empty()) throw ConfigError(std::move(faults_));
    std::vector<std::unique_ptr<Sink>> sinks;
    for (const auto& order : orders_) sinks.push_back(order());
    return sinks;
  }

 private:
  const WriterKind* writer_of(const Place& place) {
    const std::string& type = place.interface->type;
    const WriterKind* kind = find(kWriters, type);
    if (kind == nullptr && type != "blackhole")
      refuse(place.path, "has the type \"" + type + "\", which this stream cannot go to");
    return kind;
  }
  void refuse(std::string path, std::string what) {
    faults_.push_back({Fault::Severity::error, std::move(path), std::move(what), "", 0});
  }

  const PipelineConfig& pipeline_;
  const SinkOptions& options_;
  StreamClock clock_;
  std::vector<std::function<std::unique_ptr<Sink>()>> orders_;
  std::vector<Fault> faults_;
};

}  // namespace

std::vector<std::unique_ptr<Sink>> make_sinks(const Configuration& config, const SinkOptions& options) {
  const SssConfig& sss = config.pipeline.sss;
  SinkMaker maker(config, options);
  maker.add_text("ssl.potential", config.potential, &EncoderKind::potentials);
  maker.add_text("sst.tracked", config.tracked, &EncoderKind::tracks);
  maker.add_text("classify.category", config.category, &EncoderKind::categories);
  maker.add_audio("sss.separated", config.separated, AudioSink::Stream::separated, sss.gain_sep);
  maker.add_audio("sss.postfiltered", config.postfiltered, AudioSink::Stream::postfiltered, sss.gain_pf);
  return maker.make();
}

}  // namespace odas
