// SPDX-License-Identifier: MIT
#include "odas/engine/block_feed.hpp"

#include "support/fake_io.hpp"
#include <gtest/gtest.h>

namespace odas::block_feed_test {
namespace {

/// The numbers of frames of all blocks of 100 that a feed of 250 frames gives.
std::vector<std::size_t> blocks(test::MemorySource& source, const RunOptions& options, RunSummary& summary) {
  BlockFeed feed(source, options, summary);
  Grid<float> block(1, 100);
  std::vector<std::size_t> sizes;
  while (const auto fed = feed.next(block)) sizes.push_back(fed->frames);
  return sizes;
}

using Sizes = std::vector<std::size_t>;

TEST(BlockFeed, gives_the_last_block_short_to_those_who_pad_it) {
  test::MemorySource source(test::noise(1, 250));
  RunSummary summary;
  EXPECT_EQ(blocks(source, {}, summary), (Sizes{100, 100, 50}));
  EXPECT_EQ(summary.frames, 250U);
  EXPECT_EQ(summary.end, RunSummary::End::end_of_input);
  EXPECT_EQ(summary.exit_code(), 0);
}

TEST(BlockFeed, begins_with_a_silent_block_and_drops_a_short_one_as_odas_does) {
  test::MemorySource source(test::noise(1, 250));
  RunOptions options;
  options.silent_first_block = true;
  options.pad_last_block = false;
  RunSummary summary;
  BlockFeed feed(source, options, summary);
  Grid<float> block(1, 100);
  block.fill(1);
  ASSERT_EQ(feed.next(block)->frames, 100U);
  for (const float x : block[0]) EXPECT_EQ(x, 0);
  EXPECT_EQ(feed.next(block)->frames, 100U);
  EXPECT_NE(block[0][0], 0);
  EXPECT_EQ(feed.next(block)->frames, 100U);
  EXPECT_FALSE(feed.next(block));
  EXPECT_EQ(summary.frames, 200U);
}

TEST(BlockFeed, tells_progress_and_the_sources_warning) {
  test::MemorySource source(test::noise(1, 250));
  source.remark = "ends early";
  std::vector<std::uint64_t> done;
  std::vector<std::string> told;
  RunOptions options;
  options.progress = [&](std::uint64_t frames, std::optional<std::uint64_t> total) {
    EXPECT_EQ(total, 250U);
    done.push_back(frames);
  };
  options.warn = [&](const std::string& warning) { told.push_back(warning); };
  RunSummary summary;
  blocks(source, options, summary);
  EXPECT_EQ(done, (std::vector<std::uint64_t>{100, 200, 250}));
  EXPECT_EQ(told, std::vector<std::string>{"ends early"});
  EXPECT_EQ(summary.warnings, told);
}

TEST(BlockFeed, stops_when_asked_to) {
  test::MemorySource source(test::noise(1, 250));
  const std::atomic<bool> stop{true};
  RunOptions options;
  options.stop = &stop;
  RunSummary summary;
  EXPECT_EQ(blocks(source, options, summary), Sizes());
  EXPECT_EQ(summary.end, RunSummary::End::stopped);
  EXPECT_EQ(summary.exit_code(), 0);
}

TEST(BlockFeed, keeps_what_came_before_a_failure_and_says_it) {
  test::MemorySource source(test::noise(1, 250));
  source.fault = "the card was pulled out";
  RunSummary summary;
  EXPECT_EQ(blocks(source, {}, summary), (Sizes{100, 100, 50}));
  EXPECT_EQ(summary.end, RunSummary::End::source_failed);
  EXPECT_EQ(summary.fault, "the card was pulled out");
  EXPECT_EQ(summary.exit_code(), 1);
}

TEST(BlockFeed, counts_what_the_source_has_lost_and_tells_what_it_has_to_say) {
  struct Returning : test::MemorySource {
    using MemorySource::MemorySource;
    ReadResult read(GridView<float> block) override {
      ReadResult result = MemorySource::read(block);
      result.lost = 7;
      result.notice = "it is back";
      return result;
    }
  } source(test::noise(1, 150));
  std::vector<std::string> told;
  RunOptions options;
  options.notice = [&](const std::string& notice) { told.push_back(notice); };
  RunSummary summary;
  BlockFeed feed(source, options, summary);
  Grid<float> block(1, 100);
  EXPECT_EQ(feed.next(block)->lost, 7U);
  EXPECT_EQ(feed.next(block)->lost, 7U);
  EXPECT_EQ(summary.metrics.lost_frames, 14U);
  EXPECT_EQ(summary.frames, 150U);
  EXPECT_EQ(told, (std::vector<std::string>{"it is back", "it is back"}));
  EXPECT_TRUE(summary.warnings.empty());
}

TEST(BlockFeed, takes_an_exception_of_a_source_as_its_failure) {
  struct Throwing : test::MemorySource {
    using MemorySource::MemorySource;
    ReadResult read(GridView<float>) override { throw std::runtime_error("broken"); }
  } source(test::noise(1, 250));
  RunSummary summary;
  EXPECT_EQ(blocks(source, {}, summary), Sizes());
  EXPECT_EQ(summary.fault, "broken");
}

}  // namespace
}  // namespace odas::block_feed_test
