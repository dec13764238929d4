// SPDX-License-Identifier: MIT
#include "odas/localization/scan_level.hpp"

#include "support/plane_wave.hpp"
#include <gtest/gtest.h>

namespace odas::scan_level_test {
namespace {

TEST(ScanLevel, Lags_are_negative_where_the_first_microphone_is_nearer) {
  GeneralConfig general;
  general.mics = {test::mic_at({0.1F, 0, 0}), test::mic_at({-0.1F, 0, 0})};
  general.spatialfilters.emplace();
  const ScanLevel level(general, Directivity(general), all_pairs(2), 3, 4);
  for (std::size_t u = 0; u < level.grid().size(); ++u) {
    const float exact = -0.2F * level.grid().points()[u].x * 16000 * 4 / 343;
    EXPECT_NEAR(static_cast<float>(level.lags(u)[0]), exact, 0.5F);
  }
  EXPECT_EQ(level.min_lag(0), -37);
  EXPECT_EQ(level.max_lag(0), 37);
}

TEST(ScanLevel, Keeps_the_directions_that_ODAS_keeps) {
  // Microphones and filter 80-100 keep 1241 of 2562 directions; with the filter 80-90, 1161.
  auto general = test::ring(4, 0.032F);
  for (MicConfig& m : general.mics) m.angle = {80, 100};
  general.spatialfilters = {SpatialFilterConfig{{0, 0, 1}, {80, 100}}};
  EXPECT_EQ(ScanLevel(general, Directivity(general), all_pairs(4), 4, 4).active_points().size(), 1241U);
  general.spatialfilters = {SpatialFilterConfig{{0, 0, 1}, {80, 90}}};
  EXPECT_EQ(ScanLevel(general, Directivity(general), all_pairs(4), 4, 4).active_points().size(), 1161U);
  EXPECT_EQ(ScanLevel(general, Directivity(general), all_pairs(4), 2, 4).active_points().size(), 71U);
}

}  // namespace
}  // namespace odas::scan_level_test
