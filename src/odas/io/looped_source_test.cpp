// SPDX-License-Identifier: MIT
#include "odas/io/looped_source.hpp"

#include <vector>

#include "support/fake_io.hpp"
#include <gtest/gtest.h>

namespace odas::looped_source_test {
namespace {

Grid<float> ramp(std::size_t frames) {
  Grid<float> samples(2, frames);
  for (std::size_t i = 0; i < frames; ++i) {
    samples[0][i] = static_cast<float>(i);
    samples[1][i] = -static_cast<float>(i);
  }
  return samples;
}

TEST(LoopedSource, gives_a_recording_again_and_again_without_a_gap) {
  for (const std::size_t block_size : {1U, 3U, 7U, 20U}) {
    LoopedSource source([] { return std::make_unique<test::MemorySource>(ramp(7)); });
    Grid<float> block(2, block_size);
    std::size_t frame = 0;
    for (int i = 0; i < 20; ++i) {
      const ReadResult read = source.read(block);
      ASSERT_EQ(read.frames, block_size);
      ASSERT_FALSE(read.end);
      for (std::size_t k = 0; k < block_size; ++k, ++frame) {
        ASSERT_EQ(block[0][k], static_cast<float>(frame % 7)) << "frame " << frame;
        ASSERT_EQ(block[1][k], -static_cast<float>(frame % 7));
      }
    }
  }
}

TEST(LoopedSource, ends_where_there_is_nothing_to_loop_or_the_recording_is_damaged) {
  LoopedSource empty([] { return std::make_unique<test::MemorySource>(Grid<float>(2, 0)); });
  Grid<float> block(2, 4);
  EXPECT_TRUE(empty.read(block).end);

  LoopedSource damaged([] {
    auto source = std::make_unique<test::MemorySource>(ramp(3));
    source->fault = "is damaged";
    return source;
  });
  const ReadResult read = damaged.read(block);
  EXPECT_TRUE(read.end);
  EXPECT_EQ(read.frames, 3U);
  EXPECT_EQ(read.status.what(), "is damaged");
}

}  // namespace
}  // namespace odas::looped_source_test
