// SPDX-License-Identifier: MIT
#include "odas/dsp/noise_learner.hpp"

#include <cmath>
#include <limits>

#include "support/machine_noise.hpp"
#include <gtest/gtest.h>

namespace odas::noise_learner_test {
namespace {

using test::Machine;

TEST(NoiseLearner, makes_one_entry_of_a_machine_that_does_one_thing) {
  Machine machine;
  NoiseLearner learner = Machine::learner();
  for (int h = 0; h < 400; ++h) learner.hear(machine.hop(0));
  const NoiseDictionary dictionary = learner.learn(8);
  ASSERT_EQ(dictionary.entries.size(), 1U);
  EXPECT_EQ(dictionary.entries[0].share, 1);
  EXPECT_NEAR(learner.seconds(), 3.2, 1e-6);
  // Powers: the fan's 2 and 0.005 of noise; real and imaginary part have a variance of 1.
  for (const std::size_t k : {10U, 64U, 120U}) EXPECT_NEAR(dictionary.scm(0, k)[0].real(), 2, 0.5) << k;
}

TEST(NoiseLearner, tells_the_states_of_a_machine_apart) {
  const NoiseDictionary dictionary = Machine::dictionary();
  ASSERT_EQ(dictionary.entries.size(), 2U);
  EXPECT_NEAR(dictionary.entries[0].share, 0.5, 0.1);
  EXPECT_EQ(dictionary.sample_rate, Machine::kRate);
  EXPECT_EQ(dictionary.bins(), Machine::kBins);
  EXPECT_EQ(dictionary.mics.size(), Machine::kMics);
}

TEST(NoiseLearner, keeps_within_the_number_of_entries_asked_for) {
  Machine machine;
  NoiseLearner learner = Machine::learner();
  for (int h = 0; h < 400; ++h) learner.hear(machine.hop(h / 100 % 2));
  EXPECT_EQ(learner.learn(1).entries.size(), 1U);
}

TEST(NoiseLearner, finds_speech_uneven_and_fans_not) {
  Machine machine;
  NoiseLearner fan = Machine::learner();
  for (int h = 0; h < 1000; ++h) fan.hear(machine.hop(h < 500 ? 0 : 1, h < 500 ? 1 : 5));
  EXPECT_LE(fan.uneven().size(), 1U) << "the second in which it changes may be";
  NoiseLearner talk = Machine::learner();
  for (int h = 0; h < 1000; ++h) talk.hear(machine.hop(0, 1, h / 20 % 2 == 0 ? 4 : 0));  // syllables
  EXPECT_GT(talk.uneven().size(), 6U);
}

TEST(NoiseLearner, hears_long_recordings_within_bounds_and_all_of_them) {
  Machine machine;
  NoiseLearner learner = Machine::learner();
  const Grid<cfloat> first = machine.hop(0);
  const Grid<cfloat> second = machine.hop(1);
  for (int h = 0; h < 40000; ++h) learner.hear(h < 20000 ? first : second);
  const NoiseDictionary dictionary = learner.learn(8);
  ASSERT_GE(dictionary.entries.size(), 2U);
  EXPECT_NEAR(dictionary.entries[0].share, 0.5, 0.15);
}

TEST(NoiseLearner, passes_over_what_is_silent_or_not_finite) {
  NoiseLearner learner = Machine::learner();
  Grid<cfloat> x(Machine::kMics, Machine::kBins);
  for (int h = 0; h < 100; ++h) learner.hear(x);
  x.fill({std::numeric_limits<float>::quiet_NaN(), 0});
  for (int h = 0; h < 100; ++h) learner.hear(x);
  EXPECT_EQ(learner.seconds(), 0);
  EXPECT_TRUE(learner.learn(8).empty());
}

}  // namespace
}  // namespace odas::noise_learner_test
