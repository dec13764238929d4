// SPDX-License-Identifier: MIT
// Peers that vanish, stall, return and send garbage, on all network outputs at once: nobody else notices,
// what each of them gets is whole and in order, and what he does not get is counted to the hop. Seeded; the
// long form (ODAS_SOAK=1) has 1,000 sequences over 10 minutes of sound.
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <random>
#include <thread>

#include "support/fake_io.hpp"
#include "support/net_peer.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "odas/io/json_cutter.hpp"
#include "odas/io/registry.hpp"
#include "odas/io/stream_record.hpp"

namespace odas::test::peers_test {
namespace {

constexpr std::size_t kSlots = 4, kHop = 1024;
constexpr std::size_t kFrame = kSlots * 3, kBlock = kHop * kFrame;  // bytes, 24 bits
constexpr std::uint64_t kSamples = std::uint64_t{1} << 22;          // then the numbers begin anew
constexpr std::uint64_t kRound = kSamples / kHop;                   // hops

/// Sound of which each sample says its slot and its number, so that a slip shows.
class NumberedHops {
 public:
  NumberedHops() {
    hop_.tracks.resize(kSlots);
    hop_.tracks[1] = {.id = 7, .tag = "dynamic", .direction = {0, 1, 0}, .activity = 0.5F};
    hop_.potentials.resize(kSlots);
    hop_.separated = hop_.postfiltered = Grid<float>(kSlots, kHop);
  }
  HopResult at(HopIndex time) {
    for (std::size_t slot = 0; slot < kSlots; ++slot) {
      for (std::size_t i = 0; i < kHop; ++i) {
        const std::uint64_t number = ((time - 1) * kHop + i) % kSamples * kSlots + slot;
        hop_.separated[slot][i] =
            static_cast<float>(static_cast<std::int64_t>(number) - (1 << 23)) / (1 << 23);
      }
    }
    return hop_.result(time);
  }

 private:
  HopOfHand hop_;
};

/// What one connection brings: whole records, each later than the one before.
class Checker {
 public:
  /// `before`: a hop that is earlier than all that come, by less than the numbers take to come round.
  explicit Checker(bool is_sound, HopIndex before = 0) : is_sound_(is_sound), last_(before) {}

  void take(const std::string& bytes) {
    if (is_sound_) {
      pending_ += bytes;
      std::size_t at = 0;
      for (; pending_.size() - at >= kBlock; at += kBlock) take_block(at);
      pending_.erase(0, at);
      return;
    }
    cutter_.push(bytes);
    while (const auto cut = cutter_.next()) {
      const StreamRecord record = read_stream_record(cut->text, StreamKind::tracks);
      EXPECT_TRUE(cut->fault == nullptr && record.is_good()) << cut->text;
      count(record.time);
    }
  }
  [[nodiscard]] std::uint64_t records() const noexcept { return records_; }
  [[nodiscard]] HopIndex last() const noexcept { return last_; }

 private:
  [[nodiscard]] std::uint64_t number_at(std::size_t at) const {
    const auto byte = [&](std::size_t i) {
      return static_cast<std::uint32_t>(static_cast<unsigned char>(pending_[at + i]));
    };
    return (byte(0) | byte(1) << 8 | byte(2) << 16) ^ 0x800000U;
  }
  void take_block(std::size_t at) {
    const std::uint64_t first = number_at(at) / kSlots;
    ASSERT_EQ(first % kHop, 0U) << "a block begins with a sample that begins no hop";
    for (std::size_t i = 0; i < kHop * kSlots; ++i) {
      ASSERT_EQ(number_at(at + 3 * i), first * kSlots + i) << "a channel has slipped";
    }
    // Numbers come round: the hop is the next one of that number.
    HopIndex time = first / kHop + 1;
    while (time <= last_) time += kRound;
    count(time);
  }
  void count(HopIndex time) {
    EXPECT_GT(time, last_);
    last_ = time;
    ++records_;
  }

  bool is_sound_;
  HopIndex last_;
  std::string pending_;
  JsonCutter cutter_;
  std::uint64_t records_ = 0;
};

/// One output, and the peer at its other end.
class Endpoint {
 public:
  /// `port` 0: he dials, at the port that `sink` listens at; else he listens there.
  Endpoint(Sink& sink, int port, bool is_sound, const HopIndex& now)
      : sink_(&sink), now_(&now), own_port_(port), is_sound_(is_sound) {
    if (port == 0) {
      const std::string name = sink.name();
      their_port_ = std::stoi(name.substr(name.rfind(':') + 1));
    }
  }

