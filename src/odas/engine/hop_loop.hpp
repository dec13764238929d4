// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>

#include "odas/engine/front_end.hpp"
#include "odas/engine/gap_plan.hpp"
#include "odas/engine/metrics.hpp"
#include "odas/engine/pipeline_inbox.hpp"
#include "odas/engine/target_inbox.hpp"
#include "odas/pipeline/pipeline.hpp"

namespace odas {

/// Blocks of the source in, results of hops out: what the engine's thread does, and what a run without
/// threads does in its stead.
class HopLoop {
 public:
  /// `targets`, `pipelines`: whence fixed directions and new pipelines come while it goes on, or nullptr.
  /// Throws ConfigError where source,
  /// configuration and pipeline do not fit each other.
  HopLoop(const Configuration& config, std::size_t channels, int source_rate, Pipeline& pipeline,
          TargetInbox* targets = nullptr, PipelineInbox* pipelines = nullptr);

  /// `take(const HopResult&)` is called for each hop that the block completes.
  template <class Take>
  void push(GridView<const float> block, Take&& take) {
    front_end_.push(block);
    while (front_end_.pop(hop_)) take(process());
  }
  /// `lost` frames of the source are missing here: what the pipeline holds runs out into silence, and `time`
  /// steps over the rest, so that later hops have the stamps that they would have had.
  template <class Take>
  void skip(std::uint64_t lost, Take&& take) {
    const GapPlan::Step step = gaps_.bridge(lost);
    for (std::uint64_t left = step.silence; left > 0;) {
      const auto n = static_cast<std::size_t>(std::min<std::uint64_t>(left, silence_.cols()));
      push(GridView<const float>(silence_.data(), silence_.rows(), n, silence_.cols()), take);
      left -= n;
    }
    pipeline_.skip_hops(step.hops);
    skipped_hops_ += step.hops;
  }
  /// The input has ended; a last hop is filled up with silence if `pad`. With a look-back, hops of silence
  /// follow until the last sound has come out.
  template <class Take>
  void finish(bool pad, Take&& take) {
    front_end_.finish();
    while (front_end_.pop(hop_)) take(process());
    if (pad && front_end_.pop_rest(hop_)) take(process());
    if (hops_ == 0) return;
    hop_.fill(0);
    for (std::size_t h = 0; h < rest_; ++h) take(process());
  }

  [[nodiscard]] InputHealth& health() noexcept { return front_end_.health(); }

  [[nodiscard]] std::uint64_t hops() const noexcept { return hops_; }
  /// Of all hops so far.
  [[nodiscard]] Metrics metrics() const noexcept;

 private:
  HopResult process() noexcept {
    if (pipelines_ != nullptr) pipelines_->deliver(pipeline_);
    if (targets_ != nullptr) targets_->deliver(pipeline_);
    const auto start = std::chrono::steady_clock::now();
    const HopResult result = pipeline_.process_hop(hop_);
    hop_time_.add(std::chrono::steady_clock::now() - start);
    if (targets_ != nullptr) targets_->note(pipeline_);
    ++hops_;
    return result;
  }

  FrontEnd front_end_;
  GapPlan gaps_;
  Grid<float> silence_;  // [channel][raw hop]
  std::size_t rest_;     // hops of silence after the input has ended
  Pipeline& pipeline_;
  TargetInbox* targets_;
  PipelineInbox* pipelines_;
  Grid<float> hop_;  // [mic][hop]
  TimeHistogram hop_time_;
  std::uint64_t hops_ = 0;
  std::uint64_t skipped_hops_ = 0;
};

}  // namespace odas
