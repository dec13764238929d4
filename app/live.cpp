// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <string>

#include "commands.hpp"
#include "configured_run.hpp"
#include "stop.hpp"
#include "studio_run.hpp"
#include <CLI/CLI.hpp>

#include "odas/config/array_library.hpp"

namespace odas {
void add_live(CLI::App& app) {
  CLI::App* live = app.add_subcommand("live", "Run a configuration as it stands: its source, its outputs");
  live->footer(
      "Listens to raw.interface of the configuration and writes to the interfaces that it names, until the\n"
      "input ends or Ctrl-C is pressed; either way all files are finished and the exit code is 0.\n\n"
      "Examples:\n"
      "  odas live respeaker_usb_4_mic            (odas arrays lists the names)\n"
      "  odas live -c my_array.cfg | jq .src      (with sst.tracked on the terminal, format jsonl)\n");
  auto file = std::make_shared<std::string>();
  auto verbose = std::make_shared<bool>(false);
  CLI::Option* by_name =
      live->add_option("ARRAY", *file, "Configuration to run: a file, or the name of an array")
          ->type_name("");
  CLI::Option* by_option = live->add_option("-c,--config", *file, "The same")->type_name("FILE");
  by_name->excludes(by_option);
  live->add_flag("-v,--verbose", *verbose, "Say at the end what it has cost");
  auto address = std::make_shared<std::string>();
  CLI::Option* studio =
      live->add_option("--studio", *address, "Serve the Studio, too: at 127.0.0.1:8080, or where this says")
          ->type_name("[ADDRESS:PORT]")
          ->expected(0, 1);
  live->callback([file, verbose, address, studio] {
    if (file->empty()) throw CLI::RequiredError("ARRAY");
    if (studio->count() > 0) {
      if (const int code = live_with_studio(*file, *address); code != 0) throw ExitCode{code};
      return;
    }
    const RunSummary summary =
        run_configuration(find_configuration(*file).string(), {}, "odas", stop_on_signals());
    if (*verbose) std::fprintf(stderr, "%s\n", describe(summary.metrics).c_str());
    if (const int code = say_end(summary, "odas"); code != 0) throw ExitCode{code};
  });
}

}  // namespace odas
