// SPDX-License-Identifier: MIT
// odas learn-noise: what the machine itself sounds like, kept so that separation can null it.
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "first_seconds.hpp"
#include "progress.hpp"
#include "run_progress.hpp"
#include "stop.hpp"
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "odas/base/error.hpp"
#include "odas/config/array_library.hpp"
#include "odas/config/noise_file.hpp"
#include "odas/config/reader.hpp"
#include "odas/dsp/noise_learner.hpp"
#include "odas/dsp/stft.hpp"
#include "odas/engine/live.hpp"
#include "odas/engine/offline.hpp"
#include "odas/io/recording.hpp"
#include "odas/io/registry.hpp"

namespace odas {
namespace {

constexpr double kLeast = 3;              // s of noise
constexpr double kToleratedSpeech = 0.1;  // of the seconds: machines start and stop, too

struct LearnArguments {
  std::string array, out;
  std::vector<std::string> recordings;
  double seconds = 30;
  std::size_t entries = NoiseDictionary::kMostEntries;
  bool anyway = false;
};

/// The configuration; that the dictionary which it names is not there yet is no fault here.
LoadedConfiguration load(const std::filesystem::path& file) {
  LoadedConfiguration loaded = read_configuration(file);
  std::erase_if(loaded.faults, [](const Fault& fault) { return fault.path == "sss.noise"; });
  if (!loaded.ok()) throw ConfigError(std::move(loaded.faults));
  for (const Fault& fault : loaded.faults) std::fprintf(stderr, "%s\n", to_string(fault).c_str());
  loaded.config.pipeline.wanted = {false, false, false, false, false, true};
  loaded.config.pipeline.known_noise = {};
  return loaded;
}

/// The microphones as the pipeline hears them, in the frames of separation.
class LearningSink : public Sink {
 public:
  explicit LearningSink(const PipelineConfig& config)
      : stft_(config.general.mics.size(), static_cast<std::size_t>(config.general.size.hop_size),
              separation_frame(config)),
        spectra_(config.general.mics.size(), stft_.bins()),
        learner_(config.general.samplerate.mu, static_cast<std::size_t>(config.general.size.hop_size),
                 separation_frame(config), places(config.general)) {}

  [[nodiscard]] std::string name() const override { return "noise"; }
  [[nodiscard]] Wanted wanted() const noexcept override { return {false, false, false, false, false, true}; }
  IoStatus write(const HopResult& hop) override {
    stft_.analyse(hop.mics, spectra_);
    learner_.hear(spectra_);
    return {};
  }

  [[nodiscard]] const NoiseLearner& learner() const noexcept { return learner_; }

 private:
  static std::vector<Vec3> places(const GeneralConfig& general) {
    std::vector<Vec3> places;
    for (const MicConfig& mic : general.mics) places.push_back({mic.mu[0], mic.mu[1], mic.mu[2]});
    return places;
  }

  Stft stft_;
  Grid<cfloat> spectra_;
  NoiseLearner learner_;
};

void listen(AudioSource& source, const Configuration& config, LearningSink& sink) {
  Progress progress;
  const RunOptions options = shown_by(progress);
  Pipeline pipeline(config.pipeline);
  const std::array<Sink*, 1> sinks{&sink};
  const auto run = source.live() ? run_live : run_offline;
  const RunSummary summary = run(source, config, pipeline, sinks, options);
  progress.clear();
  if (summary.exit_code() != 0) throw IoError(summary.fault);
  if (stop_on_signals()) {
    say("stopped; nothing is written");
    throw ExitCode{0};
  }
}

/// Speech that became noise would be nulled ever after.
void expect_no_speech(const NoiseLearner& learner, bool anyway) {
  const auto& uneven = learner.uneven();
  if (static_cast<double>(uneven.size()) <= kToleratedSpeech * learner.seconds()) return;
  const std::string what = fmt::format("{} of {:.0f} s go up and down in level as speech does, first at {} s",
                                       uneven.size(), learner.seconds(), uneven.front());
  if (!anyway) {
    throw IoError(what +
                  ": nothing is written. Record the machine alone, or say --anyway if it is that uneven");
  }
  say("warning: " + what);
}

void learn_noise(const LearnArguments& arguments) {
  const LoadedConfiguration loaded = load(find_configuration(arguments.array));
  const Configuration& config = loaded.config;
  LearningSink sink(config.pipeline);
  for (const std::string& recording : arguments.recordings) {
    listen(*open_recording(recording, config.raw), config, sink);
  }
  if (arguments.recordings.empty()) {
    const auto source = make_source(config.raw);
    say(fmt::format("listening for {:.0f} s: let the machine do all that it does, and be silent",
                    arguments.seconds));
    FirstSeconds part(*source, arguments.seconds);
    listen(part, config, sink);
  }
  if (sink.learner().seconds() < kLeast) {
    throw IoError(fmt::format("{:.1f} s of sound are too little to learn from: 30 s are good, {} s the least",
                              sink.learner().seconds(), kLeast));
  }
  expect_no_speech(sink.learner(), arguments.anyway);
  const NoiseDictionary dictionary = sink.learner().learn(arguments.entries);
  write_noise_file(dictionary, arguments.out);
  fmt::print("{:.0f} s, {} {}\n", sink.learner().seconds(), dictionary.entries.size(),
             dictionary.entries.size() == 1 ? "state" : "states");
  for (std::size_t e = 0; e < dictionary.entries.size(); ++e) {
    fmt::print("  {}: {:.0f} % of the time, likeness {:.2f}\n", e + 1, 100 * dictionary.entries[e].share,
               dictionary.entries[e].likeness);
  }
  if (std::fflush(stdout) != 0) throw IoError("cannot write to standard output");
  say(fmt::format("written: {}; name it in the configuration: sss: {{ noise = \"{}\"; ... }}", arguments.out,
                  std::filesystem::path(arguments.out).filename().string()));
}

}  // namespace

void add_learn_noise(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("learn-noise", "Learn the machine's own noise, so that separation can null it");
  auto arguments = std::make_shared<LearnArguments>();
  command->add_option("ARRAY", arguments->array, "Configuration: a file, or the name of an array")
      ->type_name("")
      ->required();
  command
      ->add_option("RECORDING", arguments->recordings, "Recordings of the noise; without, the array is heard")
      ->type_name("");
  command->add_option("-o,--out", arguments->out, "Dictionary to write")->type_name("FILE")->required();
  command->add_option("--seconds", arguments->seconds, "How long to listen, without recordings")
      ->type_name("S")
      ->check(CLI::Range(3.0, 3600.0))
      ->capture_default_str();
  command->add_option("--entries", arguments->entries, "Most states of the machine to tell apart")
      ->type_name("N")
      ->check(CLI::Range(std::size_t{1}, NoiseDictionary::kMostEntries))
      ->capture_default_str();
  command->add_flag("--anyway", arguments->anyway, "Take recordings that are as uneven as speech");
  command->footer(
      "Hears the machine's fans and motors while nobody speaks, and keeps how they sound at each "
      "microphone,\n"
      "for each of the machine's states. With sss.noise = \"FILE\" in the configuration an adaptive "
      "beamformer\n"
      "(sss.mode_sep) nulls them from the first word on. docs/noise.md tells more.\n\n"
      "Examples:\n"
      "  odas learn-noise respeaker_usb_4_mic -o fans.noise\n"
      "  odas learn-noise my_robot.cfg idle.wav driving.wav -o my_robot.noise");
  command->callback([arguments] { learn_noise(*arguments); });
}

}  // namespace odas
