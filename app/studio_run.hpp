// SPDX-License-Identifier: MIT
// What `odas studio` and `odas live --studio` share.
#pragma once

#include <string>

#include "odas/studio/studio.hpp"

namespace odas {

/// Puts `ADDRESS:PORT`, `ADDRESS`, `PORT` or `:PORT` into the configuration of the page. Throws ConfigError.
void set_address(StudioConfig& config, const std::string& address);

struct StudioRun {
  StudioOptions studio;
  bool qr = true;           // shows the link as a QR code where it leads beyond this machine
  bool any_port = false;    // where the port is taken, another one will do
  bool ends_alone = false;  // ends when the run does, as `odas live`; else only when asked to
};
/// Serves until Ctrl-C, or the end of the run. The exit code.
int serve_studio(StudioRun run);

/// A configuration as it stands, all its outputs too, and the page: at `address`, or where the file says. The
/// exit code.
int live_with_studio(const std::string& file, const std::string& address);

}  // namespace odas
