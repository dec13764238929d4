// SPDX-License-Identifier: MIT
#include "odasserver_screen.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "odas/io/source_table.hpp"

namespace odas {
namespace {

constexpr std::chrono::milliseconds kBetweenDrawings{100};
constexpr std::chrono::seconds kBetweenLines{1};

bool is_terminal() {
  const char* kind = std::getenv("TERM");
  return isatty(STDOUT_FILENO) == 1 && kind != nullptr && std::string_view(kind) != "dumb";
}

winsize size_of_terminal() {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) size = {24, 80, 0, 0};
  return size;
}

/// At most `width` characters of UTF-8.
std::string_view cut(std::string_view line, std::size_t width) {
  std::size_t shown = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool begins = (static_cast<unsigned char>(line[i]) & 0xC0) != 0x80;
    if (begins && shown++ == width) return line.substr(0, i);
  }
  return line;
}

}  // namespace

ServerScreen::ServerScreen(bool quiet) : quiet_(quiet), on_terminal_(is_terminal()) {}

void ServerScreen::clear() {
  if (drawn_ > 0) std::fputs(fmt::format("\033[{}A\033[J", drawn_).c_str(), stdout);
  if (drawn_ > 0) std::fflush(stdout);
  drawn_ = 0;
}

void ServerScreen::say(const std::string& message) {
  clear();
  std::fprintf(stderr, "odasserver: %s\n", message.c_str());
  last_ = {};
}

void ServerScreen::draw(const std::vector<std::string>& lines) {
  // A line that wraps, or a table higher than the screen, could not be drawn over.
  const winsize size = size_of_terminal();
  const std::size_t height = std::min<std::size_t>(lines.size(), std::max<std::size_t>(size.ws_row, 2) - 1);
  std::string text = drawn_ > 0 ? fmt::format("\033[{}A", drawn_) : "";
  for (std::size_t i = 0; i < height; ++i) {
    text += cut(lines[i], size.ws_col);
    text += "\033[K\n";
  }
  text += "\033[J";
  std::fputs(text.c_str(), stdout);
  std::fflush(stdout);
  drawn_ = height;
}

void ServerScreen::print_lines(std::span<const Track> tracks, Clock::time_point now) {
  const std::string time = fmt::format("{:8.1f} s  ", std::chrono::duration<double>(now - begin_).count());
  const auto is_there = [&](std::uint64_t id) {
    return std::any_of(tracks.begin(), tracks.end(), [&](const Track& track) { return track.id == id; });
  };
  bool changed = false;
  for (const Track& track : tracks) {
    if (track.id == 0) continue;
    const auto [known, is_new] = printed_.try_emplace(track.id, now);
    if (!is_new && now - known->second < kBetweenLines) continue;
    known->second = now;
    std::printf("%s%s\n", time.c_str(), source_line(track).c_str());
    changed = true;
  }
  for (auto known = printed_.begin(); known != printed_.end();) {
    if (is_there(known->first)) {
      ++known;
      continue;
    }
    std::printf("%sid %llu has gone\n", time.c_str(), static_cast<unsigned long long>(known->first));
    known = printed_.erase(known);
    changed = true;
  }
  if (changed) std::fflush(stdout);
}

void ServerScreen::hear(std::span<const Track> tracks) {
  if (!quiet_ && !on_terminal_) print_lines(tracks, Clock::now());
}

void ServerScreen::show(std::span<const Track> tracks, const std::vector<std::string>& state,
                        Clock::time_point now) {
  if (quiet_ || now - last_ < kBetweenDrawings) return;
  last_ = now;
  if (!on_terminal_) {
    if (tracks.empty()) print_lines(tracks, now);
    return;
  }
  std::vector<std::string> lines = source_table(tracks);
  lines.emplace_back();
  lines.insert(lines.end(), state.begin(), state.end());
  draw(lines);
}

}  // namespace odas
