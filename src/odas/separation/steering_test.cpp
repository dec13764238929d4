// SPDX-License-Identifier: MIT
#include "odas/separation/steering.hpp"

#include <cmath>
#include <complex>
#include <limits>
#include <random>

#include "support/wave_field.hpp"
#include <gtest/gtest.h>

namespace odas::steering_test {
namespace {

GeneralConfig array_of(std::size_t mics, int frame_size, float radius) {
  GeneralConfig general;
  general.size = {frame_size / 2, frame_size};
  general.spatialfilters.emplace();
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(-radius, radius);
  for (std::size_t m = 0; m < mics; ++m) {
    MicConfig mic;
    mic.mu = {uniform(random), uniform(random), uniform(random)};
    general.mics.push_back(mic);
  }
  return general;
}

class SteeringOfFrame : public testing::TestWithParam<int> {};

TEST_P(SteeringOfFrame, equals_the_definition_in_every_bin) {
  const GeneralConfig general = array_of(5, GetParam(), 0.5F);
  const Steering steering(general);
  ASSERT_EQ(steering.bins(), static_cast<std::size_t>(GetParam()) / 2 + 1);
  std::vector<cfloat> row(steering.bins());
  for (const Vec3 u : {direction_of(0, 0), direction_of(133, 40), Vec3{0.3F, -0.2F, 0.9F}}) {
    for (std::size_t m = 0; m < steering.mics(); ++m) {
      steering.row(m, u, 0.7F, row);
      for (std::size_t k = 0; k < row.size(); ++k) {
        const auto expected = 0.7 * test::phase_at(general, m, u, k);
        EXPECT_LT(std::abs(std::complex<double>(row[k]) - expected), 1e-6) << "mic " << m << " bin " << k;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Frames, SteeringOfFrame, testing::Values(2, 30, 32, 34, 256, 250, 1024, 8192));

TEST(Steering, of_the_opposite_direction_is_the_conjugate) {
  const Steering steering(array_of(1, 256, 0.1F));
  const Vec3 u = direction_of(20, 30);
  std::vector<cfloat> there(steering.bins());
  std::vector<cfloat> back(steering.bins());
  steering.row(0, u, 1, there);
  steering.row(0, -1.F * u, 1, back);
  for (std::size_t k = 0; k < there.size(); ++k) {
    EXPECT_LT(std::abs(there[k] - std::conj(back[k])), 1e-6F);
  }
}

// A wave reaches a microphone that lies towards the source first: its phase leads that at the origin.
TEST(Steering, leads_where_the_microphone_is_nearer_to_the_source) {
  GeneralConfig general = array_of(1, 256, 0);
  general.mics[0].mu = {0.05F, 0, 0};
  std::vector<cfloat> row(129);
  Steering(general).row(0, {1, 0, 0}, 1, row);
  EXPECT_GT(std::arg(row[1]), 0);
}

TEST(Steering, does_not_hear_what_is_under_the_smallest_gain) {
  GeneralConfig general = array_of(2, 256, 0.1F);
  general.mics[0].direction = {1, 0, 0};
  general.mics[0].angle = {80, 100};
  const Steering steering(general);
  std::array<float, 2> gains{};
  steering.gains({1, 0, 0}, gains);
  EXPECT_EQ(gains, (std::array<float, 2>{1, 1}));
  steering.gains({-1, 0, 0}, gains);
  EXPECT_EQ(gains, (std::array<float, 2>{0, 1}));
  // At 90 degrees the law is half way: over the smallest gain of 0.25.
  steering.gains({0, 1, 0}, gains);
  EXPECT_NEAR(gains[0], 0.5F, 1e-5F);
  // At 95 degrees it is 1 / (1 + e^5): under it.
  steering.gains(direction_of(95, 0), gains);
  EXPECT_EQ(gains[0], 0);
}

// As in ODAS: spatial filters say what may be found, not how a microphone hears it.
TEST(Steering, is_not_shaped_by_spatial_filters) {
  GeneralConfig general = array_of(1, 256, 0.1F);
  general.spatialfilters = {{SpatialFilterConfig{{0, 0, 1}, {80, 90}}}};
  std::array<float, 1> gains{};
  Steering(general).gains({0, 0, -1}, gains);
  EXPECT_EQ(gains[0], 1);
}

TEST(Steering, hears_nothing_from_a_direction_that_is_not_finite) {
  const Steering steering(array_of(2, 256, 0.1F));
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    std::array<float, 2> gains{1, 1};
    steering.gains({bad, 0, 0}, gains);
    EXPECT_EQ(gains, (std::array<float, 2>{0, 0}));
  }
}

}  // namespace
}  // namespace odas::steering_test
