// SPDX-License-Identifier: MIT
#include "odas/io/peer_link.hpp"

#include <thread>

#include <gtest/gtest.h>
#include <sys/socket.h>

namespace odas::peer_link_test {
namespace {

using namespace std::chrono_literals;

struct Pair {
  Pair() {
    int ends[2] = {-1, -1};
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
    ours = FileDescriptor(ends[0]);
    theirs = FileDescriptor(ends[1]);
  }
  FileDescriptor ours, theirs;
};

const std::string kRecord(1000, 'x');

/// Fills the link and all that lies behind it.
void fill(PeerLink& link) {
  while (link.put(kRecord)) ASSERT_TRUE(link.send_some());
}

TEST(PeerLink, counts_what_had_no_room_until_something_has) {
  Pair pair;
  PeerLink link(std::move(pair.ours), 4000);
  fill(link);
  EXPECT_EQ(link.lost(), 1U);
  EXPECT_FALSE(link.put(kRecord));
  EXPECT_EQ(link.behind(), 2U);
  std::string got(1 << 20, '\0');
  ASSERT_GT(::recv(pair.theirs.get(), got.data(), got.size(), 0), 0);
  ASSERT_TRUE(link.send_some());
  EXPECT_TRUE(link.put(kRecord));
  EXPECT_EQ(link.behind(), 0U);
  EXPECT_EQ(link.lost(), 2U);
}

TEST(PeerLink, makes_room_for_a_reader_who_reads_and_gives_up_on_one_who_sleeps) {
  Pair pair;
  PeerLink link(std::move(pair.ours), 4000);
  fill(link);
  EXPECT_TRUE(link.make_room(kRecord.size(), {.patience = 1ms})) << "he is there, though he sleeps";
  EXPECT_FALSE(link.put(kRecord));
  std::thread reader([&] {
    std::string got(1 << 20, '\0');
    EXPECT_GT(::recv(pair.theirs.get(), got.data(), got.size(), 0), 0);
  });
  reader.join();
  ASSERT_TRUE(link.send_some());
  EXPECT_TRUE(link.make_room(kRecord.size(), {.patience = 1s}));
  EXPECT_TRUE(link.put(kRecord));
}

TEST(PeerLink, sees_that_the_peer_has_gone) {
  Pair pair;
  PeerLink link(std::move(pair.ours));
  pair.theirs = FileDescriptor();
  EXPECT_TRUE(link.put(kRecord));
  EXPECT_FALSE(link.send_some());
  EXPECT_EQ(link.lost(), 0U);
  link.lose_the_rest();
  EXPECT_EQ(link.lost(), 1U);
}

TEST(PeerLink, at_the_end_waits_for_a_reader_no_longer_than_it_must) {
  Pair pair;
  PeerLink link(std::move(pair.ours), 4000);
  fill(link);
  const std::uint64_t before = link.lost();
  link.finish(1ms);
  EXPECT_GT(link.lost(), before) << "what still waits is lost, and counted";
}

}  // namespace
}  // namespace odas::peer_link_test
