// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <string>

#include "commands.hpp"
#include "configured_run.hpp"
#include "stop.hpp"
#include <CLI/CLI.hpp>

namespace odas {

void add_live(CLI::App& app) {
  CLI::App* live = app.add_subcommand("live", "Run a configuration as it stands: its source, its outputs");
  live->footer(
      "Listens to raw.interface of FILE and writes to the interfaces that FILE names, until the input ends\n"
      "or Ctrl-C is pressed; either way all files are finished and the exit code is 0.\n\n"
      "Examples:\n"
      "  odas live -c configs/respeaker_usb_4_mic.cfg\n"
      "  odas live -c my_array.cfg | jq .src      (with sst.tracked on the terminal, format jsonl)\n");
  auto file = std::make_shared<std::string>();
  auto verbose = std::make_shared<bool>(false);
  live->add_option("-c,--config", *file, "Configuration to run")->type_name("FILE")->required();
  live->add_flag("-v,--verbose", *verbose, "Say at the end what it has cost");
  live->callback([file, verbose] {
    const RunSummary summary = run_configuration(*file, {}, "odas", stop_on_signals());
    if (*verbose) std::fprintf(stderr, "%s\n", describe(summary.metrics).c_str());
    if (const int code = say_end(summary, "odas"); code != 0) throw ExitCode{code};
  });
}

}  // namespace odas
