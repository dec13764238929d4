// SPDX-License-Identifier: MIT
#include "odas/studio/client_feed.hpp"

#include "support/fake_io.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace odas::client_feed_test {
namespace {

using nlohmann::json;
using Clock = ClientFeed::Clock;
using std::chrono::milliseconds;

constexpr std::size_t kHop = 64;

class ClientFeedTest : public testing::Test {
 protected:
  ClientFeedTest() {
    hop_.tracks.resize(2);
    hop_.separated = hop_.postfiltered = Grid<float>(2, kHop);
    begin(1);
  }
  void begin(std::uint64_t run) {
    StreamInfo info;
    info.run = run;
    info.hop_size = kHop;
    info.mics.resize(1);
    ring.begin(info);
    time_ = 0;
  }
  void subscribe(const json& message) {
    feed.subscribe(read_subscription(message), now);
    HopRing::Demand demand;
    feed.subscription().add_to(demand);
    ring.demand(demand);
  }
  /// `id` sounds in slot 0, with samples that are its number.
  void hop(std::uint64_t id = 0) {
    hop_.tracks[0].id = id;
    for (float& x : hop_.separated[0]) x = static_cast<float>(id) / 32768;
    ring.hop(hop_.result(++time_));
  }
  void skip(HopIndex hops) { time_ += hops; }
  /// All that is to be sent now, texts as JSON, sound as what its header says.
  std::vector<json> all() {
    std::vector<json> messages;
    while (const auto message = feed.next(now)) {
      if (!message->binary) {
        messages.push_back(json::parse(*message->bytes));
        continue;
      }
      const auto byte = [&](std::size_t i) { return static_cast<unsigned char>((*message->bytes)[i]); };
      const int samples = byte(20) + 256 * byte(21);
      EXPECT_EQ(message->bytes->size(), 24U + 2U * static_cast<unsigned>(samples));
      for (std::size_t i = 24; i < message->bytes->size(); i += 2)
        EXPECT_EQ(byte(i), byte(4)) << "of another voice";
      messages.push_back({{"track", byte(4)},
                          {"index", byte(8) + 256 * byte(9)},
                          {"samples", samples},
                          {"flags", byte(22)}});
    }
    return messages;
  }

  HopRing ring;
  ClientFeed feed{ring, [](std::uint64_t lost) { return json{{"type", "health"}, {"lost", lost}}.dump(); }};
  Clock::time_point now = Clock::now();

