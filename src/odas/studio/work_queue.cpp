// SPDX-License-Identifier: MIT
#include "odas/studio/work_queue.hpp"

#include <utility>

#include "odas/engine/signals_blocked.hpp"

namespace odas {

WorkQueue::WorkQueue() {
  const SignalsBlocked signals_blocked;
  thread_ = std::thread([this] { work(); });
}

WorkQueue::~WorkQueue() { stop(); }

void WorkQueue::add(std::function<void()> task) {
  {
    const std::lock_guard lock(mutex_);
    if (stop_) return;
    tasks_.push_back(std::move(task));
  }
  bell_.notify_one();
}

void WorkQueue::stop() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  bell_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void WorkQueue::work() {
  for (;;) {
    std::function<void()> task;
    {
      std::unique_lock lock(mutex_);
      bell_.wait(lock, [this] { return stop_ || !tasks_.empty(); });
      if (stop_) return;
      task = std::move(tasks_.front());
      tasks_.pop_front();
    }
    task();
  }
}

}  // namespace odas
