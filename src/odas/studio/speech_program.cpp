// SPDX-License-Identifier: MIT
#include "odas/studio/speech_program.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "odas/base/error.hpp"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX has no header for it

namespace odas {
namespace {

struct Pipe {
  FileDescriptor read, write;
};
Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw IoError("cannot make a pipe: " + std::generic_category().message(errno));
  }
  return {FileDescriptor(ends[0]), FileDescriptor(ends[1])};
}

void never_wait(const FileDescriptor& file) {
  ::fcntl(file.get(), F_SETFL, ::fcntl(file.get(), F_GETFL) | O_NONBLOCK);
}

}  // namespace

SpeechProgram::SpeechProgram(const std::string& command, const std::vector<std::string>& environment) {
  Pipe input = make_pipe(), output = make_pipe();
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, input.read.get(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, output.write.get(), STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t how;
  posix_spawnattr_init(&how);
  sigset_t none, all;
  sigemptyset(&none);
  sigemptyset(&all);
  for (const int signal : {SIGPIPE, SIGINT, SIGTERM, SIGHUP, SIGXFSZ}) sigaddset(&all, signal);
  posix_spawnattr_setsigmask(&how, &none);
  posix_spawnattr_setsigdefault(&how, &all);
  posix_spawnattr_setpgroup(&how, 0);
  posix_spawnattr_setflags(&how, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);

  std::string shell = "/bin/sh", option = "-c", text = command;
  const std::array<char*, 4> arguments{shell.data(), option.data(), text.data(), nullptr};
  std::vector<std::string> ours = environment;
  std::vector<char*> all_of_it;
  for (std::string& entry : ours) all_of_it.push_back(entry.data());
  for (char** entry = environ; *entry != nullptr; ++entry) all_of_it.push_back(*entry);
  all_of_it.push_back(nullptr);
  const int error = ::posix_spawn(&pid_, shell.c_str(), &files, &how, arguments.data(), all_of_it.data());
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&how);
  if (error != 0) {
    pid_ = -1;
    throw IoError("cannot start /bin/sh: " + std::generic_category().message(error));
  }
  input_ = std::move(input.write);
  output_ = std::move(output.read);
  never_wait(input_);
  never_wait(output_);
}

SpeechProgram::~SpeechProgram() {
  kill();
  if (pid_ > 0) ::waitpid(pid_, nullptr, 0);  // it was killed: at once
}

std::size_t SpeechProgram::write(std::string_view bytes) {
  if (!input_.open()) return bytes.size();
  const ssize_t count = ::write(input_.get(), bytes.data(), bytes.size());
  if (count >= 0) return static_cast<std::size_t>(count);
  if (errno == EAGAIN || errno == EINTR) return 0;
  close_input();
  return bytes.size();
}

std::string SpeechProgram::read(std::size_t most) {
  std::string bytes(most, '\0');
  const ssize_t count = output_.open() ? ::read(output_.get(), bytes.data(), bytes.size()) : 0;
  if (count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR)) output_ = FileDescriptor();
  bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  return bytes;
}

std::optional<int> SpeechProgram::exit_code() {
  int status = 0;
  if (pid_ > 0 && ::waitpid(pid_, &status, WNOHANG) == pid_) {
    pid_ = -1;
    code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  return code_;
}

void SpeechProgram::kill() {
  if (pid_ > 0) ::kill(-pid_, SIGKILL);
}

}  // namespace odas
