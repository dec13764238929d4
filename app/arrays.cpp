// SPDX-License-Identifier: MIT
// odas arrays: the configurations that are known by name.
#include <cstdio>
#include <memory>

#include "commands.hpp"
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "odas/base/error.hpp"
#include "odas/config/array_library.hpp"

namespace odas {
namespace {

void list(bool paths) {
  const auto files = array_files(array_folders());
  if (files.empty()) throw IoError("there are no arrays in ./configs, /etc/odas or beside the program");
  std::size_t width = 0;
  for (const ArrayFile& file : files) width = std::max(width, file.name.size());
  for (const ArrayFile& file : files) {
    fmt::print("{:<{}}  {}\n", file.name, width,
               paths ? absolute(file.path).lexically_normal().string() : file.title);
  }
  if (std::fflush(stdout) != 0) throw IoError("cannot write to standard output");
}

}  // namespace

void add_arrays(CLI::App& app) {
  CLI::App* arrays = app.add_subcommand("arrays", "List the microphone arrays that are known by name");
  arrays->footer(
      "A name stands wherever a command takes a configuration. It is looked for as NAME.cfg in ./configs, "
      "in\n"
      "/etc/odas (yours), and among the arrays that come with odas; the first one counts.\n\n"
      "Examples:\n"
      "  odas arrays\n"
      "  odas live respeaker_usb_4_mic\n"
      "  cp $(odas arrays --paths | awk '$1 == \"pepper\" {print $2}') my_array.cfg\n");
  auto paths = std::make_shared<bool>(false);
  arrays->add_flag("-p,--paths", *paths, "Print where each file is, in place of what it is for");
  arrays->callback([paths] { list(*paths); });
}

}  // namespace odas
