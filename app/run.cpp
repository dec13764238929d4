// SPDX-License-Identifier: MIT
// odas run: a recording in, a folder out: directions, voices and a report.
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "progress.hpp"
#include "run_progress.hpp"
#include "run_report.hpp"
#include "stop.hpp"
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "odas/base/error.hpp"
#include "odas/config/array_library.hpp"
#include "odas/config/reader.hpp"
#include "odas/engine/offline.hpp"
#include "odas/io/recording.hpp"
#include "odas/io/registry.hpp"
#include "odas/io/report_reference.hpp"
#include "odas/io/report_sink.hpp"
#include "odas/pipeline/pipeline.hpp"

namespace odas {
namespace {

namespace fs = std::filesystem;

struct RunArguments {
  std::string recording, config, out;
  bool odas_files = false;
};

constexpr std::array kFiles{"tracks.jsonl", "potentials.jsonl", kReferenceFile, "report.html"};
constexpr std::array kOdasFiles{"tracks.json", "pots.json", "separated.raw", "postfiltered.raw"};

/// The folder for the results. The files that an earlier run left there are removed, and nothing else.
fs::path prepare_folder(const RunArguments& arguments) {
  const fs::path out = arguments.out;
  std::error_code error;
  if (fs::exists(out, error) && !fs::is_directory(out, error)) {
    throw IoError(out.string() + " is a file: name a folder for the results with -o");
  }
  fs::create_directories(out, error);
  if (error) throw IoError("cannot make the folder " + out.string() + ": " + error.message());
  std::vector<fs::path> files(kFiles.begin(), kFiles.end());
  // Those of an earlier run with --odas-files would pass for ours: odas score looks for them first.
  const bool was_here = fs::exists(out / "report.html", error);
  if (arguments.odas_files || was_here) files.insert(files.end(), kOdasFiles.begin(), kOdasFiles.end());
  for (const fs::path& name : files) {
    const fs::path file = out / name;
    if (fs::equivalent(file, arguments.recording, error)) {
      throw IoError("the result " + file.string() +
                    " would overwrite the recording: choose another folder with -o");
    }
    fs::remove(file, error);
    if (error) throw IoError("cannot replace " + file.string() + ": " + error.message());
  }
  return out;
}

/// The outputs of the configuration do not count here: what is computed is what this command writes.
Pipeline make_pipeline(LoadedConfiguration& loaded, bool postfiltered) {
  loaded.config.pipeline.wanted = {true, true, true, postfiltered, loaded.config.pipeline.classify.in_tracks};
  try {
    return Pipeline(loaded.config.pipeline);
  } catch (const ConfigError& error) { throw loaded.locations.locate(error); }
}

RunSummary process(AudioSource& source, const Configuration& config, Pipeline& pipeline,
                   std::span<Sink* const> sinks) {
  Progress progress;
  const RunOptions options = shown_by(progress);
  return run_offline(source, config, pipeline, sinks, options);
}

TextOutputConfig text_file(const char* format, const fs::path& file) {
  TextOutputConfig output;
  output.format = format;
  output.interface.type = "file";
  output.interface.path = file.string();
  return output;
}

AudioOutputConfig audio_file(const GeneralConfig& general, const fs::path& file) {
  AudioOutputConfig output;
  if (general.samplerate.mu == output.fs) output.hop_size = general.size.hop_size;
  output.interface.type = "file";
  output.interface.path = file.string();
  return output;
}

/// The sinks beside the report, made as those of a configuration that names these files.
std::vector<std::unique_ptr<Sink>> file_sinks(Configuration config, const fs::path& out, bool odas_files) {
  config.category = {};
  config.separated = config.postfiltered = {};
  config.potential = text_file("jsonl", out / "potentials.jsonl");
  config.tracked = text_file("jsonl", out / "tracks.jsonl");
  std::vector<std::unique_ptr<Sink>> sinks = make_sinks(config);
  if (!odas_files) return sinks;
  config.potential = text_file("json", out / "pots.json");
  config.tracked = text_file("json", out / "tracks.json");
  config.separated = audio_file(config.pipeline.general, out / "separated.raw");
  config.postfiltered = audio_file(config.pipeline.general, out / "postfiltered.raw");
  for (auto& sink : make_sinks(config)) sinks.push_back(std::move(sink));
  return sinks;
}

/// Where microphone 1 is among the channels of the recording; none where it is mapped to silence.
std::optional<std::size_t> reference_channel(const Configuration& config) {
  const int channel = config.mapping.map.empty() ? 1 : config.mapping.map.front();
  if (channel < 1) return std::nullopt;
  return static_cast<std::size_t>(channel - 1);
}

void print_table(const ReportSink& report) {
  const std::string table =
      table_of(report.history().sources(), [](std::uint64_t id) { return "voices/" + voice_file_name(id); });
  std::fputs(table.c_str(), stdout);
  if (std::fflush(stdout) != 0) throw IoError("cannot write to standard output");
}

/// Who was where on stdout; all else on stderr.
void tell(const RunFacts& facts, const RunSummary& summary, const ReportSink& report, const fs::path& out) {
  print_table(report);
  const double seconds = static_cast<double>(summary.frames) / facts.sample_rate;
  say(fmt::format("{:.1f} s of sound in {:.2f} s, {}", seconds, facts.work_seconds,
                  speed_text(seconds, facts.work_seconds)));
  say("report: " + (out / "report.html").string());
  if (summary.end == RunSummary::End::stopped) {
    say(fmt::format("stopped at {:.1f} s; all files are finished", seconds));
  }
}

void run(const RunArguments& arguments) {
  LoadedConfiguration loaded = load_configuration(find_configuration(arguments.config));
  RunFacts facts;
  for (const Fault& fault : loaded.faults) {
    std::fprintf(stderr, "%s\n", to_string(fault).c_str());
    facts.warnings.push_back(to_string(fault));
  }
  const std::unique_ptr<AudioSource> recording = open_recording(arguments.recording, loaded.config.raw);
  Pipeline pipeline = make_pipeline(loaded, arguments.odas_files);
  const fs::path out = prepare_folder(arguments);

  ReportSink report(out, loaded.config.pipeline);
  const auto files = file_sinks(loaded.config, out, arguments.odas_files);
  std::vector<Sink*> sinks{&report};
  for (const auto& file : files) sinks.push_back(file.get());
  std::optional<ReferenceTap> reference;
  if (const auto channel = reference_channel(loaded.config); channel && *channel < recording->channels()) {
    reference.emplace(*recording, *channel, out / kReferenceFile);
  }

  const auto start = std::chrono::steady_clock::now();
  const RunSummary summary = process(reference ? *reference : *recording, loaded.config, pipeline, sinks);
  const IoStatus kept = reference ? reference->close() : IoStatus();

  facts.recording = arguments.recording;
  facts.config_file = arguments.config;
  facts.channels = recording->channels();
  facts.sample_rate = recording->sample_rate();
  facts.reference = reference.has_value();
  facts.work_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  facts.warnings.insert(facts.warnings.end(), summary.warnings.begin(), summary.warnings.end());
  if (summary.end == RunSummary::End::sink_failed) {
    throw IoError(summary.fault + "; the run ends here, what was written is whole");
  }
  // A recording that broke off is told last: what was heard of it comes first.
  if (!kept.ok() && summary.exit_code() == 0) throw IoError(kept.what());
  write_run_report(out, facts, summary, loaded.config.pipeline, report);
  tell(facts, summary, report, out);
  if (summary.exit_code() != 0) throw IoError(summary.fault);
}

}  // namespace

void add_run(CLI::App& app) {
  CLI::App* command = app.add_subcommand("run", "Process a recording: directions, voices and a report");
  auto arguments = std::make_shared<RunArguments>();
  command
      ->add_option("RECORDING", arguments->recording,
                   "WAV, FLAC, or headerless as `raw` of the configuration says")
      ->type_name("")
      ->required();
  command
      ->add_option("-c,--config", arguments->config,
                   "Configuration of the microphone array: a file, or its name")
      ->type_name("FILE")
      ->required();
  command->add_option("-o,--out", arguments->out, "Folder for the results; made where it is absent")
      ->type_name("FOLDER")
      ->required();
  command->add_flag("--odas-files", arguments->odas_files,
                    "Write ODAS's own formats, too: tracks.json, pots.json, separated.raw, postfiltered.raw");
  command->footer(
      "Writes into the folder:\n"
      "  report.html        who was where, in one page for any browser, with the voices to listen to\n"
      "  voices/            one WAV per followed source, source_ID.wav, and index.json\n"
      "  tracks.jsonl       followed sources, a line a hop\n"
      "  potentials.jsonl   directions that may hold a source, a line a hop\n"
      "  microphone_1.wav   the first microphone, to compare\n"
      "and prints who was where. Files of an earlier run in the folder are replaced.\n\n"
      "Examples:\n"
      "  odas run meeting.wav -c respeaker_usb_4_mic -o meeting\n"
      "  odas run capture.raw -c my_array.cfg -o out --odas-files");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace odas
