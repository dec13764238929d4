// SPDX-License-Identifier: MIT
#include "odas/base/spsc_queue.hpp"

#include <deque>
#include <thread>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace odas::spsc_queue_test {
namespace {

RC_GTEST_PROP(SpscQueue, behaves_as_a_bounded_deque, (const std::vector<bool>& pushes)) {
  const auto capacity = *rc::gen::inRange<std::size_t>(1, 6);
  SpscQueue<int> queue(capacity, 0);
  std::deque<int> model;
  int next = 0;
  for (const bool push : pushes) {
    if (push) {
      int* element = queue.begin_push();
      RC_ASSERT((element != nullptr) == (model.size() < capacity));
      if (element == nullptr) continue;
      *element = next;
      queue.end_push();
      model.push_back(next++);
    } else {
      const int* element = queue.front();
      RC_ASSERT((element != nullptr) == !model.empty());
      if (element == nullptr) continue;
      RC_ASSERT(*element == model.front());
      queue.pop();
      model.pop_front();
    }
  }
}

TEST(SpscQueue, hands_every_element_over_once_and_in_order_between_two_threads) {
  constexpr int kCount = 50000;
  SpscQueue<std::vector<int>> queue(7, std::vector<int>(3));
  std::thread producer([&] {
    for (int i = 0; i < kCount; ++i) {
      std::vector<int>& element = queue.wait_push();
      element = {i, i + 1, i + 2};
      queue.end_push();
    }
  });
  int wrong = 0;
  for (int i = 0; i < kCount; ++i) {
    wrong += queue.wait_front() != std::vector<int>{i, i + 1, i + 2};
    queue.pop();
  }
  producer.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(queue.front(), nullptr);
}

TEST(SpscQueue, keeps_the_memory_of_its_elements) {
  SpscQueue<std::vector<int>> queue(2, std::vector<int>(100));
  const int* memory = queue.begin_push()->data();
  for (int i = 0; i < 2; ++i) {
    queue.end_push();
    queue.pop();
    ASSERT_NE(queue.begin_push(), nullptr);
    EXPECT_EQ(queue.begin_push()->size(), 100U);
  }
  EXPECT_EQ(queue.begin_push()->data(), memory);
}

}  // namespace
}  // namespace odas::spsc_queue_test
