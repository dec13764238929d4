// SPDX-License-Identifier: MIT
#include "odas/tracking/observation_model.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace odas::observation_model_test {
namespace {

constexpr TangentCovariance kTold{0.001F, 0.002F, 0};

std::vector<Observation> take(const std::vector<Potential>& potentials) {
  std::vector<Observation> heard;
  ObservationModel(SstConfig()).take(potentials, heard);
  return heard;
}

TEST(ObservationModel, azimuths_are_as_far_apart_as_the_shorter_way_round) {
  EXPECT_NEAR(azimuth_between(direction_of(170, 40), direction_of(-170, -10)), 20 * kDegree, 1e-6);
  EXPECT_NEAR(azimuth_between(direction_of(0, 0), direction_of(90, 80)), 90 * kDegree, 1e-6);
}

TEST(ObservationModel, what_is_no_number_and_what_has_no_direction_is_not_taken) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto heard = take({{{nan, 0, 0}, 0.1F, 3, kTold},
                           {{0, 0, 0}, 0.1F, 3, kTold},
                           {{1, 0, 0}, nan, 3, kTold},
                           {{1, 0, 0}, 0.1F, nan, kTold},
                           {{0, 2, 0}, 0.1F, 3, kTold}});
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_EQ(heard[0].direction, (Vec3{0, 1, 0}));
  EXPECT_NEAR(heard[0].loudness, std::log(0.1), 1e-6);
  EXPECT_NEAR(heard[0].ratio, std::exp(3.0), 1e-6);
}

TEST(ObservationModel, what_is_clearer_elsewhere_leads_and_what_is_less_clear_tells_less) {
  const auto heard = take({{direction_of(0, 0), 0.1F, 4, kTold},
                           {direction_of(60, 0), 0.05F, 2, kTold},
                           {direction_of(2, 50), 0.02F, 1, kTold}});
  ASSERT_EQ(heard.size(), 3U);
  EXPECT_TRUE(heard[0].leads);
  EXPECT_EQ(heard[0].new_ratio, heard[0].ratio);
  EXPECT_EQ(heard[0].old_ratio, heard[0].ratio);
  EXPECT_FALSE(heard[1].leads);
  EXPECT_LT(heard[1].new_ratio, heard[1].ratio);
  EXPECT_LT(heard[1].old_ratio, heard[1].ratio);
}

TEST(ObservationModel, what_is_clearer_at_the_same_azimuth_takes_no_lead) {
  const auto heard = take({{direction_of(0, 0), 0.1F, 4, kTold}, {direction_of(2, 50), 0.05F, 2, kTold}});
  EXPECT_TRUE(heard[1].leads);
}

TEST(ObservationModel, where_no_evidence_is_told_the_mixtures_tell_it) {
  SstConfig config;
  const auto ratio_of = [&](float energy) {
    std::vector<Observation> heard;
    ObservationModel(config).take(std::vector<Potential>{{{1, 0, 0}, energy}}, heard);
    EXPECT_EQ(heard.at(0).covariance.east, config.sigma_r2_active);
    EXPECT_EQ(heard.at(0).loudness, 0);
    return heard.at(0).ratio;
  };
  EXPECT_GT(ratio_of(config.active[0].mu), 1);
  EXPECT_LT(ratio_of(config.inactive[0].mu), 1);
}

}  // namespace
}  // namespace odas::observation_model_test
