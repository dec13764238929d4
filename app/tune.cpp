// SPDX-License-Identifier: MIT
// odas tune: what E is where somebody speaks and where nobody does, measured where the array stands.
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <thread>

#include "commands.hpp"
#include "energy_measurement.hpp"
#include "png_canvas.hpp"
#include "progress.hpp"
#include "run_progress.hpp"
#include "stop.hpp"
#include "tune_text.hpp"
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "odas/base/error.hpp"
#include "odas/config/array_library.hpp"
#include "odas/config/edit.hpp"
#include "odas/config/reader.hpp"
#include "odas/config/source_text.hpp"
#include "odas/io/histogram_drawing.hpp"
#include "odas/io/recording.hpp"
#include "odas/io/registry.hpp"

namespace odas {
namespace {

namespace fs = std::filesystem;

struct TuneArguments {
  std::string array, silence, talk, out, svg, png;
  double seconds = 60;
};

/// Asked to stop: there is no measurement, and nothing is written.
void end_if_stopped() {
  if (!stop_on_signals()) return;
  say("stopped; nothing is written");
  throw ExitCode{0};
}

void count_down(const std::string& what, int seconds) {
  using namespace std::chrono_literals;
  say(what);
  for (int left = seconds; left > 0; --left) {
    std::fprintf(stderr, "  %d\n", left);
    for (int tenth = 0; tenth < 10; ++tenth) {
      end_if_stopped();
      std::this_thread::sleep_for(100ms);
    }
  }
}

class Measurement {
 public:
  explicit Measurement(LoadedConfiguration& loaded) : config_(loaded.config), pipeline_(make(loaded)) {}

  Energies of_file(const std::string& file) {
    const auto source = open_recording(file, config_.raw);
    return run(*source, 0);
  }

  /// Nobody is asked to be silent for a microphone that is not there.
  void expect_microphones() const {
    if (make_source(config_.raw)->live()) return;
    throw ConfigError("raw.interface",
                      "is a recording: give one of silence and one of talk, with --silence and --talk");
  }

  Energies of_room(double seconds) {
    const auto source = make_source(config_.raw);
    return run(*source, seconds);
  }

 private:
  static Pipeline make(LoadedConfiguration& loaded) {
    loaded.config.pipeline.wanted = {true, false, false, false};
    try {
      return Pipeline(loaded.config.pipeline);
    } catch (const ConfigError& error) { throw loaded.locations.locate(error); }
  }

  Energies run(AudioSource& source, double seconds) {
    Progress progress;
    const RunOptions options = shown_by(progress);
    const Energies energies = measure_energies(source, config_, pipeline_, seconds, options);
    progress.clear();
    end_if_stopped();
    constexpr double kLeast = 5;
    if (energies.seconds < kLeast) {
      throw IoError(
          fmt::format("{:.1f} s of sound are too little to measure: a minute is good, {} s the least",
                      energies.seconds, kLeast + 1));
    }
    return energies;
  }

