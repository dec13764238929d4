// SPDX-License-Identifier: MIT
#include "odas/studio/client_hall.hpp"

#include <future>

#include <gtest/gtest.h>

namespace odas::client_hall_test {
namespace {

using nlohmann::json;

/// A client whose connection takes everything at once.
class FakeClient final : public StudioClient {
 public:
  FakeClient(const HopRing& ring, Role its_role)
      : StudioClient(
            ring, [](std::uint64_t) { return "{}"; }, its_role) {}
  void wake(ClientFeed::Clock::time_point now) override {
    while (const auto message = feed.next(now)) got.push_back(json::parse(*message->bytes));
  }
  std::vector<json> got;
};

class ClientHallTest : public testing::Test {
 protected:
  /// What was posted runs here and now: there is one thread in these tests, but for the commands'.
  void run_posted() {
    std::vector<std::function<void()>> tasks;
    {
      const std::lock_guard lock(mutex);
      tasks.swap(posted);
    }
    for (const auto& task : tasks) task();
  }
  std::shared_ptr<FakeClient> join(Role role = Role::operator_) {
    auto client = std::make_shared<FakeClient>(ring, role);
    hall.add(client);
    client->wake(ClientFeed::Clock::now());
    return client;
  }
  void await_commands() {
    std::promise<void> done;
    commands.add([&] { done.set_value(); });
    done.get_future().wait();
    run_posted();
  }

  std::mutex mutex;
  std::vector<std::function<void()>> posted;
  HopRing ring;
  RpcRegistry rpc;
  WorkQueue commands;
  ServerHooks hooks;
  ClientHall hall{ring, rpc, commands, hooks, [this](std::function<void()> task) {
                    const std::lock_guard lock(mutex);
                    posted.push_back(std::move(task));
                  }};
};

TEST_F(ClientHallTest, greets_with_hello_and_the_state_of_the_engine) {
  hall.announce("", {{"type", "engine"}, {"state", "failed"}});
  run_posted();
  hooks.hello = [] { return json{{"recordings", "/tmp"}, {"targets", {1}}}; };
  const auto client = join(Role::viewer);
  ASSERT_EQ(client->got.size(), 2U);
  EXPECT_EQ(client->got[0].at("protocol"), 1);
  EXPECT_EQ(client->got[0].at("role"), "viewer");
  EXPECT_EQ(client->got[0].at("recordings"), "/tmp");
  EXPECT_FALSE(client->got[0].contains("targets")) << "they are the run's";
  EXPECT_EQ(client->got[1].at("state"), "failed");
}

TEST_F(ClientHallTest, carries_out_commands_and_answers_each) {
  rpc.add("twice", Role::viewer, "", [](const json& p) { return 2 * p.at("n").get<int>(); });
  const auto client = join();
  client->got.clear();
  hall.hear(client, R"({"id":"x","method":"twice","params":{"n":4}})");
  hall.hear(client, R"({"id":2,"method":"nothing"})");
  await_commands();
  ASSERT_EQ(client->got.size(), 2U);
  EXPECT_EQ(client->got[0], (json{{"type", "reply"}, {"id", "x"}, {"result", 8}}));
  EXPECT_EQ(client->got[1].at("error").at("code"), "unknown_method");
}

TEST_F(ClientHallTest, holds_who_floods_it_with_commands_to_a_few) {
  std::promise<void> go;
  auto gate = go.get_future().share();
  rpc.add("wait", Role::viewer, "", [gate](const json&) {
    gate.wait();
    return json();
  });
  const auto client = join();
  client->got.clear();
  for (int i = 0; i < 100; ++i) hall.hear(client, R"({"id":1,"method":"wait"})");
  EXPECT_EQ(client->got.size(), 68U) << "32 wait, the others are refused at once";
  go.set_value();
  await_commands();
  EXPECT_EQ(client->got.size(), 100U);
  EXPECT_EQ(client->commands, 0);
}

TEST_F(ClientHallTest, answers_one_who_has_gone_with_nothing) {
  rpc.add("x", Role::viewer, "", [](const json&) { return json(); });
  auto client = join();
  hall.hear(client, R"({"id":1,"method":"x"})");
  hall.remove(*client);
  client.reset();
  await_commands();
  EXPECT_EQ(hall.size(), 0U);
}

TEST_F(ClientHallTest, says_what_is_wrong_with_a_message) {
  const auto client = join();
  for (const char* text :
       {"", "[]", "{", R"({"method":5})", R"({"type":7})", R"({"type":"subscribe","topics":{"hops":"x"}})"}) {
    client->got.clear();
    hall.hear(client, text);
    ASSERT_EQ(client->got.size(), 1U) << text;
    EXPECT_EQ(client->got[0].at("error").at("code"), "bad_request") << text;
  }
  client->got.clear();
  hall.hear(client, R"({"type":"of the future"})");
  EXPECT_TRUE(client->got.empty());
}

TEST_F(ClientHallTest, tells_topics_to_those_who_asked_and_their_past_to_newcomers) {
  const auto early = join();
  hall.hear(early, R"({"type":"subscribe","topics":{"log":1}})");
  for (int i = 0; i < 300; ++i) hall.announce("log", {{"type", "log"}, {"lines", {{{"text", i}}}}});
  hall.announce("recordings", {{"type", "recordings"}, {"active", json::array()}});
  run_posted();
  EXPECT_EQ(early->got.back().at("lines").at(0).at("text"), 299);
  const auto late = join();
  late->got.clear();
  hall.hear(late, R"({"type":"subscribe","topics":{"log":1,"recordings":1}})");
  ASSERT_EQ(late->got.size(), 2U);
  EXPECT_EQ(late->got[0].at("lines").size(), 200U);
  EXPECT_EQ(late->got[1].at("type"), "recordings");
}

}  // namespace
}  // namespace odas::client_hall_test
