// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "odas/studio/messages.hpp"

namespace odas {

/// What the Studio has to say: on stderr, and to all pages that want the log. Any thread.
class LogBook {
 public:
  /// `program`: before each line on stderr; "": nothing is said there.
  LogBook(std::string program, Announcer& to) : program_(std::move(program)), to_(to) {}

  void info(const std::string& text) { say("info", text); }
  void warning(const std::string& text) { say("warning", text); }
  void error(const std::string& text) { say("error", text); }
  /// `level`: as above.
  void say(const std::string& level, const std::string& text);

 private:
  std::string program_;
  Announcer& to_;
};

}  // namespace odas
