// SPDX-License-Identifier: MIT
// A Studio as a user starts it: the program, at a port of the system's choice.
#pragma once

#include <atomic>
#include <future>
#include <mutex>
#include <string>
#include <vector>

#include "support/net_peer.hpp"
#include "support/program.hpp"

namespace odas::test {

/// Runs `odas ARGUMENTS...` until the end of its life, or until it has said no address for a browser.
class StudioDaemon {
 public:
  explicit StudioDaemon(const std::vector<std::string>& arguments, ProgramOptions options = {}) {
    std::vector<std::string> command{program_path("odas")};
    command.insert(command.end(), arguments.begin(), arguments.end());
    options.seconds = 600;
    options.interrupt_when = [this] { return stop_.load(); };
    options.hear = [this](const std::string& err) {
      const std::lock_guard lock(mutex_);
      said_ = err;
    };
    run_ = std::async(std::launch::async, [command, options] { return run_program(command, options); });
    eventually([this] { return said().find("(Ctrl-C ends)") != std::string::npos || has_ended(); });
    const std::string all = said();
    const std::size_t at = all.find("Studio: ");
    if (at == std::string::npos) return;
    url_ = all.substr(at + 8, all.find(' ', at + 8) - at - 8);
    const std::size_t colon = url_.find(':', url_.find("://") + 3);
    port_ = std::stoi(url_.substr(colon + 1));
  }
  ~StudioDaemon() {
    if (run_.valid()) stop();
  }
  StudioDaemon(const StudioDaemon&) = delete;
  StudioDaemon& operator=(const StudioDaemon&) = delete;

  [[nodiscard]] int port() const noexcept { return port_; }  // 0: it did not start
  [[nodiscard]] const std::string& url() const noexcept { return url_; }
  /// All of its stderr so far.
  [[nodiscard]] std::string said() const {
    const std::lock_guard lock(mutex_);
    return said_;
  }
  /// Ctrl-C.
  ProgramRun stop() {
    stop_ = true;
    return run_.get();
  }
  [[nodiscard]] ProgramRun wait() { return run_.get(); }

 private:
  [[nodiscard]] bool has_ended() const {
    return run_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  }

  std::atomic<bool> stop_{false};
  mutable std::mutex mutex_;
  std::string said_, url_;
  int port_ = 0;
  std::future<ProgramRun> run_;
};

/// One value of the text of /metrics; -1: it is not there.
inline double metric(const std::string& text, const std::string& name) {
  const std::size_t at = text.find("\n" + name + " ");
  return at == std::string::npos ? -1 : std::stod(text.substr(at + name.size() + 2));
}

}  // namespace odas::test
