// SPDX-License-Identifier: MIT
#pragma once

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace odas::test {

/// One of the built programs: "odas", "odaslive".
inline std::string program_path(const std::string& name) {
  return std::string(ODAS_BINARY_DIR) + "/bin/" + name;
}

struct ProgramRun {
  int exit_code = -1;  // -1: ended by a signal
  int signal = 0;
  std::string out, err;
};

struct ProgramOptions {
  std::filesystem::path working_directory{};    // empty: ours
  std::optional<std::uint64_t> largest_file{};  // bytes; a write beyond fails, as on a full disk
  bool terminal = false;                        // stderr is a terminal
  std::function<bool()> interrupt_when{};       // asked every few ms; once it is true the signal is sent:
  int interruption = SIGINT;                    // Ctrl-C
  /// "NAME=value", beside those of the test.
  std::vector<std::string> environment{};
  std::filesystem::path input{};                       // its standard input; empty: nothing
  std::function<void(const std::string& err)> hear{};  // told all of stderr so far, whenever there is more
  int seconds = 60;                                    // then the program is killed
};

/// Runs a program as a user would, without a shell, and waits for its end.
[[nodiscard]] ProgramRun run_program(const std::vector<std::string>& command,
                                     const ProgramOptions& options = {});

}  // namespace odas::test
