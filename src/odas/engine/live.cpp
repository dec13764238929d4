// SPDX-License-Identifier: MIT
#include "odas/engine/live.hpp"

#include <deque>
#include <thread>
#include <utility>

#include "odas/base/spsc_queue.hpp"
#include "odas/engine/denormals.hpp"
#include "odas/engine/hop_record.hpp"
#include "odas/engine/run_report.hpp"
#include "odas/engine/signals_blocked.hpp"

namespace odas {
namespace {

// Half a second of hops of 8 ms: what a scheduler may take away without a loss.
constexpr std::size_t kQueueLength = 64;

/// A block of the source on its way to the engine.
struct Block {
  Grid<float> samples;  // [channel][raw hop]
  std::size_t frames = 0;
  std::uint64_t lost = 0;  // frames before these
  bool end = false;
};

/// The engine's results on their way to the sinks: a queue for each, and a bell that wakes their thread.
class Outbox {
 public:
  Outbox(std::span<Sink* const> sinks, const PipelineConfig& config, const Pipeline& pipeline, bool may_drop)
      : may_drop_(may_drop) {
    for (const Sink* sink : sinks) {
      queues_.emplace_back(kQueueLength, HopRecord(sink->wanted(), config, pipeline.power_grid().size()));
    }
  }

  /// Engine: hands a hop to all sinks.
  void send(const HopResult& hop) noexcept {
    for (auto& queue : queues_) {
      HopRecord* record = may_drop_ ? queue.begin_push() : &queue.wait_push();
      if (record == nullptr) {
        ++dropped_;
        continue;
      }
      record->assign(hop);
      queue.end_push();
    }
    ring();
  }
  /// Engine: there will be no more.
  void send_end() noexcept {
    for (auto& queue : queues_) {
      queue.wait_push().end = true;
      queue.end_push();
    }
    ended_.store(true, std::memory_order_release);
    ring();
  }
  /// Anyone: wakes the thread of the sinks.
  void ring() noexcept {
    bell_.fetch_add(1, std::memory_order_release);
    bell_.notify_one();
  }

  /// Sinks' thread: writes until the end.
  void deliver(SinkGroup& sinks) {
    std::size_t open = queues_.size();
    for (;;) {
      const std::uint32_t heard = bell_.load(std::memory_order_acquire);
      if (open == 0 && ended_.load(std::memory_order_acquire)) return;
      bool idle = true;
      for (std::size_t s = 0; s < queues_.size(); ++s) {
        while (const HopRecord* record = queues_[s].front()) {
          idle = false;
          if (record->end) {
            --open;
          } else {
            sinks.write(s, record->view());
          }
          queues_[s].pop();
        }
      }
      sinks.flush_in_time();
      if (idle) bell_.wait(heard, std::memory_order_acquire);
    }
  }

  [[nodiscard]] std::uint64_t dropped() const noexcept { return dropped_; }

 private:
  bool may_drop_;
  std::deque<SpscQueue<HopRecord>> queues_;  // a deque: queues cannot be moved
  std::atomic<std::uint32_t> bell_{0};
  std::atomic<bool> ended_{false};
  std::uint64_t dropped_ = 0;  // engine's
};

/// Leaves the engine's figures where others can see them, now and then.
void leave_metrics(LiveMetrics* to, const HopLoop& loop, const Outbox& outbox) noexcept {
  if (to == nullptr || loop.hops() % LiveMetrics::kPeriod != 0) return;
  Metrics metrics = loop.metrics();
  metrics.dropped_hops = outbox.dropped();
  to->note_engine(metrics);
}

void run_engine(SpscQueue<Block>& inbox, HopLoop& loop, Outbox& outbox, const RunOptions& options) noexcept {
  const FlushDenormals flush_denormals;
  const auto send = [&](const HopResult& hop) {
    outbox.send(hop);
    leave_metrics(options.metrics, loop, outbox);
  };
  for (bool end = false; !end;) {
    const Block& block = inbox.wait_front();
    const Grid<float>& samples = block.samples;
    if (block.lost > 0) loop.skip(block.lost, send);
    loop.push(GridView<const float>(samples.data(), samples.rows(), block.frames, samples.cols()), send);
    end = block.end;
    inbox.pop();
  }
  loop.finish(options.pad_last_block, send);
  outbox.send_end();
}

}  // namespace

RunSummary run_live(AudioSource& source, const Configuration& config, Pipeline& pipeline,
                    std::span<Sink* const> sinks, const RunOptions& options) {
  RunSummary summary;
  HopLoop loop(config, source.channels(), source.sample_rate(), pipeline, options.targets, options.pipelines);
  BlockFeed feed(source, options, summary);
  SinkGroup group(sinks);
  HealthWatch watch(loop.health(), source.sample_rate(), feed);
  Outbox outbox(sinks, config.pipeline, pipeline, source.live());
  SpscQueue<Block> inbox(kQueueLength,
                         {Grid<float>(source.channels(), static_cast<std::size_t>(config.raw.hop_size))});

  std::thread engine;
  std::thread writer;
  {
    const SignalsBlocked signals_blocked;
    engine = std::thread([&] { run_engine(inbox, loop, outbox, options); });
    writer = std::thread([&] { outbox.deliver(group); });
  }

  Block spare = {Grid<float>(source.channels(), static_cast<std::size_t>(config.raw.hop_size))};
  std::uint64_t lost = 0;  // frames that the engine has not been told of yet
  const auto leave_losses = [&] {
    if (options.metrics != nullptr) {
      options.metrics->note_source(summary.metrics.overruns, summary.metrics.lost_frames);
    }
  };
  for (bool over = false; !over;) {
    Block* block = source.live() ? inbox.begin_push() : &inbox.wait_push();
    Block& target = block != nullptr ? *block : spare;
    const auto fed = feed.next(target.samples, group.failed());
    over = !fed;
    const std::size_t frames = fed ? fed->frames : 0;
    if (fed) lost += fed->lost;
    leave_losses();
    if (block == nullptr && over) block = &inbox.wait_push();
    if (block == nullptr) {
      if (frames > 0) ++summary.metrics.overruns;
      summary.metrics.lost_frames += frames;
      lost += frames;
      continue;
    }
    if (!over && frames == 0 && lost == 0) {
      outbox.ring();  // so that what is written is flushed in time
      continue;
    }
    block->frames = frames;
    block->lost = std::exchange(lost, 0);
    block->end = over;
    inbox.end_push();
    watch.passed(frames);
  }
  engine.join();
  writer.join();
  group.close();
  summary.metrics.dropped_hops = outbox.dropped();
  finish_summary(summary, loop, group, feed);
  return summary;
}

}  // namespace odas
