// SPDX-License-Identifier: MIT
#include "odas/io/stream_server.hpp"

#include <algorithm>
#include <charconv>

#include "support/net_peer.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"
#include "odas/io/hop_encoder.hpp"

namespace odas::stream_server_test {
namespace {

using namespace std::chrono_literals;

std::string tracks_of(HopIndex time) {
  std::vector<Track> tracks(2);
  tracks[1] = {.id = 7, .tag = "dynamic", .direction = {0, 1, 0}, .activity = 0.5F};
  const auto encoder = make_odas_json_tracks();
  const auto bytes = encoder->encode({time, {}, tracks, {}, {}});
  return {bytes.data(), bytes.size()};
}

class StreamServerTest : public ::testing::Test {
 protected:
  StreamServerTest() {
    config_.ports.fill(0);
    config_.separated = config_.postfiltered = {16000, 2, 16};
    config_.say = [this](const std::string& what) { said_ += what + "\n"; };
    archive_.emplace(scratch_ / "run", 0.008);
    server_.emplace(config_, *archive_);
  }

  [[nodiscard]] int port(Stream stream) const {
    const std::string where = server_->where(stream);
    int port = 0;
    std::from_chars(where.data() + where.rfind(':') + 1, where.data() + where.size(), port);
    return port;
  }
  [[nodiscard]] test::NetPeer dial(Stream stream) const { return test::NetPeer::dial(port(stream)); }
  /// Steps until it is true; fails if it never is.
  template <class Condition>
  void serve_until(Condition condition) {
    for (int i = 0; i < 2000 && !condition(); ++i) EXPECT_TRUE(server_->step(10ms).ok());
    EXPECT_TRUE(condition()) << said_;
  }
  void serve_until_said(const std::string& what) {
    serve_until([&] { return said_.find(what) != std::string::npos; });
  }
  [[nodiscard]] std::size_t lines_of(const std::string& file) {
    EXPECT_TRUE(archive_->flush().ok());
    const std::string text = test::content(scratch_ / "run" / file);
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }
  [[nodiscard]] std::string sound_of(const std::string& file) {
    EXPECT_TRUE(server_->flush().ok());
    return test::wav_samples(scratch_ / "run" / file);
  }

