// SPDX-License-Identifier: MIT
// odas bench: how well it hears, over hundreds of simulated scenes.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <thread>

#include "bench_configs.hpp"
#include "bench_plots.hpp"
#include "commands.hpp"
#include "progress.hpp"
#include "stop.hpp"
#include <CLI/CLI.hpp>

#include "odas/base/error.hpp"
#include "odas/scene/bench_run.hpp"
#include "odas/scene/bench_suite.hpp"
#include "odas/scene/bench_text.hpp"
#include "odas/scene/ideal_mask.hpp"

namespace odas {
namespace {

namespace fs = std::filesystem;

struct BenchArguments {
  Selection selection;
  std::string kind, half = "both", keep, out;
  BenchListening listening;
  std::uint32_t seed = 1;
  std::size_t jobs = std::max(1U, std::thread::hardware_concurrency());
  bool list = false, json = false;
};

std::vector<BenchScene> chosen(const std::vector<BenchScene>& suite, BenchArguments& arguments) {
  if (arguments.half == "train") arguments.selection.half = Selection::Half::train;
  if (arguments.half == "test") arguments.selection.half = Selection::Half::test;
  for (const std::string& word : unknown_words(suite, arguments.selection.filter)) {
    throw ConfigError("--filter", "no scene has '" + word + "'; --list shows what they have");
  }
  auto scenes = select(suite, arguments.selection);
  if (scenes.empty()) throw ConfigError("--filter", "no scene is left");
  return scenes;
}

void list(const std::vector<BenchScene>& scenes) {
  for (const BenchScene& scene : scenes) std::printf("%s\n", scene.text().c_str());
}

void write_file(const fs::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw IoError("cannot write " + file.string());
}

void report(const BenchArguments& arguments, const std::string& title, std::span<const BenchOutcome> outcomes,
            std::span<const BenchFigure> figures, std::span<const BenchPanel> panels) {
  const auto tables = tables_of(outcomes, figures);
  const std::string markdown = bench_markdown(tables, figures);
  const std::string json = bench_json(outcomes, tables, figures);
  std::fputs((arguments.json ? json : markdown).c_str(), stdout);
  if (std::fflush(stdout) != 0) throw IoError("cannot write to standard output");
  if (arguments.out.empty()) return;
  std::error_code error;
  fs::create_directories(arguments.out, error);
  if (error) throw IoError("cannot make the folder " + arguments.out + ": " + error.message());
  const fs::path out = arguments.out;
  write_file(out / "bench.md", markdown);
  write_file(out / "bench.json", json);
  write_file(out / "bench.svg", bench_svg(title, tables, figures, panels));
}

/// What is measured, and how it is shown.
struct Bench {
  const char* title;
  std::vector<BenchScene> (*suite)(std::uint32_t seed);
  std::vector<BenchFigure> (*figures)();
  std::vector<BenchPanel> (*panels)();
  bool voices;
};

BenchOutcome play(const BenchScene& scene, const BenchConfig& config, const std::string& keep, bool voices) {
  const BenchSound sound = bench_sound(scene, config.array, keep);
  Configuration listener = config.listener;
  listener.pipeline.wanted = {true, true, voices, voices};
  const Audition heard = listen(sound.played, std::move(listener));
  BenchOutcome outcome;
  outcome.scene = scene;
  outcome.score = score(sound.played.truth, voices ? std::optional(sound.played.sound) : std::nullopt, heard);
  outcome.bound = bench_bound(sound, config.array);
  if (voices) outcome.ideal_mask_sdr_db = ideal_mask_sdr_db(sound.played.sound);
  return outcome;
}

void run_bench(const Bench& bench, BenchArguments& arguments) {
  const auto scenes = chosen(bench.suite(arguments.seed), arguments);
  if (arguments.list) return list(scenes);
  const auto configs = bench_configs(scenes, arguments.listening);
  std::vector<BenchOutcome> outcomes(scenes.size());
  Progress progress;
  for_each_in_parallel(
      scenes.size(), arguments.jobs, &stop_on_signals(), [&](double share) { progress.show(share); },
      [&](std::size_t i) {
        outcomes[i] = play(scenes[i], configs.at(scenes[i].array), arguments.keep, bench.voices);
      });
  progress.clear();
  if (stop_on_signals()) {
    std::fprintf(stderr, "odas: stopped; there is no table of half a benchmark\n");
    return;
  }
  report(arguments, bench.title, outcomes, bench.figures(), bench.panels());
}

constexpr Bench kAccuracy{"odas bench accuracy", accuracy_suite, accuracy_figures, accuracy_panels, false};
constexpr Bench kSeparation{"odas bench separation", separation_suite, separation_figures, separation_panels,
                            true};

void add_options(CLI::App* command, const std::shared_ptr<BenchArguments>& a) {
  command->add_option("--scenes", a->selection.most, "Not more scenes than these, evenly from all")
      ->type_name("N");
  command->add_option("--half", a->half, "train: to tune on; test: to report on; both")
      ->check(CLI::IsMember({"train", "test", "both"}))
      ->type_name("HALF");
  command
      ->add_option("--filter", a->selection.filter, "Words that a scene must have: 'mixed/ snr=0 talkers=2'")
      ->type_name("WORDS");
  command->add_option("--seed", a->seed, "Another seed makes other scenes of the same kinds")->type_name("N");
  command->add_option("--jobs", a->jobs, "Scenes at once")->type_name("N")->check(CLI::Range(1, 256));
  command->add_option("--keep", a->keep, "Keep the scenes here, and take them from here the next time")
      ->type_name("FOLDER");
  command
      ->add_option(
          "--config", a->listening.files,
          "Listen with this file in place of the array's of the same name; or with those of a folder")
      ->type_name("FILE");
  command->add_option("--set", a->listening.settings, "One setting more in all of them: group.key=value")
      ->type_name("SETTING");
  command->add_flag("--odas", a->listening.like_odas, "Listen as ODAS does with its own file for the array");
  command->add_option("-o,--out", a->out, "Write bench.md, bench.json and bench.svg here")
      ->type_name("FOLDER");
  command->add_flag("--json", a->json, "Print JSON in place of the table");
  command->add_flag("--list", a->list, "Only say which scenes there are");
}

}  // namespace

void add_bench(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("bench", "Measure how well it hears, over hundreds of simulated scenes");
  const auto arguments = std::make_shared<BenchArguments>();
  command->add_option("KIND", arguments->kind, "accuracy: directions; separation: voices")
      ->check(CLI::IsMember({"accuracy", "separation"}))
      ->type_name("")
      ->required();
  add_options(command, arguments);
  command->footer(
      "accuracy plays talkers and noise in rooms to arrays of 4 to 16 microphones, listens with the\n"
      "configurations of these arrays, and prints recall, error and false tracks by condition. separation "
      "prints\n"
      "SDR, SI-SDR, SIR and STOI of microphone 1 and of the voices of whom odas itself follows, and beside "
      "them\n"
      "the SDR of the ideal ratio mask. Both need espeak-ng, which speaks (docs/benchmark.md).\n\n"
      "Examples:\n"
      "  odas bench accuracy --half test -o accuracy\n"
      "  odas bench accuracy --half train --scenes 40 --keep scenes --set 'sst.P_new=0.05'\n"
      "  odas bench accuracy --filter 'mixed/ minidsp_uma8 snr=0' --odas\n"
      "  odas bench separation --half test -o separation");
  command->callback([arguments] {
    const bool voices = arguments->kind == "separation";
    run_bench(voices ? kSeparation : kAccuracy, *arguments);
  });
}

}  // namespace odas
