// SPDX-License-Identifier: MIT
// A Studio among many, sleepers and ill-wishers: the engine does not notice, memory is bounded, and who is
// well loses nothing. `make soak` runs it for two minutes.
#include <deque>
#include <random>

#include "support/scratch.hpp"
#include "support/studio_daemon.hpp"
#include "support/web_client.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "odas/studio/hop_ring.hpp"

namespace odas::test::studio_crowd_test {
namespace {

using nlohmann::json;
using Clock = std::chrono::steady_clock;
using std::chrono::seconds;

constexpr std::size_t kMegabyte = 1'000'000;

// A sanitizer keeps what was freed.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kMemoryIsOurs = false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool kMemoryIsOurs = false;
#else
constexpr bool kMemoryIsOurs = true;
#endif
#else
constexpr bool kMemoryIsOurs = true;
#endif

class Crowd : public testing::Test {
 protected:
  static std::vector<std::string> command(const Scratch& scratch) {
    const std::string tree = ODAS_SOURCE_DIR;
    return {"studio",
            tree + "/configs/sample.cfg",
            "--play",
            tree + "/samples/sample_4mic.flac",
            "--loop",
            "--recordings",
            scratch.folder().string(),
            "--listen",
            "127.0.0.1:0"};
  }
  void SetUp() override { ASSERT_NE(daemon.port(), 0) << daemon.said(); }
  [[nodiscard]] double figure(const char* name) const {
    return metric(http_get(daemon.port(), "/metrics").body, name);
  }
  void await_hops(double count) {
    const double from = figure("odas_hops_total");
    ASSERT_TRUE(eventually([&] { return figure("odas_hops_total") >= from + count; }));
  }

  Scratch scratch;
  StudioDaemon daemon{command(scratch)};
};

const char* const kEverything =
    R"({"type":"subscribe","topics":{"hops":60,"meters":10,"health":1,"log":1,"power":5},)"
    R"("audio":[{"stream":"raw","mic":1},{"stream":"separated","track":1},{"stream":"separated","track":2}]})";

/// Reads on and checks that no hop is missing.
class Healthy {
 public:
  explicit Healthy(int port) : client_(port) { client_.send(kEverything); }
  /// What has come by now, for a while: there are others.
  void read() {
    for (int i = 0; i < 20; ++i) {
      const auto message = client_.next(0);
      if (!message) return;
      const std::string& text = message->payload;
      if (text.starts_with(R"({"type":"gap")")) {
        lost += json::parse(text).at("hops").get<std::uint64_t>();
      } else if (text.starts_with(R"({"type":"hops")")) {
        take_hops(text);
      }
    }
  }
  std::uint64_t hops = 0, lost = 0;

 private:
  /// Fifty of these share a machine with what they watch: numbers are looked for, not all of JSON read.
  void take_hops(const std::string& text) {
    static const std::string kHop = R"({"t":)";
    for (std::size_t at = 0; (at = text.find(kHop, at)) != std::string::npos;) {
      at += kHop.size();
      const std::uint64_t time = std::stoull(text.substr(at, 20));
      if (last_ != 0) lost += time - last_ - 1;
      last_ = time;
      ++hops;
    }
  }

