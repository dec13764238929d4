// SPDX-License-Identifier: MIT
// odasserver: the other end of ODAS's sockets. Receives the streams, keeps them, and shows who is there.
#include <csignal>
#include <cstdio>
#include <exception>

#include "odasserver_options.hpp"
#include "odasserver_screen.hpp"
#include "stop.hpp"
#include <fmt/format.h>

#include "odas/base/error.hpp"
#include "odas/io/stream_archive.hpp"
#include "odas/io/stream_server.hpp"

namespace {

constexpr int kRunTimeFailure = 1;
constexpr int kWrongUsage = 2;
constexpr std::chrono::milliseconds kPatience{100};
constexpr std::chrono::seconds kBetweenFlushes{1};

void say_where(const odas::StreamServer& server, odas::ServerScreen& screen) {
  for (std::size_t s = 0; s < odas::kStreams; ++s) {
    const std::string where = server.where(static_cast<odas::Stream>(s));
    if (!where.empty()) screen.say(fmt::format("{}: listens at {}", odas::kStreamNames[s], where));
  }
}

odas::IoStatus serve(odas::StreamServer& server, odas::StreamArchive& archive, odas::ServerScreen& screen) {
  const std::atomic<bool>& stop = odas::stop_on_signals();
  auto flushed = odas::ServerScreen::Clock::now();
  while (!stop) {
    if (odas::IoStatus status = server.step(kPatience); !status.ok()) return status;
    const auto now = odas::ServerScreen::Clock::now();
    screen.show(server.tracks(), server.state(), now);
    if (now - flushed < kBetweenFlushes) continue;
    flushed = now;
    if (odas::IoStatus status = server.flush(); !status.ok()) return status;
    if (odas::IoStatus status = archive.flush(); !status.ok()) return status;
  }
  return {};
}

int run(odas::ServerOptions options) {
  odas::ServerScreen screen(options.quiet);
  options.server.say = [&](const std::string& what) { screen.say(what); };
  options.server.heard = [&](std::span<const odas::Track> tracks) { screen.hear(tracks); };
  odas::StreamArchive archive(options.folder, options.hop_seconds);
  odas::StreamServer server(options.server, archive);
  say_where(server, screen);
  const odas::IoStatus served = serve(server, archive, screen);
  const odas::IoStatus finished = server.close();
  const bool is_empty = std::filesystem::is_empty(archive.folder());
  const odas::IoStatus closed = archive.close();
  for (const odas::IoStatus& status : {served, finished, closed}) {
    if (status.ok()) continue;
    screen.say(status.what());
    return kRunTimeFailure;
  }
  screen.say(is_empty ? "nothing has come" : "what has come is in " + archive.folder().string());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  // A reader that goes away and a file that may not grow are error values, not our end.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    const odas::ServerOptions options = odas::parse_server_options(argc, argv);
    if (options.help || options.version) {
      std::fputs(options.help ? odas::kServerHelp : "odasserver " ODAS_VERSION "\n", stdout);
      return 0;
    }
    return run(options);
  } catch (const odas::ConfigError& error) {
    std::fprintf(stderr, "%s\nRun 'odasserver --help'.\n", error.what());
    return kWrongUsage;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "odasserver: %s\n", error.what());
    return kRunTimeFailure;
  }
}
