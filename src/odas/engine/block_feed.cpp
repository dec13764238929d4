// SPDX-License-Identifier: MIT
#include "odas/engine/block_feed.hpp"

#include <exception>
#include <utility>

namespace odas {

BlockFeed::BlockFeed(AudioSource& source, const RunOptions& options, RunSummary& summary)
    : source_(source), options_(options), summary_(summary) {}

void BlockFeed::warn(std::string warning) {
  if (options_.warn) options_.warn(warning);
  summary_.warnings.push_back(std::move(warning));
}

void BlockFeed::finish() {
  IoStatus status;
  try {
    status = source_.finish();
  } catch (const std::exception& error) { status = IoStatus::failed(error.what()); }
  if (status.ok() || !summary_.fault.empty()) return;
  summary_.end = RunSummary::End::source_failed;
  summary_.fault = status.what();
}

std::optional<BlockFeed::Block> BlockFeed::next(GridView<float> block, bool cancelled) {
  if (over_ || cancelled) return std::nullopt;
  if (options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed)) {
    summary_.end = RunSummary::End::stopped;
    return std::nullopt;
  }
  if (std::exchange(first_, false) && options_.silent_first_block) {
    for (std::size_t c = 0; c < block.rows(); ++c) std::fill(block[c].begin(), block[c].end(), 0.0F);
    return Block{block.cols(), 0};
  }
  ReadResult read;
  try {
    read = source_.read(block);
  } catch (const std::exception& error) {
    read.end = true;
    read.status = IoStatus::failed(error.what());
  }
  over_ = read.end;
  if (!read.notice.empty() && options_.notice) options_.notice(read.notice);
  if (!read.status.ok()) {
    summary_.end = RunSummary::End::source_failed;
    summary_.fault = read.status.what();
  }
  if (read.end) {
    if (std::string warning = source_.warning(); !warning.empty()) warn(std::move(warning));
    if (read.frames < block.cols() && !options_.pad_last_block) read.frames = 0;
  }
  summary_.frames += read.frames;
  summary_.metrics.lost_frames += read.lost;
  if (options_.progress) options_.progress(summary_.frames, source_.total_frames());
  if (over_ && read.frames == 0 && read.lost == 0) return std::nullopt;
  return Block{read.frames, read.lost};
}

}  // namespace odas
