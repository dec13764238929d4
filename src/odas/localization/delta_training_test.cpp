// SPDX-License-Identifier: MIT
#include "odas/localization/delta_training.hpp"

#include "support/plane_wave.hpp"
#include <gtest/gtest.h>

#include "odas/array/directivity.hpp"

namespace odas::delta_training_test {
namespace {

/// An array of microphones that face up with angles 80-100, behind a spatial filter of the same.
GeneralConfig facing_up(const std::vector<Vec3>& positions) {
  GeneralConfig config;
  for (const Vec3 p : positions) config.mics.push_back(test::mic_at(p, {0, 0, 1}, {80, 100}));
  config.spatialfilters = {SpatialFilterConfig{{0, 0, 1}, {80, 100}}};
  return config;
}

std::vector<int> trained(const GeneralConfig& general, const SslConfig& ssl, int level) {
  const auto pairs = all_pairs(general.mics.size());
  const ScanLevel scan(general, Directivity(general), pairs, level, ssl.interp_rate);
  return train_deltas(general, ssl, scan, pairs);
}

TEST(DeltaTraining, Finds_the_deltas_of_ODAS_for_a_square_of_64_mm) {
  const auto general = facing_up({{-.032F, 0, 0}, {0, -.032F, 0}, {.032F, 0, 0}, {0, .032F, 0}});
  EXPECT_EQ(trained(general, {}, 2), (std::vector<int>{1, 2, 2, 2, 2, 2}));
  EXPECT_EQ(trained(general, {}, 4), (std::vector<int>{1, 1, 0, 0, 1, 1}));
}

TEST(DeltaTraining, Covers_more_when_more_is_asked_for) {
  const auto general = test::ring(4, 0.05F);
  SslConfig ssl;
  const auto sum = [&](float prob_min) {
    ssl.prob_min = prob_min;
    int total = 0;
    for (const int d : trained(general, ssl, 2)) total += d;
    return total;
  };
  EXPECT_LT(sum(0.3F), sum(0.6F));
  EXPECT_LT(sum(0.6F), sum(0.9F));
}

TEST(DeltaTraining, Ends_where_the_probability_cannot_be_reached) {
  auto general = test::ring(3, 0.1F);
  for (MicConfig& m : general.mics) m.sigma2 = {1, 0, 0, 0, 1, 0, 0, 0, 1};  // a metre of uncertainty
  SslConfig ssl;
  ssl.prob_min = 0.999F;
  for (const int d : trained(general, ssl, 0)) EXPECT_GT(d, 0);
}

TEST(DeltaTraining, Of_two_microphones_in_one_place_needs_no_width) {
  GeneralConfig general;
  general.mics = {test::mic_at({0, 0, 0}), test::mic_at({0, 0, 0})};
  general.spatialfilters.emplace();
  EXPECT_EQ(trained(general, {}, 1), std::vector<int>{0});
}

}  // namespace
}  // namespace odas::delta_training_test