  /// He does something that peers do.
  void misbehave(std::mt19937& random) {
    switch (random() % 6) {
      case 0:
        stalls_ = true;
        break;
      case 1:
        vanish(false);
        break;
      case 2:
        vanish(true);
        break;
      case 3:
        send_garbage(random);
        break;
      default:
        stalls_ = false;
        arrive();
    }
  }
  void arrive() {
    if (peer_.open() || listener_) return;
    if (own_port_ != 0) {
      listener_.emplace(own_port_);
    } else {
      peer_ = NetPeer::dial(their_port_);
      begin();
    }
  }
  void stall(bool stalls) { stalls_ = stalls; }
  /// Takes what has come, unless he stalls.
  void step() {
    if (listener_ && !peer_.open()) {
      peer_ = listener_->accept(0);
      begin();
    }
    if (!peer_.open() || stalls_) return;
    for (int i = 0; i < 64; ++i) {
      const std::string bytes = peer_.receive(65536, 0);
      if (bytes.empty()) return;
      checker_.take(bytes);
    }
  }

  [[nodiscard]] const Checker& checker() const noexcept { return checker_; }
  [[nodiscard]] Sink& sink() const noexcept { return *sink_; }
  [[nodiscard]] std::uint64_t all_records() const noexcept { return before_ + checker_.records(); }

