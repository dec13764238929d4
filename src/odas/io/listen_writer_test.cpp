// SPDX-License-Identifier: MIT
#include "odas/io/listen_writer.hpp"

#include "support/net_peer.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::listen_writer_test {
namespace {

const std::string kRecord = std::string(999, 'x') + "\n";

/// Writes until each client has got something: then all of them are in.
void write_until_heard(ListenWriter& writer, const std::vector<const test::NetPeer*>& clients) {
  for (const test::NetPeer* client : clients) {
    ASSERT_TRUE(test::eventually([&] {
      EXPECT_TRUE(writer.write(kRecord).ok());
      return !client->receive_now().empty();
    }));
  }
}

TEST(ListenWriter, gives_every_client_the_same_whole_records_from_when_he_came) {
  ListenWriter writer("", 0, "", {});
  EXPECT_TRUE(writer.write(kRecord).ok()) << "nobody is there, and nothing is lost";
  EXPECT_EQ(writer.lost_records(), 0U);
  const test::NetPeer first = test::NetPeer::dial(writer.port());
  const test::NetPeer second = test::NetPeer::dial(writer.port());
  write_until_heard(writer, {&first, &second});
  EXPECT_TRUE(writer.write("last\n" + kRecord).ok());
  EXPECT_TRUE(writer.close().ok());
  for (const test::NetPeer* client : {&first, &second}) {
    const std::string got = client->receive_all();
    EXPECT_TRUE(got.ends_with("last\n" + kRecord));
    EXPECT_EQ((got.size() - 5) % kRecord.size(), 0U);
  }
}

TEST(ListenWriter, one_who_sleeps_loses_whole_records_and_the_others_none) {
  std::vector<std::string> said;
  ListenWriter writer("", 0, "", {.say = [&](const std::string& what) { said.push_back(what); }});
  const test::NetPeer awake = test::NetPeer::dial(writer.port());
  const test::NetPeer asleep = test::NetPeer::dial(writer.port());
  write_until_heard(writer, {&awake, &asleep});
  std::string got;
  std::size_t sent = 0;
  while (writer.lost_records() == 0 && sent < 100000) {
    EXPECT_TRUE(writer.write(kRecord).ok());
    ++sent;
    got += awake.receive_now();
  }
  ASSERT_EQ(writer.lost_records(), 1U);
  ASSERT_FALSE(said.empty());
  EXPECT_NE(said[0].find("does not read"), std::string::npos);
  EXPECT_TRUE(test::eventually([&] {
    EXPECT_TRUE(writer.flush().ok());
    return (got += awake.receive_now()).size() >= sent * kRecord.size();
  })) << "who reads gets everything";
  std::thread reader([&] { EXPECT_EQ(asleep.receive_all().size() % kRecord.size(), 0U); });
  EXPECT_TRUE(writer.close().ok());
  reader.join();
}

TEST(ListenWriter, a_client_who_goes_is_forgotten) {
  ListenWriter writer("", 0, "", {});
  {
    const test::NetPeer brief = test::NetPeer::dial(writer.port());
    write_until_heard(writer, {&brief});
  }
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(writer.write(kRecord).ok());
  const test::NetPeer next = test::NetPeer::dial(writer.port());
  write_until_heard(writer, {&next});
}

TEST(ListenWriter, with_a_token_only_those_hear_who_say_it) {
  std::vector<std::string> said;
  ListenWriter writer("", 0, "s3cret", {.say = [&](const std::string& what) { said.push_back(what); }});
  const test::NetPeer friendly = test::NetPeer::dial(writer.port());
  const test::NetPeer stranger = test::NetPeer::dial(writer.port());
  const test::NetPeer silent = test::NetPeer::dial(writer.port());
  EXPECT_TRUE(friendly.send("s3cret\n"));
  EXPECT_TRUE(stranger.send("please\n"));
  write_until_heard(writer, {&friendly});
  ASSERT_TRUE(test::eventually([&] { return writer.flush().ok() && !said.empty(); }));
  EXPECT_NE(said[0].find("did not give the token first"), std::string::npos) << said[0];
  EXPECT_TRUE(writer.close().ok());
  EXPECT_EQ(stranger.receive_all(), "");
  EXPECT_EQ(silent.receive_all(), "");
}

TEST(ListenWriter, more_clients_than_it_keeps_are_sent_away) {
  ListenWriter writer("", 0, "", {});
  std::vector<test::NetPeer> clients;
  for (std::size_t i = 0; i < ListenWriter::kMostClients + 3; ++i) {
    clients.push_back(test::NetPeer::dial(writer.port()));
    EXPECT_TRUE(writer.write(kRecord).ok());
  }
  EXPECT_TRUE(writer.write(kRecord).ok());
  EXPECT_EQ(clients.back().receive_all(), "") << "his connection is closed, and has brought nothing";
  write_until_heard(writer, {&clients.front()});
}

TEST(ListenWriter, a_port_that_is_taken_is_said_at_once) {
  const ListenWriter first("", 0, "", {});
  EXPECT_THROW(ListenWriter("", first.port(), "", {}), IoError);
}

}  // namespace
}  // namespace odas::listen_writer_test
