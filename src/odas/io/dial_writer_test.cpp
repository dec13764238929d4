// SPDX-License-Identifier: MIT
#include "odas/io/dial_writer.hpp"

#include "support/net_peer.hpp"
#include <gtest/gtest.h>

namespace odas::dial_writer_test {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kRecord = 10000;
std::string record(std::size_t number) {
  std::string text = std::to_string(number) + ";";
  return std::string(kRecord - text.size(), '.') + text;
}

/// How many records `bytes` holds, all of them whole and in order.
std::size_t whole_records(const std::string& bytes) {
  EXPECT_EQ(bytes.size() % kRecord, 0U);
  long before = -1;
  for (std::size_t at = 0; at < bytes.size(); at += kRecord) {
    const std::size_t digits = bytes.find_first_not_of('.', at);
    const long number = std::stol(bytes.substr(digits, 20));
    EXPECT_EQ(bytes.compare(at, kRecord, record(static_cast<std::size_t>(number))), 0);
    EXPECT_GT(number, before);
    before = number;
  }
  return bytes.size() / kRecord;
}

struct Said {
  std::vector<std::string> all;
  PeerManners live() {
    return {.say = [this](const std::string& what) { all.push_back(what); }};
  }
  PeerManners patient() {
    PeerManners manners = live();
    manners.patience = 1s;
    return manners;
  }
};

TEST(DialWriter, sends_records_to_the_peer_that_listens) {
  const test::NetListener listener;
  Said said;
  DialWriter writer("127.0.0.1", listener.port(), said.patient());
  EXPECT_TRUE(writer.write(record(0)).ok());
  EXPECT_TRUE(writer.write(record(1)).ok());
  const test::NetPeer peer = listener.accept();
  EXPECT_TRUE(writer.close().ok());
  EXPECT_EQ(peer.receive_all(), record(0) + record(1));
  EXPECT_EQ(writer.lost_records(), 0U);
  EXPECT_EQ(said.all, std::vector<std::string>{});
}

TEST(DialWriter, goes_on_without_a_peer_and_finds_him_when_he_comes) {
  const int port = test::free_port();
  Said said;
  DialWriter writer("127.0.0.1", port, said.live());
  ASSERT_TRUE(test::eventually([&] { return writer.flush().ok() && !said.all.empty(); }));
  EXPECT_NE(said.all[0].find("nobody answers at 127.0.0.1:"), std::string::npos) << said.all[0];
  for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(writer.write(record(i)).ok());
  EXPECT_EQ(writer.lost_records(), 3U);
  const test::NetListener listener(port);
  ASSERT_TRUE(test::eventually([&] { return writer.flush().ok() && said.all.size() == 2; }));
  EXPECT_NE(said.all[1].find("; 3 hops went by"), std::string::npos) << said.all[1];
  EXPECT_TRUE(writer.write(record(3)).ok());
  const test::NetPeer peer = listener.accept();
  EXPECT_TRUE(writer.close().ok());
  EXPECT_EQ(peer.receive_all(), record(3)) << "from the first whole record on";
}

TEST(DialWriter, begins_anew_with_a_whole_record_when_the_peer_was_cut_off) {
  const test::NetListener listener;
  Said said;
  DialWriter writer("127.0.0.1", listener.port(), said.live());
  std::size_t next = 0;
  for (int life = 0; life < 3; ++life) {
    test::NetPeer peer;
    ASSERT_TRUE(test::eventually([&] { return writer.flush().ok() && (peer = listener.accept(0)).open(); }));
    for (int i = 0; i < 5; ++i) EXPECT_TRUE(writer.write(record(next++)).ok());
    std::string got;
    ASSERT_TRUE(test::eventually([&] {
      EXPECT_TRUE(writer.flush().ok());
      return (got += peer.receive_now()).size() >= 5 * kRecord;
    }));
    EXPECT_EQ(whole_records(got), 5U) << "life " << life;
    EXPECT_TRUE(writer.write(record(next++)).ok());  // in the middle of which he goes, unread
  }
}

TEST(DialWriter, a_peer_who_sleeps_loses_whole_records_each_of_them_counted_and_delays_nobody) {
  const test::NetListener listener;
  Said said;
  DialWriter writer("127.0.0.1", listener.port(), said.live());
  test::NetPeer peer;
  ASSERT_TRUE(test::eventually([&] { return writer.flush().ok() && (peer = listener.accept(0)).open(); }));
  constexpr std::size_t kSent = 3000;
  for (std::size_t i = 0; i < kSent; ++i) EXPECT_TRUE(writer.write(record(i)).ok());
  EXPECT_GT(writer.lost_records(), 0U);
  ASSERT_FALSE(said.all.empty());
  EXPECT_NE(said.all[0].find("does not read"), std::string::npos) << said.all[0];

  std::string got;
  std::thread reader([&] { got = peer.receive_all(); });
  std::size_t next = kSent;
  const auto reads_again = [&] { return said.all.back().find("reads again") != std::string::npos; };
  ASSERT_TRUE(test::eventually([&] { return writer.write(record(next++)).ok() && reads_again(); }));
  EXPECT_TRUE(writer.close().ok());
  reader.join();
  EXPECT_EQ(whole_records(got) + writer.lost_records(), next) << "each is received or counted";
}

TEST(DialWriter, from_a_recording_a_slow_reader_gets_everything) {
  const test::NetListener listener;
  Said said;
  DialWriter writer("127.0.0.1", listener.port(), said.patient());
  std::string got;
  std::thread reader([&] {
    const test::NetPeer peer = listener.accept();
    got = peer.receive_all();
  });
  constexpr std::size_t kSent = 1000;
  for (std::size_t i = 0; i < kSent; ++i) EXPECT_TRUE(writer.write(record(i)).ok());
  EXPECT_TRUE(writer.close().ok());
  reader.join();
  EXPECT_EQ(whole_records(got), kSent);
  EXPECT_EQ(writer.lost_records(), 0U);
}

TEST(DialWriter, what_the_peer_says_is_no_trouble) {
  const test::NetListener listener;
  Said said;
  DialWriter writer("127.0.0.1", listener.port(), said.patient());
  EXPECT_TRUE(writer.write(record(0)).ok());
  const test::NetPeer peer = listener.accept();
  EXPECT_TRUE(peer.send(std::string(20000, '!')));
  EXPECT_TRUE(writer.write(record(1)).ok());
  EXPECT_TRUE(writer.close().ok());
  EXPECT_EQ(peer.receive_all(), record(0) + record(1));
}

}  // namespace
}  // namespace odas::dial_writer_test
