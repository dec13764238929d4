// SPDX-License-Identifier: MIT
#include "odas/io/target_server.hpp"

#include <mutex>

#include "support/net_peer.hpp"
#include <gtest/gtest.h>

namespace odas::target_server_test {
namespace {

using test::NetPeer;

/// What the server said, from its thread.
class Said {
 public:
  void operator()(const std::string& what) {
    const std::lock_guard lock(mutex_);
    all_ += what + "\n";
  }
  [[nodiscard]] std::string all() {
    const std::lock_guard lock(mutex_);
    return all_;
  }

 private:
  std::mutex mutex_;
  std::string all_;
};

InterfaceConfig listening(const std::string& token = "") {
  InterfaceConfig at;
  at.type = "socket_listen";
  at.token = token;
  return at;
}

/// The next line that comes, or what has come until the peer went.
std::string line_from(const NetPeer& peer) {
  std::string line;
  for (std::string byte; !(byte = peer.receive(1)).empty() && byte != "\n";) line += byte;
  return line;
}

constexpr const char* kDoor = R"({"targets":[{"tag":"door","x":1,"y":0,"z":0}]})";

class TargetServerTest : public testing::Test {
 protected:
  TargetServer serve(const InterfaceConfig& at) {
    return {at, inbox, [this](const std::string& what) { said(what); }};
  }
  TargetInbox inbox;
  Said said;
};

TEST_F(TargetServerTest, answers_each_message_with_what_holds_now) {
  inbox.change([](TargetInbox::Orders& orders) {
    orders.targets.assign(std::vector<Target>{{"lamp", {0, 0, 1}}});
  });
  const TargetServer server = serve(listening());
  const NetPeer client = NetPeer::dial(server.port());
  EXPECT_TRUE(client.send(R"({"add":[]})"));
  EXPECT_EQ(line_from(client), R"({"targets":[{"tag":"lamp","x":0.0,"y":0.0,"z":1.0}]})");
  EXPECT_TRUE(client.send(kDoor));
  EXPECT_EQ(line_from(client), R"({"targets":[{"tag":"door","x":1.0,"y":0.0,"z":0.0}]})");
  EXPECT_TRUE(client.send(R"({"remove":["door"]})"));
  EXPECT_EQ(line_from(client), R"({"targets":[]})");
}

TEST_F(TargetServerTest, nonsense_is_told_to_both_sides_and_changes_nothing) {
  const TargetServer server = serve(listening());
  const NetPeer client = NetPeer::dial(server.port());
  EXPECT_TRUE(client.send(std::string(kDoor) + "\nGET / HTTP/1.1\r\n" + R"({"add":[]})"));
  EXPECT_NE(line_from(client).find("door"), std::string::npos);
  EXPECT_EQ(line_from(client), R"({"error":"is no JSON object"})");
  EXPECT_NE(line_from(client).find("door"), std::string::npos);
  EXPECT_NE(said.all().find("is no JSON object; it changes nothing"), std::string::npos) << said.all();
}

TEST_F(TargetServerTest, targets_reach_the_engine_and_stay_when_their_sender_goes) {
  const TargetServer server = serve(listening());
  PipelineConfig config;
  for (const float x : {0.F, 0.05F, 0.1F}) {
    MicConfig mic;
    mic.mu = {x, 0, 0};
    config.general.mics.push_back(mic);
  }
  config.ssl.scans = {{.level = 1, .delta = 1}};
  Pipeline pipeline(config);
  {
    const NetPeer client = NetPeer::dial(server.port());
    EXPECT_TRUE(client.send(kDoor));
    ASSERT_NE(line_from(client).find("door"), std::string::npos);
  }
  const Grid<float> silence(pipeline.mics(), pipeline.hop_size());
  inbox.deliver(pipeline);
  for (int hop = 0; hop < 3; ++hop) {
    const HopResult result = pipeline.process_hop(silence);
    EXPECT_EQ(result.tracks[0].tag, "door");
  }
}

TEST_F(TargetServerTest, without_the_token_nobody_is_heard) {
  const TargetServer server = serve(listening("s3cret"));
  const NetPeer stranger = NetPeer::dial(server.port());
  EXPECT_TRUE(stranger.send(std::string(kDoor) + "\n"));
  EXPECT_EQ(line_from(stranger), R"({"error":"the first line must be the token"})");
  EXPECT_EQ(line_from(stranger), "") << "and the connection is closed";
  const NetPeer friendly = NetPeer::dial(server.port());
  EXPECT_TRUE(friendly.send("s3cret\n" + std::string(R"({"add":[]})")));
  EXPECT_EQ(line_from(friendly), R"({"targets":[]})");
}

TEST_F(TargetServerTest, dials_a_peer_again_and_again) {
  const test::NetListener listener;
  InterfaceConfig at;
  at.type = "socket";
  at.ip = "127.0.0.1";
  at.port = listener.port();
  const TargetServer server = serve(at);
  for (int time = 0; time < 2; ++time) {
    const NetPeer peer = listener.accept();
    EXPECT_TRUE(peer.send(kDoor));
    EXPECT_NE(line_from(peer).find("door"), std::string::npos);
  }
}

TEST_F(TargetServerTest, many_clients_who_come_and_stay_silent_lock_nobody_out) {
  const TargetServer server = serve(listening());
  std::vector<NetPeer> silent;
  for (int i = 0; i < 40; ++i) silent.push_back(NetPeer::dial(server.port()));
  const NetPeer client = NetPeer::dial(server.port());
  EXPECT_TRUE(client.send(kDoor));
  EXPECT_NE(line_from(client).find("door"), std::string::npos);
}

}  // namespace
}  // namespace odas::target_server_test
