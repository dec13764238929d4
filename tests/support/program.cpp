// SPDX-License-Identifier: MIT
#include "support/program.hpp"

#include <array>
#include <chrono>
#include <csignal>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace odas::test {
namespace {

struct Channel {
  int ours = -1, theirs = -1;
};

Channel make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("pipe2 failed");
  return {ends[0], ends[1]};
}

Channel make_terminal() {
  const int ours = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (ours < 0 || grantpt(ours) != 0 || unlockpt(ours) != 0)
    throw std::runtime_error("no terminal to be had");
  return {ours, open(ptsname(ours), O_RDWR | O_NOCTTY | O_CLOEXEC)};
}

[[noreturn]] void become(const std::vector<std::string>& command, const ProgramOptions& options, int out,
                         int err) {
  const int null = open(options.input.empty() ? "/dev/null" : options.input.c_str(), O_RDONLY);
  if (null < 0 || out < 0 || err < 0) _exit(126);
  dup2(null, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  if (!options.working_directory.empty() && chdir(options.working_directory.c_str()) != 0) _exit(126);
  if (options.largest_file) {
    const rlimit limit{*options.largest_file, *options.largest_file};
    setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, SIG_IGN);  // so that the write fails with EFBIG instead
  }
  for (const std::string& variable : options.environment) putenv(const_cast<char*>(variable.c_str()));
  if (options.terminal) setenv("TERM", "xterm", 1);
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  std::signal(SIGHUP, SIG_DFL);  // as from a terminal, also where the tests run under nohup
  execv(arguments[0], arguments.data());
  _exit(127);
}

/// Takes what has come; false at the end.
bool take(int channel, std::string& text) {
  std::array<char, 4096> block{};
  const ssize_t n = read(channel, block.data(), block.size());
  if (n > 0) text.append(block.data(), static_cast<std::size_t>(n));
  return n > 0;  // a terminal whose other side is closed says EIO: the end, too
}

}  // namespace

ProgramRun run_program(const std::vector<std::string>& command, const ProgramOptions& options) {
  const Channel out = make_pipe();
  const Channel err = options.terminal ? make_terminal() : make_pipe();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child == 0) become(command, options, out.theirs, err.theirs);
  close(out.theirs);
  close(err.theirs);

  ProgramRun run;
  std::array<pollfd, 2> channels{pollfd{out.ours, POLLIN, 0}, pollfd{err.ours, POLLIN, 0}};
  const std::array<std::string*, 2> texts{&run.out, &run.err};
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(options.seconds);
  bool interrupted = false;
  while (channels[0].fd >= 0 || channels[1].fd >= 0) {
    poll(channels.data(), channels.size(), options.interrupt_when && !interrupted ? 2 : 100);
    for (std::size_t i = 0; i < channels.size(); ++i) {
      if (channels[i].fd < 0 || channels[i].revents == 0) continue;
      if (!take(channels[i].fd, *texts[i])) channels[i].fd = -1;
      if (i == 1 && options.hear) options.hear(run.err);
    }
    if (options.interrupt_when && !interrupted && options.interrupt_when()) {
      kill(child, options.interruption);
      interrupted = true;
    }
    if (std::chrono::steady_clock::now() > deadline) kill(child, SIGKILL);
  }
  close(out.ours);
  close(err.ours);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status)) run.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) run.signal = WTERMSIG(status);
  return run;
}

}  // namespace odas::test
