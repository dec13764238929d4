// SPDX-License-Identifier: MIT
#include "odas/engine/front_end.hpp"

#include <cmath>
#include <limits>

#include "support/allocation_counter.hpp"
#include "support/fake_io.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::front_end_test {
namespace {

double power(std::span<const float> x) {
  double sum = 0;
  for (const float v : x) sum += static_cast<double>(v) * static_cast<double>(v);
  return sum;
}

/// Channel c holds c + 1 everywhere.
Grid<float> numbered(std::size_t channels, std::size_t frames) {
  Grid<float> block(channels, frames);
  for (std::size_t c = 0; c < channels; ++c) {
    std::fill(block[c].begin(), block[c].end(), static_cast<float>(c + 1));
  }
  return block;
}

TEST(FrontEnd, picks_the_channels_of_the_map_and_makes_0_silence) {
  Configuration config = test::small_configuration(3);
  config.mapping.map = {4, 0, 1};
  FrontEnd front_end(config, 4, 16000);
  front_end.push(numbered(4, 128));
  Grid<float> hop(3, 128);
  ASSERT_TRUE(front_end.pop(hop));
  for (std::size_t i = 0; i < 128; ++i) {
    EXPECT_EQ(hop[0][i], 4);
    EXPECT_EQ(hop[1][i], 0);
    EXPECT_EQ(hop[2][i], 1);
  }
  EXPECT_FALSE(front_end.pop(hop));
}

TEST(FrontEnd, without_a_map_takes_the_first_channels_in_order) {
  FrontEnd front_end(test::small_configuration(2), 4, 16000);
  front_end.push(numbered(4, 128));
  Grid<float> hop(2, 128);
  ASSERT_TRUE(front_end.pop(hop));
  EXPECT_EQ(hop[0][5], 1);
  EXPECT_EQ(hop[1][5], 2);
}

TEST(FrontEnd, refuses_a_map_that_does_not_fit) {
  Configuration config = test::small_configuration(2);
  config.mapping.map = {1, 5};
  EXPECT_THROW(FrontEnd(config, 4, 16000), ConfigError);
  config.mapping.map = {1, 2, 3};
  EXPECT_THROW(FrontEnd(config, 4, 16000), ConfigError);
}

TEST(FrontEnd, makes_hops_of_blocks_of_any_size_and_pads_the_last) {
  Configuration config = test::small_configuration(1);
  config.raw.hop_size = 300;
  FrontEnd front_end(config, 1, 16000);
  const Grid<float> samples = test::noise(1, 700);
  std::vector<float> out;
  Grid<float> hop(1, 128);
  const auto take = [&] { out.insert(out.end(), hop[0].begin(), hop[0].end()); };
  for (const std::size_t at : {0U, 300U, 600U}) {
    const std::size_t n = std::min<std::size_t>(300, 700 - at);
    front_end.push(GridView<const float>(samples.data() + at, 1, n));
    while (front_end.pop(hop)) take();
  }
  front_end.finish();
  while (front_end.pop(hop)) take();
  EXPECT_EQ(out.size(), 5U * 128);
  ASSERT_TRUE(front_end.pop_rest(hop));
  take();
  EXPECT_FALSE(front_end.pop_rest(hop));
  for (std::size_t i = 0; i < out.size(); ++i) EXPECT_EQ(out[i], i < 700 ? samples[0][i] : 0.0F) << i;
}

TEST(FrontEnd, counts_what_is_not_finite_before_a_filter_smears_it) {
  FrontEnd front_end(test::small_configuration(1), 1, 48000);
  Grid<float> block = test::noise(1, 128);
  block[0][10] = std::numeric_limits<float>::quiet_NaN();
  block[0][11] = std::numeric_limits<float>::infinity();
  Grid<float> hop(1, 128);
  for (int i = 0; i < 6; ++i) {
    front_end.push(block);
    if (!front_end.pop(hop)) continue;
    for (const float x : hop[0]) EXPECT_TRUE(std::isfinite(x));
  }
  EXPECT_EQ(front_end.non_finite_samples(), 12U);
}

TEST(FrontEnd, brings_a_recording_to_the_processing_rate) {
  Configuration config = test::small_configuration(1);
  config.raw.hop_size = 480;
  FrontEnd front_end(config, 1, 48000);
  Grid<float> block(1, 480);
  Grid<float> hop(1, 128);
  std::size_t hops = 0;
  float error = 0;
  for (std::size_t b = 0; b < 100; ++b) {
    for (std::size_t i = 0; i < 480; ++i) { block[0][i] = std::sin(0.05F * static_cast<float>(480 * b + i)); }
    front_end.push(block);
    for (; front_end.pop(hop); ++hops) {
      for (std::size_t i = 0; i < 128 && hops > 1; ++i) {
        const float expected = std::sin(0.15F * static_cast<float>(128 * hops + i));
        error = std::max(error, std::fabs(hop[0][i] - expected));
      }
    }
  }
  EXPECT_EQ(hops, 100U * 160 / 128 - 1) << "the last is held back by the filter";
  EXPECT_LT(error, 2e-3F);
}

/// What the machine plays is channel 3; microphone 1 hears half of it.
TEST(FrontEnd, takes_what_the_machine_plays_out_of_the_microphones) {
  for (const int rate : {16000, 48000}) {
    Configuration config = test::small_configuration(2);
    config.mapping.reference = {3};
    config.mapping.echo_length = 20;
    FrontEnd front_end(config, 3, rate);
    EXPECT_EQ(front_end.mics(), 2U);
    const Grid<float> sound = test::noise(2, 5 * 48000);
    Grid<float> block(3, 128);
    Grid<float> hop(2, 128);
    double first = 0;
    double last = 0;
    for (std::size_t at = 0; at + 128 <= sound.cols(); at += 128) {
      for (std::size_t i = 0; i < 128; ++i) {
        block[0][i] = 0.5F * sound[0][at + i];
        block[1][i] = sound[1][at + i];
        block[2][i] = sound[0][at + i];
      }
      front_end.push(block);
      for (; front_end.pop(hop); last = power(hop[0])) {
        if (first == 0) first = power(hop[0]);
      }
    }
    EXPECT_LT(last, 0.01 * first) << rate;
    EXPECT_GT(front_end.echo_return_loss_db(), 0) << rate;
  }
}

TEST(FrontEnd, changes_no_bit_for_a_reference_that_is_dead) {
  Configuration config = test::small_configuration(2);
  config.raw.hop_size = 300;
  FrontEnd plain(config, 3, 16000);
  config.mapping.reference = {3};
  FrontEnd with_reference(config, 3, 16000);
  Grid<float> block = test::noise(3, 300);
  std::fill(block[2].begin(), block[2].end(), 0.F);
  Grid<float> expected(2, 128);
  Grid<float> hop(2, 128);
  const auto compare = [&] {
    for (std::size_t i = 0; i < 256; ++i) EXPECT_EQ(hop.data()[i], expected.data()[i]);
  };
  for (int b = 0; b < 5; ++b) {
    plain.push(block);
    with_reference.push(block);
    while (plain.pop(expected)) {
      ASSERT_TRUE(with_reference.pop(hop));
      compare();
    }
  }
  plain.finish();
  with_reference.finish();
  ASSERT_TRUE(plain.pop_rest(expected));
  ASSERT_TRUE(with_reference.pop_rest(hop));
  compare();
}

TEST(FrontEnd, refuses_a_reference_that_is_not_there) {
  Configuration config = test::small_configuration(2);
  config.mapping.reference = {4};
  EXPECT_THROW(FrontEnd(config, 3, 16000), ConfigError);
}

TEST(FrontEnd, allocates_nothing_for_a_block) {
  for (const int rate : {16000, 48000}) {
    Configuration config = test::small_configuration(3);
    config.mapping.reference = {4};
    FrontEnd front_end(config, 4, rate);
    const Grid<float> block = test::noise(4, 128);
    Grid<float> hop(3, 128);
    const auto before = test::allocations();
    for (int i = 0; i < 20; ++i) {
      front_end.push(block);
      while (front_end.pop(hop)) {}
    }
    front_end.finish();
    EXPECT_EQ(test::allocations(), before) << rate;
  }
}

}  // namespace
}  // namespace odas::front_end_test