  WebClient client_;
  std::uint64_t last_ = 0;
};

TEST_F(Crowd, of_fifty_half_of_them_stalled_or_killed_harms_nobody) {
  await_hops(125);
  const double p99_before = figure("odas_hop_seconds_p99");
  const double before = figure("odas_resident_memory_bytes");
  const auto duration = std::getenv("ODAS_SOAK") != nullptr ? seconds(120) : seconds(10);
  std::vector<std::unique_ptr<Healthy>> healthy;
  std::vector<WebClient> ill;
  for (int i = 0; i < 25; ++i) healthy.push_back(std::make_unique<Healthy>(daemon.port()));
  std::mt19937 random(4);
  const auto join = [&] {
    ill.emplace_back(daemon.port());
    ill.back().send(kEverything);  // and never reads
  };
  for (int i = 0; i < 25; ++i) join();
  double most = before;
  int killed = 0;
  auto next_kill = Clock::now(), next_look = Clock::now();
  for (const auto end = Clock::now() + duration; Clock::now() < end;) {
    for (const auto& one : healthy) one->read();
    if (Clock::now() >= next_kill) {
      const std::size_t victim = random() % ill.size();
      ill[victim].peer().reset();
      ill.erase(ill.begin() + static_cast<std::ptrdiff_t>(victim));
      join();
      ++killed;
      next_kill += std::chrono::milliseconds(100);
    }
    if (Clock::now() >= next_look) {
      most = std::max(most, figure("odas_resident_memory_bytes"));
      next_look += seconds(1);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  std::uint64_t lost = 0, fewest = healthy[0]->hops;
  for (const auto& one : healthy) {
    lost += one->lost;
    fewest = std::min(fewest, one->hops);
  }
  EXPECT_EQ(lost, 0U) << "hops that the healthy did not get";
  EXPECT_GT(fewest, 0U);
  EXPECT_EQ(figure("odas_dropped_hops_total"), 0);
  // The ring of hops that all share, and of each client what is on its way to him.
  if (kMemoryIsOurs) { EXPECT_LT(most - before, static_cast<double>(HopRing::kRoom + 50 * kMegabyte)); }
  fmt::print(
      "{} s, 25 healthy clients with {} hops each or more, {} lost; {} others stalled and killed; memory "
      "{:.1f} "
      "MB before, {:.1f} MB at most; hop p99 {:.0f} us before, {:.0f} us with them\n",
      duration.count(), fewest, lost, killed, before / 1e6, most / 1e6, 1e6 * p99_before,
      1e6 * figure("odas_hop_seconds_p99"));
}

TEST_F(Crowd, of_those_who_dawdle_is_let_go_and_the_others_are_served) {
  std::vector<NetPeer> dawdlers;
  for (int i = 0; i < 200; ++i) {
    dawdlers.push_back(NetPeer::dial(daemon.port()));
    dawdlers.back().send("GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nX-A: ");
  }
  const auto begin = Clock::now();
  EXPECT_EQ(http_get(daemon.port(), "/healthz").status, 200);
  // A byte now and then does not win more time: a request has ten seconds from its beginning.
  while (Clock::now() - begin < seconds(6)) {
    for (const NetPeer& peer : dawdlers) peer.send("a");
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
  }
  const auto has_gone = [](const NetPeer& peer) {
    char byte = 0;
    const ssize_t count = ::recv(peer.descriptor(), &byte, 1, MSG_DONTWAIT);
    return count == 0 || (count < 0 && errno != EAGAIN);
  };
  EXPECT_FALSE(has_gone(NetPeer::dial(daemon.port()))) << "who has just come is still waited for";
  EXPECT_TRUE(eventually([&] { return std::all_of(dawdlers.begin(), dawdlers.end(), has_gone); }));
  EXPECT_EQ(http_get(daemon.port(), "/healthz").status, 200);
}

TEST_F(Crowd, of_ten_thousand_connections_is_bounded) {
  const double before = figure("odas_resident_memory_bytes");
  std::deque<NetPeer> open;
  std::size_t made = 0;
  for (int i = 0; i < 10000; ++i) {
    NetPeer peer = NetPeer::dial(daemon.port());
    if (!peer.open()) continue;
    ++made;
    if (i % 3 == 0) peer.send("GET /healthz HTTP/1.1\r\n");
    if (i % 7 == 0) peer.reset();
    open.push_back(std::move(peer));
    if (open.size() > 700) open.pop_front();  // this test has files of its own to spare
  }
  EXPECT_GT(made, 9000U);
  open.clear();
  EXPECT_TRUE(eventually([&] { return http_get(daemon.port(), "/healthz").status == 200; }));
  const double after = figure("odas_resident_memory_bytes");
  if (kMemoryIsOurs) { EXPECT_LT(after - before, 100.0 * kMegabyte); }
  EXPECT_EQ(figure("odas_dropped_hops_total"), 0);
  await_hops(20);
  fmt::print("{} connections; memory {:.1f} MB before, {:.1f} MB after\n", made, before / 1e6, after / 1e6);
}

TEST_F(Crowd, of_nonsense_is_refused_and_said_once) {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    NetPeer peer = NetPeer::dial(daemon.port());
    std::string bytes(random() % 2000, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    peer.send(bytes);
  }
  for (int i = 0; i < 100; ++i) {
    WebClient client(daemon.port());
    std::string bytes(random() % 500, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    client.send_frame(static_cast<int>(0x80U | random() % 16U), bytes);
    client.peer().send(bytes);
  }
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(http_get(daemon.port(), "/", "Origin: http://evil.example\r\n").status, 403);
    WebClient huge(daemon.port());
    huge.send(std::string(3 << 20, 'x'));
  }
  WebClient deep(daemon.port());
  deep.send(std::string(100000, '['));
  deep.send(R"({"id":1,"method":"methods"})");
  while (const auto message = deep.next()) {
    if (message->payload.find("\"reply\",\"id\":1") != std::string::npos ||
        message->payload.find("\"result\"") != std::string::npos) {
      break;
    }
  }
  await_hops(20);
  const std::string said = daemon.said();
  std::size_t times = 0;
  for (std::size_t at = 0; (at = said.find("requests of other pages", at)) != std::string::npos; ++at)
    ++times;
  EXPECT_EQ(times, 1U) << said;
  EXPECT_EQ(figure("odas_dropped_hops_total"), 0);
}

}  // namespace
}  // namespace odas::test::studio_crowd_test