 private:
  void begin() {
    before_ += checker_.records();
    checker_ = Checker(is_sound_, *now_ - std::min(*now_, kRound / 2));
  }
  void vanish(bool at_once) {
    if (at_once) peer_.reset();
    peer_.close();
    listener_.reset();
  }
  void send_garbage(std::mt19937& random) {
    if (!peer_.open()) return;
    std::string bytes(random() % 3000, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    static_cast<void>(::send(peer_.descriptor(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT));
  }

  Sink* sink_;
  const HopIndex* now_;
  int own_port_, their_port_ = 0;
  bool is_sound_;
  std::optional<NetListener> listener_;
  NetPeer peer_;
  Checker checker_{is_sound_};
  std::uint64_t before_ = 0;
  bool stalls_ = false;
};

template <class Interface>
Interface interface_of(const std::string& type, int port) {
  Interface to;
  to.type = type;
  to.ip = "127.0.0.1";
  to.port = port;
  return to;
}

/// Outputs to peers: 0-3 are wild, 4 and 5 only stall and wake; a file and a datagram socket beside them.
class Wildlife {
 public:
  Wildlife() {
    Configuration config = small_configuration();
    PipelineConfig& pipeline = config.pipeline;
    pipeline.general.size.hop_size = static_cast<int>(kHop);
    pipeline.general.size.frame_size = static_cast<int>(2 * kHop);
    pipeline.sst.n_tracks = static_cast<int>(kSlots);
    config.tracked.format = config.potential.format = "json";
    config.separated.n_bits = 24;
    config.separated.hop_size = static_cast<int>(kHop);
    const int tracked = free_port(), separated = free_port(), tame = free_port();
    using Text = TextPlaceConfig;
    using Audio = AudioPlaceConfig;
    config.potential.interfaces = {interface_of<Text>("socket_listen", 0)};
    config.tracked.interfaces = {interface_of<Text>("socket", tracked),
                                 interface_of<Text>("udp", free_port())};
    config.separated.interfaces = {interface_of<Audio>("socket", separated),
                                   interface_of<Audio>("socket_listen", 0),
                                   interface_of<Audio>("socket", tame),
                                   interface_of<Audio>("socket_listen", 0), interface_of<Audio>("file", 0)};
    config.separated.interfaces.back().path = scratch_ / "all.raw";
    SinkOptions options;
    options.live = true;
    options.say = [this](const std::string& what) { said_ += what + "\n"; };
    sinks_ = make_sinks(config, options);
    if (sinks_.size() != 8) throw std::runtime_error("not all outputs are there");
    endpoints_.emplace_back(*sinks_[0], 0, false, time_);
    endpoints_.emplace_back(*sinks_[1], tracked, false, time_);
    endpoints_.emplace_back(*sinks_[3], separated, true, time_);
    endpoints_.emplace_back(*sinks_[4], 0, true, time_);
    endpoints_.emplace_back(*sinks_[5], tame, true, time_);
    endpoints_.emplace_back(*sinks_[6], 0, true, time_);
  }

  /// The tame ones come before the first hop, so that each hop reaches them or is counted.
  void begin() {
    for (std::size_t i = kWild; i < endpoints_.size(); ++i) endpoints_[i].arrive();
    // A dialled peer is there once he has been sent something: here, nothing yet; he is let in by flushes.
    for (int i = 0; i < 300; ++i) {
      flush();
      step();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }
  void hop() {
    const HopResult hop = hops_.at(++time_);
    for (const auto& sink : sinks_) EXPECT_TRUE(sink->write(hop).ok());
  }
  void misbehave(std::mt19937& random) {
    const std::size_t who = random() % endpoints_.size();
    if (who < kWild) {
      endpoints_[who].misbehave(random);
    } else {
      endpoints_[who].stall(random() % 2 == 0);
    }
  }
  void step() {
    for (Endpoint& endpoint : endpoints_) endpoint.step();
  }
  void flush() {
    for (const auto& sink : sinks_) EXPECT_TRUE(sink->flush().ok());
  }
  /// Everybody is awake and takes what is there: until nothing comes any more.
  void settle() {
    // A queue that was full has lost the newest hops: these come.
    for (Endpoint& endpoint : endpoints_) endpoint.stall(false);
    take_what_is_there();
    for (int i = 0; i < 5; ++i) hop();
    take_what_is_there();
  }
  /// All are there and awake again, and have heard a hop that is newer: true, unless that takes for ever.
  bool all_return() {
    for (Endpoint& endpoint : endpoints_) {
      endpoint.stall(false);
      endpoint.arrive();
    }
    const HopIndex then = time_;
    const auto is_back = [&](const Endpoint& endpoint) { return endpoint.checker().last() > then; };
    for (int i = 0; i < 4000 && !std::all_of(endpoints_.begin(), endpoints_.end(), is_back); ++i) {
      hop();
      step();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return std::all_of(endpoints_.begin(), endpoints_.end(), is_back);
  }
  void close() {
    for (const auto& sink : sinks_) EXPECT_TRUE(sink->close().ok());
  }

  void expect_everything_is_accounted_for() {
    for (std::size_t i = kWild; i < endpoints_.size(); ++i) {
      const Endpoint& tame = endpoints_[i];
      EXPECT_EQ(tame.all_records() + tame.sink().lost_records(), time_) << tame.sink().name() << '\n'
                                                                        << said_;
      EXPECT_EQ(tame.checker().last(), time_) << "the last hop comes, however much was lost before";
    }
  }
  void expect_the_file_is_whole() {
    Checker checker(true);
    checker.take(content(scratch_ / "all.raw"));
    EXPECT_EQ(checker.records(), time_);
  }
  [[nodiscard]] std::uint64_t lost_of_the_tame() const {
    return endpoints_[kWild].sink().lost_records() + endpoints_[kWild + 1].sink().lost_records();
  }

  static constexpr std::size_t kWild = 4;

 private:
  void take_what_is_there() {
    std::uint64_t got = 0;
    for (int quiet = 0, i = 0; quiet < 50 && i < 10000; ++i) {
      flush();
      step();
      std::uint64_t now = 0;
      for (const Endpoint& endpoint : endpoints_) now += endpoint.all_records();
      quiet = now == got ? quiet + 1 : 0;
      got = now;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }

  Scratch scratch_;
  NumberedHops hops_;
  HopIndex time_ = 0;
  std::string said_;
  std::vector<std::unique_ptr<Sink>> sinks_;
  std::deque<Endpoint> endpoints_;
};

std::size_t open_files() {
  const std::filesystem::directory_iterator all("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

TEST(Peers, who_vanish_stall_return_and_send_garbage_harm_nobody_and_every_lost_hop_is_counted) {
  const bool soak = std::getenv("ODAS_SOAK") != nullptr;
  const int sequences = soak ? 1000 : 30;
  const int hops = soak ? 9375 : 2000;  // of 64 ms: ten minutes of sound; the short form plays them faster
  const std::size_t files_before = open_files();
  std::mt19937 random(20180323);
  {
    Wildlife wildlife;
    wildlife.begin();
    for (int i = 0; i < hops; ++i) {
      wildlife.hop();
      if (i % (hops / sequences) == 0) wildlife.misbehave(random);
      wildlife.step();
      std::this_thread::sleep_for(std::chrono::milliseconds(soak ? 60 : 5));
      if (::testing::Test::HasFailure()) break;
    }
    EXPECT_TRUE(wildlife.all_return());
    wildlife.settle();
    wildlife.expect_everything_is_accounted_for();
    wildlife.close();
    wildlife.expect_the_file_is_whole();
    RecordProperty("lost_hops", std::to_string(wildlife.lost_of_the_tame()));
  }
  EXPECT_EQ(open_files(), files_before);
}

TEST(Peers, one_who_sleeps_for_long_loses_whole_hops_and_gets_the_newest_once_he_wakes) {
  Wildlife wildlife;
  wildlife.begin();
  for (int i = 0; i < 200; ++i) {
    wildlife.hop();
    wildlife.step();
  }
  wildlife.settle();
  EXPECT_EQ(wildlife.lost_of_the_tame(), 0U);
  // Nobody reads: more than any buffer of a system holds.
  for (int i = 0; i < 2000; ++i) wildlife.hop();
  EXPECT_GT(wildlife.lost_of_the_tame(), 0U);
  wildlife.settle();
  for (int i = 0; i < 20; ++i) {
    wildlife.hop();
    wildlife.step();
  }
  wildlife.settle();
  wildlife.expect_everything_is_accounted_for();
  wildlife.close();
  wildlife.expect_the_file_is_whole();
}

TEST(Peers, one_who_sleeps_does_not_keep_the_outputs_from_closing) {
  Wildlife wildlife;
  wildlife.begin();
  for (int i = 0; i < 2000; ++i) wildlife.hop();
  wildlife.close();  // returns: each waits for a while that is bounded
  wildlife.expect_the_file_is_whole();
}

}  // namespace
}  // namespace odas::test::peers_test
