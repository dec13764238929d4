// SPDX-License-Identifier: MIT
// The command line of odasserver.
#pragma once

#include <string>

#include "odas/io/stream_server.hpp"

namespace odas {

struct ServerOptions {
  StreamServerConfig server;
  double hop_seconds =
      0.008;           // of the sender's time stamps: 128 samples at 16 kHz, as in most of ODAS's files
  std::string folder;  // of this run
  bool quiet = false;  // no table
  bool help = false, version = false;
};

extern const char* const kServerHelp;

/// Throws ConfigError with all that is wrong with the words, or with the configuration that they name.
[[nodiscard]] ServerOptions parse_server_options(int argc, char** argv);

}  // namespace odas