  const Configuration& config_;
  Pipeline pipeline_;
};

/// The configuration as one file, with what it includes; only the mixtures are others.
std::string tuned(const fs::path& file, const MeasuredMixtures& found, const Energies& silence,
                  const Energies& talk) {
  std::vector<Fault> faults;
  std::string text = SourceText::from_file(file, faults).written();
  text = with_setting(text, "sst", "inactive",
                      mixture_value(found.inactive, fmt::format("odas tune: {:.0f} s of silence, and the "
                                                                "reflections of talk",
                                                                silence.seconds)));
  return with_setting(text, "sst", "active",
                      mixture_value(found.active, fmt::format("odas tune: {:.0f} % of {:.0f} s of talk",
                                                              100 * found.heard, talk.seconds)));
}

/// Whole, or not at all.
void write_file(const fs::path& file, const std::string& text) {
  fs::path part = file;
  part += ".part";
  std::ofstream stream(part, std::ios::binary);
  stream << text;
  stream.close();
  std::error_code error;
  if (stream) fs::rename(part, file, error);
  if (!stream || error) {
    std::error_code ignored;
    fs::remove(part, ignored);
    throw IoError("cannot write " + file.string() + (error ? ": " + error.message() : ""));
  }
}

void expect_another_file(const fs::path& out, const fs::path& file) {
  std::error_code ignored;
  if (!out.empty() && fs::equivalent(out, file, ignored)) {
    throw IoError(out.string() + " is the configuration itself: name another file with -o");
  }
}

void tune(const TuneArguments& arguments) {
  const fs::path file = find_configuration(arguments.array);
  LoadedConfiguration loaded = load_configuration(file);
  for (const Fault& fault : loaded.faults) std::fprintf(stderr, "%s\n", to_string(fault).c_str());
  expect_another_file(arguments.out, file);

  Measurement measurement(loaded);
  Energies silence, talk;
  if (!arguments.silence.empty()) {
    silence = measurement.of_file(arguments.silence);
    talk = measurement.of_file(arguments.talk);
  } else {
    measurement.expect_microphones();
    count_down(fmt::format("be silent for {:.0f} s; what always hums may hum on", arguments.seconds), 3);
    silence = measurement.of_room(arguments.seconds);
    count_down(fmt::format("one person now talks for {:.0f} s, here and there where people will be",
                           arguments.seconds),
               5);
    talk = measurement.of_room(arguments.seconds);
  }

  const MeasuredMixtures found = fit_mixtures(silence, talk);
  const Separation apart = separation(found.active, found.inactive);
  fmt::print("{}", histogram_text(silence, talk, apart.threshold));
  const auto on = [&](Canvas& canvas) {
    draw_histograms(canvas, arguments.array, silence, talk, found, apart.threshold);
  };
  if (!arguments.svg.empty()) write_svg(arguments.svg, kHistogramWidth, kHistogramHeight, on);
  if (!arguments.png.empty()) write_png(arguments.png, kHistogramWidth, kHistogramHeight, on);
  if (found.active.empty()) {
    throw IoError(
        "the talk cannot be told from the silence: nothing is written. Was the right array heard, and "
        "did somebody talk?");
  }
  fmt::print("\n{}", verdict(found, apart, silence));
  const std::string text = tuned(file, found, silence, talk);
  if (arguments.out.empty()) {
    fmt::print("\nsst.inactive = {};\nsst.active = {};\n", mixture_value(found.inactive, "silence"),
               mixture_value(found.active, "talk"));
  } else {
    write_file(arguments.out, text);
    say("written: " + arguments.out + "; odas live " + arguments.out);
  }
  if (std::fflush(stdout) != 0) throw IoError("cannot write to standard output");
}

}  // namespace

void add_tune(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("tune", "Measure silence and talk where the array stands, and tune to them");
  auto arguments = std::make_shared<TuneArguments>();
  command->add_option("ARRAY", arguments->array, "Configuration to tune: a file, or the name of an array")
      ->type_name("")
      ->required();
  command->add_option("-o,--out", arguments->out, "Tuned configuration to write")->type_name("FILE");
  CLI::Option* silence =
      command->add_option("--silence", arguments->silence, "Recording in which nobody speaks")
          ->type_name("FILE");
  CLI::Option* talk = command->add_option("--talk", arguments->talk, "Recording in which one person speaks")
                          ->type_name("FILE");
  silence->needs(talk);
  talk->needs(silence);
  command->add_option("--svg", arguments->svg, "Draw the histograms into this SVG")->type_name("FILE");
  command->add_option("--png", arguments->png, "Draw them into this PNG")->type_name("FILE");
  command->add_option("--seconds", arguments->seconds, "Length of each measurement, without recordings")
      ->type_name("S")
      ->check(CLI::Range(6.0, 3600.0))
      ->capture_default_str();
  command->footer(
      "Hears a minute of silence and a minute of talk from the source of the configuration, or takes two\n"
      "recordings; draws how often which energy E came, fits a mixture of Gaussians to each, and writes the\n"
      "configuration with these mixtures in sst.active and sst.inactive, all else as it was and what it "
      "includes\n"
      "put in. Without -o it only shows them. Ctrl-C ends it, and nothing is written.\n\n"
      "Examples:\n"
      "  odas tune respeaker_usb_4_mic -o kitchen.cfg\n"
      "  odas tune my_array.cfg --silence silence.wav --talk talk.wav -o tuned.cfg");
  command->callback([arguments] { tune(*arguments); });
}

}  // namespace odas
