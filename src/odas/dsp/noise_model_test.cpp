// SPDX-License-Identifier: MIT
#include "odas/dsp/noise_model.hpp"

#include <cmath>
#include <limits>

#include "support/machine_noise.hpp"
#include <gtest/gtest.h>

namespace odas::noise_model_test {
namespace {

using test::Machine;

constexpr BinRange kRange{4, 112};

NoiseModel model_of(int fan) {
  Machine machine(5);
  std::vector<cfloat> scm(Machine::kBins * Machine::kMics * Machine::kMics);
  for (int h = 0; h < 200; ++h) {
    const Grid<cfloat> x = machine.hop(fan);
    cfloat* r = scm.data();
    for (std::size_t k = 0; k < Machine::kBins; ++k) {
      for (std::size_t i = 0; i < Machine::kMics; ++i) {
        for (std::size_t j = 0; j < Machine::kMics; ++j) *r++ += x[i][k] * std::conj(x[j][k]);
      }
    }
  }
  return {scm, Machine::kMics, kRange};
}

TEST(NoiseModel, finds_its_own_noise_likelier_than_another_at_any_level) {
  const NoiseModel first = model_of(0);
  const NoiseModel second = model_of(1);
  Machine machine(6);
  for (const float level : {0.01F, 1.F, 100.F}) {
    const Grid<cfloat> x = machine.hop(0, level);
    EXPECT_GT(first.likeness(x.view()), second.likeness(x.view()) + 0.3F) << level;
  }
  EXPECT_GT(first.likeness(machine.hop(0, 1).view()), first.likeness(machine.hop(0, 1, 1).view()) + 0.3F)
      << "a talker is unlike";
}

TEST(NoiseModel, is_0_for_diffuse_noise_and_does_not_care_for_scale) {
  std::vector<cfloat> white(Machine::kBins * 16);
  for (std::size_t i = 0; i < white.size(); ++i) white[i] = i % 16 % 5 == 0 ? 1e-4F : 0;
  const NoiseModel model(white, 4, kRange);
  Machine machine;
  EXPECT_NEAR(model.likeness(machine.hop(0).view()), 0, 1e-4);
}

TEST(NoiseModel, of_a_covariance_is_that_of_a_hop_where_it_is_one_hop) {
  const NoiseModel model = model_of(0);
  Machine machine(8);
  const Grid<cfloat> x = machine.hop(1);
  std::vector<cfloat> scm;
  for (std::size_t k = 0; k < Machine::kBins; ++k) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) scm.push_back(x[i][k] * std::conj(x[j][k]));
    }
  }
  EXPECT_NEAR(model.likeness(scm), model.likeness(x.view()), 1e-3);
}

TEST(NoiseModel, counts_the_bins_that_tell_something) {
  const BinRange wide = telling_bins(16000, 512);
  EXPECT_EQ(wide.first, 7U);  // 31.25 Hz each
  EXPECT_EQ(wide.last, 224U);
  EXPECT_EQ(telling_bins(8000, 256).last, 128U) << "no bin lies above the Nyquist frequency";
}

TEST(NoiseModel, of_what_is_not_finite_is_not_finite) {
  Grid<cfloat> x(4, Machine::kBins);
  x.fill({std::numeric_limits<float>::infinity(), 0});
  EXPECT_FALSE(std::isfinite(model_of(0).likeness(x.view())));
}

}  // namespace
}  // namespace odas::noise_model_test
