// SPDX-License-Identifier: MIT
// What stands for the Studio in a build without it (ODAS_WITH_STUDIO=OFF).
#include "commands.hpp"
#include "studio_run.hpp"

#include "odas/base/error.hpp"

namespace odas {

void add_studio(CLI::App& /*app*/) {}

int live_with_studio(const std::string& /*file*/, const std::string& /*address*/) {
  throw ConfigError("--studio", "this odas was built without the Studio");
}

}  // namespace odas
