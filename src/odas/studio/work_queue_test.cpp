// SPDX-License-Identifier: MIT
#include "odas/studio/work_queue.hpp"

#include <atomic>
#include <future>
#include <vector>

#include <gtest/gtest.h>

namespace odas::work_queue_test {
namespace {

TEST(WorkQueue, does_one_thing_after_another_in_order) {
  std::vector<int> done;
  std::promise<void> all;
  {
    WorkQueue queue;
    for (int i = 0; i < 100; ++i) queue.add([&done, i] { done.push_back(i); });
    queue.add([&] { all.set_value(); });
    all.get_future().wait();
  }
  ASSERT_EQ(done.size(), 100U);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
}

TEST(WorkQueue, begins_nothing_once_it_is_stopped) {
  WorkQueue queue;
  std::promise<void> begun, go;
  std::atomic<int> done{0};
  queue.add([&] {
    begun.set_value();
    go.get_future().wait();
    ++done;
  });
  queue.add([&] { ++done; });
  begun.get_future().wait();
  std::thread stopper([&] { queue.stop(); });
  queue.add([&] { ++done; });
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  go.set_value();
  stopper.join();
  EXPECT_LE(done.load(), 2) << "the one that ran, and at most one that began before the stop was known";
  const int before = done.load();
  queue.add([&] { ++done; });
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(done.load(), before);
}

}  // namespace
}  // namespace odas::work_queue_test
