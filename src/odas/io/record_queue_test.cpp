// SPDX-License-Identifier: MIT
#include "odas/io/record_queue.hpp"

#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace odas::record_queue_test {
namespace {

std::string waiting(const RecordQueue& queue) { return {queue.front().begin(), queue.front().end()}; }

TEST(RecordQueue, takes_a_record_whole_or_not_at_all) {
  RecordQueue queue(8);
  EXPECT_TRUE(queue.put(std::string("hello")));
  EXPECT_FALSE(queue.put(std::string("world")));
  EXPECT_TRUE(queue.put(std::string("abc")));
  EXPECT_EQ(waiting(queue), "helloabc");
  EXPECT_EQ(queue.records(), 2U);
  queue.pop(6);
  EXPECT_EQ(waiting(queue), "bc");
  EXPECT_EQ(queue.records(), 1U);
}

TEST(RecordQueue, an_empty_one_takes_a_record_of_any_size) {
  RecordQueue queue(4);
  EXPECT_TRUE(queue.put(std::string(100, 'x')));
  EXPECT_FALSE(queue.put(std::string("y")));
  queue.pop(100);
  EXPECT_TRUE(queue.empty());
  EXPECT_TRUE(queue.put(std::string("y")));
}

RC_GTEST_PROP(RecordQueue, what_comes_out_is_what_was_taken_in_pieces_of_any_size, ()) {
  RecordQueue queue(64);
  std::string taken, sent;
  std::size_t refused = 0, put = 0, whole = 0;
  const auto steps = *rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(1, 40), rc::gen::inRange(0, 60)));
  for (const auto& [size, piece] : steps) {
    const std::string record(static_cast<std::size_t>(size), static_cast<char>('a' + size % 26));
    ++put;
    if (queue.put(record)) {
      taken += record;
      ++whole;
    } else {
      ++refused;
    }
    const std::size_t count = std::min(static_cast<std::size_t>(piece), queue.front().size());
    sent.append(queue.front().data(), count);
    queue.pop(count);
  }
  sent += waiting(queue);
  RC_ASSERT(sent == taken);
  RC_ASSERT(whole + refused == put);
}

}  // namespace
}  // namespace odas::record_queue_test
