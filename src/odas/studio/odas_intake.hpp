// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "odas/io/allowed_senders.hpp"
#include "odas/io/json_cutter.hpp"
#include "odas/io/pcm_assembler.hpp"
#include "odas/io/tcp_listener.hpp"
#include "odas/studio/hop_joiner.hpp"

namespace odas {

struct OdasIntakeConfig {
  std::string listen;                    // "": 127.0.0.1
  std::vector<std::string> allow;        // who may send from elsewhere
  int tracked = 9000, potential = 9001;  // ports; 0: the system chooses
  int separated = 10000, postfiltered = 10010;
  int rate = 16000;        // general.samplerate.mu of the sender
  int hop = 128;           // its general.size.hopSize
  int sound_rate = 16000;  // its sss.separated.fS
  int channels = 4;        // as many as its sst.N_inactive has
  int bits = 16;           // its sss.separated.nBits
};

/// Stands where the old Studio stood: listens at the four ports that the C program ODAS dials, and gives what
/// comes as hops, so that the page shows a running `odaslive`. ODAS is to be started after this, for it ends
/// when nobody listens.
///
/// A thread of its own, in which the listener is called. A port has one sender at a time; nonsense is said,
/// and passed over. Sound that cannot be told to be of its tracks is left out, and that is said (HopJoiner).
class OdasIntake {
 public:
  using Say = std::function<void(const std::string& level, const std::string& text)>;

  /// Listens at once. Throws IoError: a port is in use; ConfigError: a number that cannot be.
  OdasIntake(const OdasIntakeConfig& config, HopListener& to, Say say);
  ~OdasIntake();
  OdasIntake(const OdasIntake&) = delete;
  OdasIntake& operator=(const OdasIntake&) = delete;

  void start();
  /// Ends the run, if there is one. May be started again.
  void stop();

  /// "127.0.0.1:9000" of "tracked", "potential", "separated" or "postfiltered".
  [[nodiscard]] std::string where(std::string_view stream) const;
  [[nodiscard]] int port(std::string_view stream) const;
  /// Whether somebody sends tracks.
  [[nodiscard]] bool has_sender() const noexcept { return has_sender_; }

 private:
  struct Port;
  void run();
  void accept(Port& port);
  void read(Port& port);
  void take_text(Port& port, std::span<const char> bytes);
  void take_sound(Port& port, std::span<const char> bytes);
  void part(Port& port, const char* how);
  [[nodiscard]] bool must_wait(const Port& port) const;

  OdasIntakeConfig config_;
  Say say_;
  AllowedSenders allowed_;
  HopJoiner joiner_;
  std::array<std::unique_ptr<Port>, 4> ports_;
  std::atomic<bool> ending_{false}, has_sender_{false};
  std::thread thread_;
};

}  // namespace odas