 private:
  test::HopOfHand hop_;
  HopIndex time_ = 0;
};

TEST_F(ClientFeedTest, sends_nothing_that_nobody_asked_for) {
  hop(3);
  EXPECT_TRUE(all().empty());
}

TEST_F(ClientFeedTest, sends_all_hops_in_batches_that_are_no_more_than_the_rate) {
  subscribe({{"topics", {{"hops", 10}}}});
  HopIndex expected = 0;
  int messages = 0;
  for (int ms = 0; ms < 1000; ms += 8) {
    hop();
    now += milliseconds(8);
    for (const json& message : all()) {
      ++messages;
      for (const json& one : message.at("hops")) EXPECT_EQ(one.at("t"), ++expected);
    }
  }
  EXPECT_GE(expected, 110U);
  EXPECT_LE(messages, 11);
}

TEST_F(ClientFeedTest, tells_a_slow_client_what_he_has_lost_and_goes_on) {
  subscribe({{"topics", {{"hops", 60}}}, {"audio", {{{"stream", "separated"}, {"track", 3}}}}});
  for (int i = 0; i < 60000; ++i) hop(3);  // more than the ring holds
  HopIndex got = 0, lost = 0;
  bool gap_before = false;
  for (int i = 0; i < 2000; ++i) {
    now += milliseconds(20);
    for (const json& message : all()) {
      if (message.contains("track")) continue;
      if (message.at("type") == "gap") {
        lost += message.at("hops").get<HopIndex>();
        gap_before = true;
      } else {
        EXPECT_EQ(message.at("hops").at(0).at("t"), got + lost + 1);
        got += message.at("hops").size();
      }
    }
  }
  EXPECT_TRUE(gap_before);
  EXPECT_EQ(got + lost, 60000U);
  EXPECT_GE(feed.lost(), lost);
}

TEST_F(ClientFeedTest, puts_sound_under_its_id_and_says_where_it_breaks_off) {
  subscribe({{"audio", {{{"stream", "separated"}, {"track", 3}}}}});
  hop();
  hop(3);
  hop(3);
  hop(5);
  EXPECT_EQ(all(), (std::vector<json>{{{"track", 3}, {"index", kHop}, {"samples", 2 * kHop}, {"flags", 2}}}))
      << "2: the last of this track";
  hop(5);
  EXPECT_TRUE(all().empty());
  hop(3);
  EXPECT_EQ(all(), (std::vector<json>{{{"track", 3}, {"index", 5 * kHop}, {"samples", kHop}, {"flags", 0}}}));
  skip(2);
  hop(3);
  EXPECT_EQ(all(), (std::vector<json>{{{"track", 3}, {"index", 8 * kHop}, {"samples", kHop}, {"flags", 1}}}))
      << "1: samples are missing before these";
  hop(5);
  EXPECT_EQ(all(), (std::vector<json>{{{"track", 3}, {"index", 9 * kHop}, {"samples", 0}, {"flags", 2}}}));
}

TEST_F(ClientFeedTest, goes_on_with_a_voice_that_is_asked_for_again) {
  const json one = {{"audio", {{{"stream", "separated"}, {"track", 3}}}}};
  subscribe(one);
  hop(3);
  all();
  hop(3);
  subscribe(one);
  EXPECT_EQ(all(), (std::vector<json>{{{"track", 3}, {"index", kHop}, {"samples", kHop}, {"flags", 0}}}));
}

TEST_F(ClientFeedTest, begins_anew_with_a_new_run) {
  subscribe({{"topics", {{"hops", 60}}}});
  hop();
  begin(2);
  hop();
  now += milliseconds(20);
  const auto messages = all();
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_EQ(messages[0].at("run"), 2);
  EXPECT_EQ(messages[0].at("hops").size(), 1U);
}

TEST_F(ClientFeedTest, loses_old_announcements_but_no_answers) {
  const auto text = [](const char* type) {
    return std::make_shared<const std::string>(json{{"type", type}}.dump());
  };
  feed.put(text("reply"), false);
  for (int i = 0; i < 2000; ++i) feed.put(text("log"), true);
  const auto messages = all();
  EXPECT_EQ(messages.size(), ClientFeed::kMostTexts);
  EXPECT_EQ(messages[0].at("type"), "reply");
  EXPECT_EQ(feed.lost(), 2001 - ClientFeed::kMostTexts);
}

TEST_F(ClientFeedTest, sends_what_the_beamformer_says_of_each_voice) {
  subscribe({{"topics", {{"beams", 10}}}});
  EXPECT_TRUE(all().empty());
  test::HopOfHand empty;
  HopResult result = empty.result(12);
  const float unknown = std::numeric_limits<float>::quiet_NaN();
  const std::vector<BeamReport> reports{{}, {14.26F, -3.0F, 20.0F, 7}, {unknown, 6.0F, unknown, 9}};
  result.reports = reports;
  ring.hop(result);
  const auto messages = all();
  ASSERT_EQ(messages.size(), 1U) << "once, until there is something new";
  EXPECT_EQ(messages[0].at("t"), 12);
  EXPECT_EQ(messages[0].at("beams").dump(), "[[1,7,14.3,-3.0,20.0],[2,9,null,6.0,null]]");
}

TEST_F(ClientFeedTest, sends_meters_power_and_health_when_they_are_due) {
  subscribe({{"topics", {{"meters", 10}, {"power", 5}, {"health", 1}}}});
  EXPECT_EQ(all(), (std::vector<json>{{{"type", "health"}, {"lost", 0}}}));
  const Grid<float> mics = test::noise(1, kHop);
  const std::vector<float> power{0.25F, 1.0F};
  test::HopOfHand empty;
  for (HopIndex t = 1; t < 60; ++t) {
    HopResult result = empty.result(t);
    result.mics = mics;
    result.power = power;
    ring.hop(result);
  }
  now += milliseconds(250);
  EXPECT_EQ(json::parse(*feed.next(now)->bytes).at("mics").size(), 1U);
  const auto map = feed.next(now);
  ASSERT_TRUE(map && map->binary);
  EXPECT_EQ(map->bytes->size(), 26U);
  EXPECT_EQ((*map->bytes)[0], 2);
  EXPECT_EQ(static_cast<unsigned char>((*map->bytes)[24]), 63);
  EXPECT_EQ(static_cast<unsigned char>((*map->bytes)[25]), 255);
  EXPECT_FALSE(feed.next(now));
}

}  // namespace
}  // namespace odas::client_feed_test
