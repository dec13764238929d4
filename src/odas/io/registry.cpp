// SPDX-License-Identifier: MIT
#include "odas/io/registry.hpp"

#include <array>
#include <string_view>
#include <utility>

#include "odas/base/error.hpp"
#include "odas/io/audio_sink.hpp"
#include "odas/io/record_sink.hpp"
#include "odas/io/terminal_writer.hpp"
#include "odas/io/wav_writer.hpp"

namespace odas {
namespace {

// One line a place to write to.
struct WriterKind {
  std::string_view type;
  std::unique_ptr<ByteWriter> (*make)(const InterfaceConfig&, const SinkOptions&);
};
constexpr std::array kWriters{
    WriterKind{"file",
               [](const InterfaceConfig& to, const SinkOptions&) -> std::unique_ptr<ByteWriter> {
                 return std::make_unique<FileWriter>(to.path);
               }},
    WriterKind{"terminal",
               [](const InterfaceConfig&, const SinkOptions& options) -> std::unique_ptr<ByteWriter> {
                 return std::make_unique<TerminalWriter>(options.stop);
               }},
    WriterKind{"socket", nullptr},
};

// One line a format of text.
struct EncoderKind {
  std::string_view format;
  std::unique_ptr<HopEncoder> (*potentials)(const StreamClock&);
  std::unique_ptr<HopEncoder> (*tracks)(const StreamClock&);
};
constexpr std::array kEncoders{
    EncoderKind{"json", [](const StreamClock&) { return make_odas_json_potentials(); },
                [](const StreamClock&) { return make_odas_json_tracks(); }},
    EncoderKind{"jsonl", make_json_lines_potentials, make_json_lines_tracks},
    EncoderKind{"binary", [](const StreamClock&) { return make_binary_potentials(); }, nullptr},
};

template <class Table>
const auto* find(const Table& table, std::string_view name) {
  for (const auto& row : table) {
    if constexpr (requires { row.type; }) {
      if (row.type == name) return &row;
    } else {
      if (row.format == name) return &row;
    }
  }
  return static_cast<decltype(&table[0])>(nullptr);
}

bool listens(const InterfaceConfig& interface) { return interface.type != "blackhole"; }

/// What is not there, of all outputs at once.
class Missing {
 public:
  void add(std::string path, std::string what) {
    faults_.push_back({Fault::Severity::error, std::move(path), std::move(what), "", 0});
  }
  void check_interface(const std::string& path, const InterfaceConfig& to) {
    const WriterKind* kind = find(kWriters, to.type);
    if (listens(to) && (kind == nullptr || kind->make == nullptr)) {
      add(path + ".type", "is \"" + to.type + "\", which this version cannot do yet; use \"file\"");
    }
  }
  void raise() {
    if (!faults_.empty()) throw ConfigError(std::move(faults_));
  }

 private:
  std::vector<Fault> faults_;
};

void check(const Configuration& config) {
  Missing missing;
  missing.check_interface("ssl.potential.interface", config.potential.interface);
  missing.check_interface("sst.tracked.interface", config.tracked.interface);
  missing.check_interface("sss.separated.interface", config.separated.interface);
  missing.check_interface("sss.postfiltered.interface", config.postfiltered.interface);
  if (listens(config.category.interface)) {
    missing.add("classify.category.interface.type",
                "is \"" + config.category.interface.type +
                    "\", but this version cannot classify yet; use \"blackhole\"");
  }
  const auto format = [&](const char* path, const TextOutputConfig& output, auto member) {
    const EncoderKind* kind = find(kEncoders, output.format);
    if (listens(output.interface) && (kind == nullptr || kind->*member == nullptr)) {
      missing.add(path, "is \"" + output.format + "\", which this stream cannot be; use \"json\"");
    }
  };
  format("ssl.potential.format", config.potential, &EncoderKind::potentials);
  format("sst.tracked.format", config.tracked, &EncoderKind::tracks);
  missing.raise();
}

std::unique_ptr<Sink> make_audio_sink(AudioSink::Format format, const AudioOutputConfig& output,
                                      const SinkOptions& options) {
  const InterfaceConfig& to = output.interface;
  std::unique_ptr<ByteWriter> writer;
  if (to.type == "file" && to.path.ends_with(".wav")) {
    format.unsigned_bytes = output.n_bits == 8;
    writer = std::make_unique<WavWriter>(to.path, WavWriter::Format{output.fs, format.slots, output.n_bits});
  } else {
    writer = find(kWriters, to.type)->make(to, options);
  }
  return std::make_unique<AudioSink>(format, output, std::move(writer));
}

}  // namespace

std::vector<std::unique_ptr<Sink>> make_sinks(const Configuration& config, const SinkOptions& options) {
  check(config);
  const GeneralConfig& general = config.pipeline.general;
  const StreamClock clock{static_cast<double>(general.size.hop_size) / general.samplerate.mu, options.start};
  std::vector<std::unique_ptr<Sink>> sinks;
  const auto add_text = [&](const char* stream, const TextOutputConfig& output, auto member) {
    if (!listens(output.interface)) return;
    sinks.push_back(
        std::make_unique<RecordSink>(stream, (find(kEncoders, output.format)->*member)(clock),
                                     find(kWriters, output.interface.type)->make(output.interface, options)));
  };
  add_text("ssl.potential", config.potential, &EncoderKind::potentials);
  add_text("sst.tracked", config.tracked, &EncoderKind::tracks);

  AudioSink::Format format;
  format.slots = config.pipeline.sst.slots();
  format.hop = static_cast<std::size_t>(general.size.hop_size);
  format.sample_rate = general.samplerate.mu;
  if (listens(config.separated.interface)) {
    format.stream = AudioSink::Stream::separated;
    format.gain = config.pipeline.sss.gain_sep;
    sinks.push_back(make_audio_sink(format, config.separated, options));
  }
  if (listens(config.postfiltered.interface)) {
    format.stream = AudioSink::Stream::postfiltered;
    format.gain = config.pipeline.sss.gain_pf;
    sinks.push_back(make_audio_sink(format, config.postfiltered, options));
  }
  return sinks;
}

}  // namespace odas
