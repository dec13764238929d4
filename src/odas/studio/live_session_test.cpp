// SPDX-License-Identifier: MIT
#include "odas/studio/live_session.hpp"

#include "support/server_test.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace odas::live_session_test {
namespace {

using nlohmann::json;
using test::FakeRun;
using test::kHop;
using test::ServerTest;
using test::WebClient;

TEST_F(ServerTest, sends_every_hop_once_and_in_order) {
  StudioServer& s = serve();
  FakeRun run;
  s.begin(run.info);
  WebClient client(s.port());
  EXPECT_EQ(next(client, "hello").at("run").at("name"), "test array");
  client.send(R"({"type":"subscribe","topics":{"hops":60,"meters":10,"health":60}})");
  EXPECT_EQ(next(client, "health").at("clients"), 1) << "from here on he is heard";
  HopIndex expected = 0;
  std::size_t meters = 0;
  for (int i = 0; i < 500; ++i) s.hop(run.next());
  while (expected < 500 || meters == 0) {
    const auto message = client.next();
    ASSERT_TRUE(message);
    const json parsed = json::parse(message->payload);
    if (parsed.at("type") == "meters") meters = parsed.at("mics").size();
    if (parsed.at("type") != "hops") continue;
    for (const json& hop : parsed.at("hops")) {
      EXPECT_EQ(hop.at("t"), ++expected);
      EXPECT_EQ(hop.at("tracks").at(0).at(1), 7);
    }
  }
  EXPECT_EQ(meters, 2U);
}

TEST_F(ServerTest, tells_a_new_run_to_those_who_are_there) {
  StudioServer& s = serve();
  WebClient client(s.port());
  EXPECT_EQ(next(client, "hello").at("run"), nullptr);
  FakeRun run;
  s.begin(run.info);
  EXPECT_EQ(next(client, "hello").at("run").at("id"), 1);
  run.info.run = 2;
  s.begin(run.info);
  EXPECT_EQ(next(client, "hello").at("run").at("id"), 2);
}

TEST_F(ServerTest, says_what_has_happened_to_those_who_asked_and_to_newcomers) {
  StudioServer& s = serve();
  s.announce("", {{"type", "engine"}, {"state", "running"}});
  s.announce("log", {{"type", "log"}, {"lines", {{{"text", "first"}}}}});
  WebClient client(s.port());
  EXPECT_EQ(next(client, "engine").at("state"), "running");
  client.send(R"({"type":"subscribe","topics":{"log":1}})");
  EXPECT_EQ(next(client, "log").at("lines").at(0).at("text"), "first");
  s.announce("events", {{"type", "event"}});
  s.announce("log", {{"type", "log"}, {"lines", {{{"text", "second"}}}}});
  const auto message = client.next();
  ASSERT_TRUE(message);
  EXPECT_EQ(json::parse(message->payload).at("lines").at(0).at("text"), "second")
      << "he did not ask for events";
}

TEST_F(ServerTest, sends_sound_under_the_id_of_its_track) {
  StudioServer& s = serve();
  FakeRun run;
  run.hop.separated[1][0] = 0.5F;
  s.begin(run.info);
  WebClient client(s.port());
  client.send(
      R"({"type":"subscribe","topics":{"health":60},"audio":[{"stream":"separated","track":7},{"stream":"separated","track":8}]})");
  next(client, "health");
  for (int i = 0; i < 3; ++i) s.hop(run.next());
  std::uint64_t samples = 0;
  while (samples < 3 * kHop) {
    const auto message = client.next();
    ASSERT_TRUE(message);
    if (message->opcode != 2) continue;
    const std::string& bytes = message->payload;
    ASSERT_GE(bytes.size(), 24U);
    EXPECT_EQ(bytes[4], 7);
    EXPECT_EQ(static_cast<unsigned char>(bytes[25]), 0x40) << "half of full scale";
    samples += (bytes.size() - 24) / 2;
  }
}

}  // namespace
}  // namespace odas::live_session_test
