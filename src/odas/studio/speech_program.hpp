// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <sys/types.h>

#include "odas/io/file_descriptor.hpp"

namespace odas {

/// A program of the user's, run by the shell, with our pipes at its standard input and output. What it says
/// on its standard error is not ours to show, and is thrown away. Never waits; one thread.
///
/// It has a process group of its own, so that `kill` ends what it started, too. The destructor kills it.
class SpeechProgram {
 public:
  /// `environment`: "NAME=value", beside ours. Throws IoError.
  SpeechProgram(const std::string& command, const std::vector<std::string>& environment);
  ~SpeechProgram();
  SpeechProgram(const SpeechProgram&) = delete;
  SpeechProgram& operator=(const SpeechProgram&) = delete;

  /// Takes as much as there is room for, and says how many bytes; all, once nobody reads any more.
  std::size_t write(std::string_view bytes);
  void close_input() { input_ = FileDescriptor(); }
  /// What it has written; "" if nothing now. `ended` when it has closed its output.
  [[nodiscard]] std::string read(std::size_t most);
  [[nodiscard]] bool ended() const noexcept { return !output_.open(); }

  /// Its exit code, once it is over; 128 and more: a signal.
  [[nodiscard]] std::optional<int> exit_code();
  void kill();

  [[nodiscard]] int input() const noexcept { return input_.get(); }    // -1: closed
  [[nodiscard]] int output() const noexcept { return output_.get(); }  // -1: it has ended

 private:
  FileDescriptor input_, output_;
  pid_t pid_ = -1;  // -1: it is over
  std::optional<int> code_;
};

}  // namespace odas
