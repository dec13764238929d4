// SPDX-License-Identifier: MIT
#include "odas/io/target_server.hpp"

#include <mutex>
#include <thread>

#include <gtest/gtest.h>

#include "odas/io/tcp_dialer.hpp"
#include "odas/io/tcp_listener.hpp"

namespace odas {
namespace {

using namespace std::chrono_literals;

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

FileDescriptor dial(int port) {
  TcpDialer dialer("127.0.0.1", port);
  for (int i = 0; i < 2000; ++i) {
    if (auto socket = dialer.poll()) return std::move(*socket);
    std::this_thread::sleep_for(5ms);
  }
  return {};
}

void send_to(const FileDescriptor& socket, const std::string& text) {
  ASSERT_EQ(::send(socket.get(), text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
}

/// The next line that comes, or what has come until the peer went.
std::string line_from(const FileDescriptor& socket) {
  std::string line;
  char byte = 0;
  for (int i = 0; i < 2000;) {
    const ssize_t count = ::recv(socket.get(), &byte, 1, 0);
    if (count == 0) return line;
    if (count < 0) {
      ++i;
      std::this_thread::sleep_for(5ms);
      continue;
    }
    if (byte == '\n') return line;
    line += byte;
  }
  return line;
}

constexpr const char* kDoor = R"({"targets":[{"tag":"door","x":1,"y":0,"z":0}]})";

class TargetServerTest : public testing::Test {
 protected:
  TargetServer serve(const InterfaceConfig& at, const TargetList& begin = {}) {
    return {at, begin, inbox, [this](const std::string& what) { said(what); }};
  }
  TargetInbox inbox;
  Said said;
};

TEST_F(TargetServerTest, answers_each_message_with_what_holds_now) {
  TargetList begin;
  begin.assign(std::vector<Target>{{"lamp", {0, 0, 1}}});
  const TargetServer server = serve(listening(), begin);
  const FileDescriptor client = dial(server.port());
  send_to(client, R"({"add":[]})");
  EXPECT_EQ(line_from(client), R"({"targets":[{"tag":"lamp","x":0.0,"y":0.0,"z":1.0}]})");
  send_to(client, kDoor);
  EXPECT_EQ(line_from(client), R"({"targets":[{"tag":"door","x":1.0,"y":0.0,"z":0.0}]})");
  send_to(client, R"({"remove":["door"]})");
  EXPECT_EQ(line_from(client), R"({"targets":[]})");
}

TEST_F(TargetServerTest, nonsense_is_told_to_both_sides_and_changes_nothing) {
  const TargetServer server = serve(listening());
  const FileDescriptor client = dial(server.port());
  send_to(client, std::string(kDoor) + "\nGET / HTTP/1.1\r\n" + R"({"add":[]})");
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
    const FileDescriptor client = dial(server.port());
    send_to(client, kDoor);
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
  const FileDescriptor stranger = dial(server.port());
  send_to(stranger, std::string(kDoor) + "\n");
  EXPECT_EQ(line_from(stranger), R"({"error":"the first line must be the token"})");
  EXPECT_EQ(line_from(stranger), "") << "and the connection is closed";
  const FileDescriptor friendly = dial(server.port());
  send_to(friendly, "s3cret\n" + std::string(R"({"add":[]})"));
  EXPECT_EQ(line_from(friendly), R"({"targets":[]})");
}

TEST_F(TargetServerTest, dials_a_peer_again_and_again) {
  TcpListener peer("", 0);
  InterfaceConfig at;
  at.type = "socket";
  at.ip = "127.0.0.1";
  at.port = peer.port();
  const TargetServer server = serve(at);
  for (int time = 0; time < 2; ++time) {
    std::optional<TcpClient> dialled;
    for (int i = 0; i < 2000 && !(dialled = peer.accept()); ++i) std::this_thread::sleep_for(5ms);
    ASSERT_TRUE(dialled);
    send_to(dialled->socket, kDoor);
    EXPECT_NE(line_from(dialled->socket).find("door"), std::string::npos);
  }
}

TEST_F(TargetServerTest, many_clients_who_come_and_stay_silent_lock_nobody_out) {
  const TargetServer server = serve(listening());
  std::vector<FileDescriptor> silent;
  for (int i = 0; i < 40; ++i) silent.push_back(dial(server.port()));
  const FileDescriptor client = dial(server.port());
  send_to(client, kDoor);
  EXPECT_NE(line_from(client).find("door"), std::string::npos);
}

}  // namespace
}  // namespace odas
