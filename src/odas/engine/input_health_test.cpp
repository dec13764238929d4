// SPDX-License-Identifier: MIT
#include "odas/engine/input_health.hpp"

#include "support/allocation_counter.hpp"
#include "support/fake_io.hpp"
#include <gtest/gtest.h>

namespace odas::input_health_test {
namespace {

using Warnings = std::vector<std::string>;

constexpr int kRate = 16000;

/// What is said of these samples, heard in blocks of 128.
Warnings heard(const Grid<float>& samples, std::vector<int> map) {
  InputHealth health(std::move(map), kRate);
  for (std::size_t at = 0; at < samples.cols(); at += 128) {
    const std::size_t n = std::min<std::size_t>(128, samples.cols() - at);
    health.watch(GridView<const float>(samples.data() + at, samples.rows(), n, samples.cols()));
  }
  health.finish();
  return health.take_warnings();
}

Grid<float> sound(double seconds, std::size_t mics = 3) {
  return test::noise(mics, static_cast<std::size_t>(seconds * kRate));
}

TEST(InputHealth, says_nothing_of_good_microphones) { EXPECT_EQ(heard(sound(3), {1, 2, 3}), Warnings()); }

TEST(InputHealth, names_a_silent_microphone_and_its_channel) {
  Grid<float> samples = sound(2);
  std::fill(samples[2].begin(), samples[2].end(), 0.0F);
  EXPECT_EQ(heard(samples, {1, 2, 4}), Warnings{"microphone 3 (channel 4) is silent"});
}

TEST(InputHealth, takes_a_constant_microphone_as_silent) {
  Grid<float> samples = sound(2);
  std::fill(samples[0].begin(), samples[0].end(), 0.25F);
  EXPECT_EQ(heard(samples, {1, 2, 3}), Warnings{"microphone 1 (channel 1) is silent"});
}

TEST(InputHealth, finds_one_that_dies_on_the_way) {
  Grid<float> samples = sound(4);
  std::fill(samples[1].begin() + 2 * kRate, samples[1].end(), 0.0F);
  EXPECT_EQ(heard(samples, {1, 2, 3}), Warnings{"microphone 2 (channel 2) is silent"});
}

TEST(InputHealth, lets_a_recording_begin_with_silence_on_all_microphones) {
  Grid<float> samples = sound(6);
  for (std::size_t m = 0; m < 3; ++m) std::fill(samples[m].begin(), samples[m].begin() + 3 * kRate, 0.0F);
  EXPECT_EQ(heard(samples, {1, 2, 3}), Warnings());
}

TEST(InputHealth, says_that_all_are_silent) {
  EXPECT_EQ(heard(Grid<float>(3, kRate / 2), {1, 2, 3}).size(), 1U) << "short, at its end";
  const Warnings warnings = heard(Grid<float>(3, std::size_t{6} * kRate), {1, 2, 3});
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("all microphones are silent"), std::string::npos);
}

TEST(InputHealth, finds_two_that_hear_the_very_same) {
  Grid<float> samples = sound(2);
  std::copy(samples[0].begin(), samples[0].end(), samples[2].begin());
  EXPECT_EQ(heard(samples, {1, 2, 3}),
            Warnings{"microphone 3 (channel 3) is the same as microphone 1 (channel 1), sample by sample"});
}

TEST(InputHealth, does_not_call_silent_ones_the_same) {
  Grid<float> samples = sound(2);
  for (const std::size_t m : {0U, 1U}) std::fill(samples[m].begin(), samples[m].end(), 0.0F);
  EXPECT_EQ(heard(samples, {1, 2, 3}),
            (Warnings{"microphone 1 (channel 1) is silent", "microphone 2 (channel 2) is silent"}));
}

TEST(InputHealth, finds_a_clipped_one_but_no_single_loud_peak) {
  Grid<float> samples = sound(2);
  samples[0][100] = 1;
  for (float& x : samples[1]) x = std::clamp(20 * x, -1.0F, 1.0F);
  const Warnings warnings = heard(samples, {1, 2, 3});
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0], "microphone 2 (channel 2) is clipped: the input is too loud");
}

TEST(InputHealth, does_not_watch_what_the_map_silences) {
  Grid<float> samples = sound(2);
  std::fill(samples[1].begin(), samples[1].end(), 0.0F);
  EXPECT_EQ(heard(samples, {1, 0, 3}), Warnings());
}

TEST(InputHealth, says_each_thing_once) {
  Grid<float> samples = sound(1);
  std::fill(samples[0].begin(), samples[0].end(), 0.0F);
  InputHealth health({1, 2, 3}, kRate);
  health.watch(samples);
  EXPECT_EQ(health.take_warnings().size(), 1U);
  health.watch(samples);
  EXPECT_EQ(health.take_warnings(), Warnings());
}

TEST(InputHealth, judges_also_a_recording_shorter_than_a_second) {
  Grid<float> samples = sound(0.5);
  std::fill(samples[0].begin(), samples[0].end(), 0.0F);
  EXPECT_EQ(heard(samples, {1, 2, 3}).size(), 1U);
}

TEST(InputHealth, allocates_nothing_while_watching) {
  const Grid<float> samples = sound(2);
  InputHealth health({1, 2, 3}, kRate);
  const auto before = test::allocations();
  health.watch(samples);
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace odas::input_health_test
