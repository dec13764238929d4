// SPDX-License-Identifier: MIT
#include <array>
#include <csignal>
#include <iostream>

#include "commands.hpp"
#include <CLI/CLI.hpp>

#include "odas/base/error.hpp"

namespace {

constexpr int kRunTimeFailure = 1;
constexpr int kWrongUsage = 2;

constexpr std::array kCommands{
    odas::add_run,      odas::add_live,  odas::add_studio, odas::add_devices,     odas::add_arrays,
    odas::add_array,    odas::add_check, odas::add_tune,   odas::add_learn_noise, odas::add_targets,
    odas::add_simulate, odas::add_score, odas::add_bench};

int run(int argc, char** argv) {
  CLI::App app("odas: artificial hearing for machines", "odas");
  app.set_version_flag("--version", "odas " ODAS_VERSION);
  app.require_subcommand(1);
  app.failure_message(CLI::FailureMessage::help);
  app.footer(
      "'odas COMMAND --help' tells more of each.\n\n"
      "Examples:\n"
      "  odas live respeaker_usb_4_mic\n"
      "  odas run samples/sample_4mic.flac -c sample -o out\n\n"
      "Exit codes: 0 the input ended, or Ctrl-C; 1 something failed; 2 wrong usage or configuration.");
  for (const auto add : kCommands) add(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Help and version come as errors too, with code 0.
    if (error.get_exit_code() == 0) return app.exit(error);
    std::cerr << "odas: " << error.what() << "\nRun 'odas --help', or 'odas COMMAND --help'.\n";
    return kWrongUsage;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  // A reader that goes away and a file that may not grow are error values, not our end.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return run(argc, argv);
  } catch (const odas::ExitCode& exit) { return exit.code; } catch (const odas::ConfigError& error) {
    std::cerr << error.what() << '\n';
    return kWrongUsage;
  } catch (const std::exception& error) {
    std::cerr << "odas: " << error.what() << '\n';
    return kRunTimeFailure;
  }
}
