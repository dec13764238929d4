// SPDX-License-Identifier: MIT
#include "progress.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <fmt/format.h>
#include <unistd.h>

namespace odas {

std::string progress_line(double share, double seconds_left) {
  constexpr int kWidth = 30;
  const double whole = std::clamp(share, 0.0, 1.0);
  const int done = static_cast<int>(whole * kWidth);
  std::string bar(static_cast<std::size_t>(done), '=');
  if (done < kWidth) bar += '>';
  const long left = std::lround(seconds_left);
  return fmt::format("[{:<30}] {:3.0f} %  {}:{:02} left", bar, 100 * whole, left / 60, left % 60);
}

Progress::Progress() {
  const char* terminal = std::getenv("TERM");
  on_terminal_ = isatty(STDERR_FILENO) == 1 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

void Progress::clear() {
  if (drawn_) std::fputs("\r\033[K", stderr);
  drawn_ = false;
}

void Progress::show(double share) {
  if (!on_terminal_) return;
  const Clock::time_point now = Clock::now();
  if (drawn_ && now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double left = share > 0 ? elapsed * (1 - share) / share : 0;
  std::fputs(("\r" + progress_line(share, left) + "\033[K").c_str(), stderr);
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace odas
