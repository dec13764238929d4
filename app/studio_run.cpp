// SPDX-License-Identifier: MIT
#include "studio_run.hpp"

#include <charconv>
#include <chrono>
#include <cstdio>
#include <thread>

#include "qr_code.hpp"
#include "stop.hpp"
#include <unistd.h>

#include "odas/base/error.hpp"
#include "odas/base/host.hpp"

namespace odas {
namespace {

bool leads_beyond(const StudioConfig& config) { return !config.ip.empty() && !is_loopback_host(config.ip); }

bool is_port(std::string_view text, int& port) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  return error == std::errc() && end == text.data() + text.size() && port >= 0 && port <= 65535;
}

/// A demonstration must not fail because somebody else listens already.
std::unique_ptr<Studio> make_studio(const StudioRun& run) {
  try {
    return std::make_unique<Studio>(run.studio);
  } catch (const IoError& error) {
    if (!run.any_port || run.studio.config.port == 0) throw;
    std::fprintf(stderr, "%s: %s; another port is taken\n", run.studio.program.c_str(), error.what());
    StudioOptions elsewhere = run.studio;
    elsewhere.config.port = 0;
    return std::make_unique<Studio>(std::move(elsewhere));
  }
}

}  // namespace

void set_address(StudioConfig& config, const std::string& address) {
  int port = 0;
  if (is_port(address, port)) {
    config.port = port;
    return;
  }
  // Of [::1]:8080 the last colon is the one before the port; ::1 has none.
  const std::size_t colon = address.rfind(':');
  const bool bare_v6 = address.find(':') != colon && !address.starts_with('[');
  std::string host = address;
  if (colon != std::string::npos && !bare_v6 && !address.ends_with(']')) {
    if (!is_port(std::string_view(address).substr(colon + 1), port)) {
      throw ConfigError(address, "is no address to listen at; say ADDRESS:PORT, such as 127.0.0.1:8080");
    }
    config.port = port;
    host = address.substr(0, colon);
  }
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  if (!host.empty()) config.ip = host;
}

int serve_studio(StudioRun run) {
  const std::atomic<bool>& stop = stop_on_signals();
  const std::unique_ptr<Studio> studio = make_studio(run);
  const char* const program = run.studio.program.c_str();
  const std::string url = studio->url();
  std::fprintf(stderr, "%s: Studio: %s (Ctrl-C ends)\n", program, url.c_str());
  if (!run.studio.open && !run.studio.odas && run.studio.session.empty()) {
    std::fprintf(stderr,
                 "%s: nothing is heard yet: open the page and choose a device or file, and an array\n",
                 program);
  }
  // For the phone in the other hand; a file or a pipe has no camera before it.
  if (run.qr && leads_beyond(run.studio.config) && ::isatty(STDERR_FILENO) == 1) {
    std::fputs(qr_code(url).c_str(), stderr);
  }
  std::optional<Studio::End> end;
  while (!stop && !(run.ends_alone && (end = studio->end()))) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return end ? end->exit_code : 0;
}

int live_with_studio(const std::string& file, const std::string& address) {
  StudioRun run;
  run.studio.open = read_document(file);
  run.studio.outputs = Outputs::all;
  run.studio.config = load_configuration(run.studio.open->file).config.studio;
  if (!address.empty()) set_address(run.studio.config, address);
  run.ends_alone = true;
  return serve_studio(std::move(run));
}

}  // namespace odas
