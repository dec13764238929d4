// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "odas/studio/hop_ring.hpp"
#include "odas/studio/subscription.hpp"

namespace odas {

/// What is sent in one piece.
struct WireMessage {
  bool binary = false;
  std::shared_ptr<const std::string> bytes;
};

/// `[SLOT,ID,SNR,GAIN,CONDITION],...`: of each beam in dB, null where it is not known.
[[nodiscard]] std::string beams_text(const HopRing::Beams& beams);

/// All that one client is still to get, and in which order: answers and announcements, then sound, then hops
/// and the rest, each when it is due. Nothing waits here but texts: hops and sound are read from the ring at
/// the moment when they can be sent, so that a client who is slow loses the oldest, is told so, and costs no
/// memory. Used by one thread.
class ClientFeed {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kMostTexts = 512;
  static constexpr std::size_t kMostTextBytes = std::size_t{4} << 20;

  /// `health` makes the message of that name, given how much this client has lost.
  ClientFeed(const HopRing& ring, std::function<std::string(std::uint64_t lost)> health);

  void subscribe(Subscription subscription, Clock::time_point now);
  [[nodiscard]] const Subscription& subscription() const noexcept { return subscription_; }

  /// An answer or an announcement. Of announcements that nobody fetches the oldest are lost, answers never.
  void put(std::shared_ptr<const std::string> text, bool may_be_lost);

  /// What is to be sent next; none: nothing is due yet.
  [[nodiscard]] std::optional<WireMessage> next(Clock::time_point now);

  /// Hops and announcements, and blocks of sound, that this client did not get.
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_; }

 private:
  struct Text {
    std::shared_ptr<const std::string> bytes;
    bool may_be_lost;
  };
  struct Voice {
    Subscription::Audio wanted;
    std::uint64_t next_index = 0;  // sample that would follow; 0: it is not heard now
    bool heard = false;
  };

  [[nodiscard]] bool is_due(const std::string& topic, Clock::time_point now);
  void meet_run();
  void read_audio();
  void add_sound(Voice& voice, const HopFrame& frame, const StreamInfo& info, std::string& packet,
                 AudioHeader& header);
  void close_packet(std::string& packet, const AudioHeader& header);
  [[nodiscard]] std::optional<WireMessage> hops();
  [[nodiscard]] std::optional<WireMessage> meters();
  [[nodiscard]] std::optional<WireMessage> power();
  [[nodiscard]] std::optional<WireMessage> beams();

  const HopRing& ring_;
  std::function<std::string(std::uint64_t)> health_;
  Subscription subscription_;
  std::optional<StreamInfo> info_;  // of run_
  std::uint64_t run_ = 0;
  std::deque<Text> texts_;
  std::size_t text_bytes_ = 0;
  std::deque<WireMessage> sound_;
  std::vector<Voice> voices_;
  std::map<std::string, Clock::time_point> due_;
  std::uint64_t next_hop_ = 0, next_sound_ = 0;  // numbers in the ring
  std::uint64_t readings_ = 0;
  HopIndex power_time_ = 0, beams_time_ = 0;
  std::uint64_t lost_ = 0;
};

}  // namespace odas
