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

namespace odas {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  Selection selection;
  std::string half = "both", keep, out;
  BenchListening listening;
  std::uint32_t seed = 1;
  std::size_t jobs = std::max(1U, std::thread::hardware_concurrency());
  bool list = false, json = false;
};

std::vector<BenchScene> chosen(const std::vector<BenchScene>& suite, Arguments& arguments) {
  if (arguments.half == "train") arguments.selection.half = Selection::Half::train;
  if (arguments.half == "test") arguments.selection.half = Selection::Half::test;
  for (const std::string& word : unknown_words(suite, arguments.selection.filter)) {
    throw ConfigError("--filter",
                      "no scene has '" + word + "'; odas bench accuracy --list shows what they have");
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

void report(const Arguments& arguments, const std::string& title, std::span<const BenchOutcome> outcomes,
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

void accuracy(Arguments& arguments) {
  const auto scenes = chosen(accuracy_suite(arguments.seed), arguments);
  if (arguments.list) return list(scenes);
  const auto configs = bench_configs(scenes, arguments.listening);
  std::vector<BenchOutcome> outcomes(scenes.size());
  Progress progress;
  for_each_in_parallel(
      scenes.size(), arguments.jobs, &stop_on_signals(), [&](double share) { progress.show(share); },
      [&](std::size_t i) {
        const BenchConfig& config = configs.at(scenes[i].array);
        const BenchSound sound = bench_sound(scenes[i], config.array, arguments.keep);
        Configuration listener = config.listener;
        listener.pipeline.wanted = {true, true, false, false};
        outcomes[i] = {scenes[i], score(sound.played.truth, std::nullopt, listen(sound.played, listener)),
                       bench_bound(sound, config.array)};
      });
  progress.clear();
  if (stop_on_signals()) {
    std::fprintf(stderr, "odas: stopped; there is no table of half a benchmark\n");
    return;
  }
  report(arguments, "odas bench accuracy", outcomes, accuracy_figures(), accuracy_panels());
}

void add_options(CLI::App* command, const std::shared_ptr<Arguments>& a) {
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
  command->require_subcommand(1);
  auto arguments = std::make_shared<Arguments>();
  CLI::App* accuracy_command = command->add_subcommand("accuracy", "Directions: recall, error, false tracks");
  add_options(accuracy_command, arguments);
  accuracy_command->footer(
      "Plays talkers and noise in rooms to arrays of 4 to 16 microphones, listens with the configurations "
      "of\n"
      "these arrays, and prints a table by condition (docs/benchmark.md). Needs espeak-ng, which speaks.\n\n"
      "Examples:\n"
      "  odas bench accuracy --half test -o accuracy\n"
      "  odas bench accuracy --half train --scenes 40 --keep scenes --set 'sst.P_new=0.05'\n"
      "  odas bench accuracy --filter 'mixed/ minidsp_uma8 snr=0' --odas");
  accuracy_command->callback([arguments] { accuracy(*arguments); });
}

}  // namespace odas