  test::Scratch scratch_;
  std::string said_;
  StreamServerConfig config_;
  std::optional<StreamArchive> archive_;
  std::optional<StreamServer> server_;
};

TEST_F(StreamServerTest, keeps_all_streams_and_knows_who_is_there) {
  const test::NetPeer tracked = dial(Stream::tracked), potential = dial(Stream::potential),
                      category = dial(Stream::category), separated = dial(Stream::separated),
                      postfiltered = dial(Stream::postfiltered);
  tracked.send(tracks_of(1));
  serve_until([&] { return server_->tracks().size() == 2; });
  category.send(R"({"timeStamp":1,"src":[{"category":"nonspeech"},{"category":"speech"}]})");
  potential.send(R"({"timeStamp":1,"src":[{"x":0.0,"y":0.0,"z":1.0,"E":0.5}]})");
  separated.send("abcdefgh");
  postfiltered.send("ABCD");
  serve_until([&] { return server_->tracks()[1].category == Category::speech; });
  tracked.send(tracks_of(2));
  serve_until([&] {
    return lines_of("tracks.jsonl") == 2 && lines_of("potentials.jsonl") == 1 &&
           lines_of("categories.jsonl") == 1;
  });
  EXPECT_NE(test::content(scratch_ / "run/categories.jsonl").find("\"id\":7"), std::string::npos);
  EXPECT_EQ(server_->tracks()[1].id, 7U);
  EXPECT_EQ(server_->tracks()[1].category, Category::speech) << "each new hop has it, too";
  serve_until(
      [&] { return sound_of("separated.wav") == "abcdefgh" && sound_of("postfiltered.wav") == "ABCD"; });
  EXPECT_EQ(server_->state().size(), kStreams);
  EXPECT_NE(server_->state()[0].find("2 hops from 127.0.0.1:"), std::string::npos) << server_->state()[0];
}

TEST_F(StreamServerTest, the_rows_say_which_stream_it_is_whatever_the_port) {
  const test::NetPeer peer = dial(Stream::category);
  peer.send(tracks_of(1) + R"({"timeStamp":1,"src":[{"x":0.0,"y":0.0,"z":1.0,"E":0.5}]})");
  serve_until([&] { return server_->tracks().size() == 2; });
  serve_until([&] { return lines_of("tracks.jsonl") == 1 && lines_of("potentials.jsonl") == 1; });
}

TEST_F(StreamServerTest, a_sender_may_go_at_any_byte_and_come_back) {
  const std::string object = tracks_of(1);
  for (std::size_t cut = 1; cut + 2 < object.size(); cut += 17) {
    {
      test::NetPeer peer = dial(Stream::tracked);
      ASSERT_TRUE(peer.open());
      peer.send(object.substr(0, cut));
      said_.clear();
      serve_until_said("a sender has come");
      if (cut % 2 == 0) peer.reset();
    }
    serve_until([&] {
      return said_.find("has gone") != std::string::npos || said_.find("is lost") != std::string::npos;
    });
  }
  const test::NetPeer peer = dial(Stream::tracked);
  peer.send(object);
  serve_until([&] { return server_->tracks().size() == 2; });
  EXPECT_EQ(lines_of("tracks.jsonl"), 1U);
  EXPECT_EQ(said_.find("nonsense"), std::string::npos) << said_;
}

TEST_F(StreamServerTest, each_connection_of_sound_begins_with_a_whole_sample_in_a_file_of_its_own) {
  {
    const test::NetPeer peer = dial(Stream::separated);
    peer.send("abcde");
    serve_until_said("a sender has come");
  }
  serve_until_said("1 bytes are no whole sample");
  serve_until_said("has gone");
  const test::NetPeer peer = dial(Stream::separated);
  peer.send("ABCD");
  serve_until([&] { return std::filesystem::exists(scratch_ / "run/separated_2.wav"); });
  EXPECT_EQ(sound_of("separated.wav"), "abcd");
  EXPECT_EQ(sound_of("separated_2.wav"), "ABCD");
  const std::string events = test::content(scratch_ / "run/connections.jsonl");
  EXPECT_EQ(lines_of("connections.jsonl"), 5U) << events;
}

TEST_F(StreamServerTest, while_one_sends_another_is_turned_away) {
  std::optional<test::NetPeer> first = dial(Stream::tracked);
  first->send(tracks_of(1));
  serve_until_said("a sender has come");
  const test::NetPeer second = dial(Stream::tracked);
  serve_until_said("is turned away");
  EXPECT_TRUE(second.is_left());
  first->send(tracks_of(2));
  serve_until([&] { return lines_of("tracks.jsonl") == 2; });
  first.reset();
  said_.clear();
  serve_until_said("has gone");
  EXPECT_TRUE(server_->tracks().empty()) << "nobody tells of them any more";
  const test::NetPeer third = dial(Stream::tracked);
  serve_until_said("a sender has come");
}

TEST_F(StreamServerTest, nonsense_on_all_ports_harms_nobody) {
  std::vector<test::NetPeer> peers;
  for (std::size_t s = 0; s < kStreams; ++s) {
    peers.push_back(dial(static_cast<Stream>(s)));
    peers.back().send("GET / HTTP/1.1\r\nHost: robot\r\n\r\n{{{\"\\");
  }
  peers[0].send(tracks_of(2) + "{\"timeStamp\":18446744073709551615,\"src\":[]}" + tracks_of(3));
  serve_until([&] { return server_->tracks().size() == 2; });
  serve_until_said("tracked: what came is no JSON object: \"GET / HTTP/1.1\\x0d");
  EXPECT_TRUE(server_->close().ok());
  EXPECT_TRUE(archive_->close().ok());
}

TEST_F(StreamServerTest, a_port_in_use_is_said) {
  StreamServerConfig config;
  config.ports[0] = port(Stream::tracked);
  try {
    const StreamServer second(config, *archive_);
    FAIL() << "listens, too";
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find("another program listens there"), std::string::npos);
  }
}

TEST_F(StreamServerTest, a_disk_that_is_full_ends_it) {
  const test::NetPeer peer = dial(Stream::separated);
  const test::FileSizeLimit limit(30000);
  peer.send(std::string(200000, 'x'));
  IoStatus status;
  for (int i = 0; i < 2000 && status.ok(); ++i) {
    status = server_->step(10ms);
    if (status.ok()) status = server_->flush();
  }
  EXPECT_NE(status.what().find("separated.wav"), std::string::npos) << status.what();
}

}  // namespace
}  // namespace odas::stream_server_test
