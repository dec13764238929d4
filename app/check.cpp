// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include "commands.hpp"
#include <CLI/CLI.hpp>

#include "odas/config/array_library.hpp"
#include "odas/config/describe.hpp"
#include "odas/config/keys.hpp"
#include "odas/config/reader.hpp"
#include "odas/pipeline/pipeline.hpp"

namespace odas {

namespace {

/// Warnings go to stderr, errors are thrown, the plan is printed.
void check_file(const std::string& file) {
  const LoadedConfiguration loaded = load_configuration(find_configuration(file));
  for (const Fault& fault : loaded.faults) std::cerr << to_string(fault) << '\n';
  PipelineConfig pipeline = loaded.config.pipeline;
  pipeline.wanted.potentials = true;  // the search is shown even where nobody listens to it
  try {
    std::cout << describe_plan(loaded.config, Pipeline(pipeline).plan());
  } catch (const ConfigError& error) { throw loaded.locations.locate(error); }
}

}  // namespace

void add_check(CLI::App& app) {
  CLI::App* check =
      app.add_subcommand("check", "Say what is wrong with a configuration, or what it comes to");
  check->footer(
      "Prints every fault of FILE with its line (exit code 2 when one of them is an error), or else the\n"
      "array, the search, the latency and the ways of the sound.\n\n"
      "Examples:\n"
      "  odas check respeaker_usb_4_mic\n"
      "  odas check my_array.cfg\n"
      "  odas check --keys > keys.md\n");
  auto file = std::make_shared<std::string>();
  auto keys = std::make_shared<bool>(false);
  CLI::Option* file_option =
      check->add_option("FILE", *file, "Configuration to look at: a file, or the name of an array")
          ->type_name("");
  CLI::Option* keys_option = check->add_flag("--keys", *keys, "Print the reference of all keys, in Markdown");
  keys_option->excludes(file_option);
  check->callback([file, keys, file_option] {
    if (*keys) {
      std::cout << key_reference();
    } else if (file_option->count() == 0) {
      throw CLI::RequiredError("FILE or --keys");
    } else {
      check_file(*file);
    }
  });
}

}  // namespace odas
