// SPDX-License-Identifier: MIT
#include "odas/array/directivity.hpp"

#include <gtest/gtest.h>

namespace odas::directivity_test {
namespace {

Vec3 tilted(float theta_deg) { return {std::sin(radians(theta_deg)), 0, std::cos(radians(theta_deg))}; }

TEST(GainLaw, Passes_all_inside_nothing_outside_and_half_in_the_middle) {
  const GainLaw law({0, 0, 1}, 80, 100, 181);
  EXPECT_EQ(law(tilted(0)), 1);
  EXPECT_EQ(law(tilted(80)), 1);
  EXPECT_NEAR(law(tilted(90)), 0.5, 1e-6);
  EXPECT_EQ(law(tilted(100)), 0);
  EXPECT_EQ(law(tilted(180)), 0);
  for (float theta = 80; theta < 100; ++theta) EXPECT_GE(law(tilted(theta)), law(tilted(theta + 1)));
}

TEST(GainLaw, Of_180_degrees_hears_everything) {
  const GainLaw law({0, 0, 1}, 180, 180, 181);
  EXPECT_EQ(law(tilted(180)), 1);
}

TEST(GainLaw, Does_not_mind_the_length_of_axis_and_direction) {
  const GainLaw law({0, 0, 7}, 80, 100, 181);
  EXPECT_NEAR(law(100 * tilted(90)), 0.5, 1e-6);
  EXPECT_EQ(law({0, 0, 0}), 1) << "no angle to speak of";
}

MicConfig mic(float x, float y, float z, std::array<float, 3> direction = {0, 0, 1},
              std::array<float, 2> angle = {180, 180}) {
  return {{x, y, z}, {}, direction, angle};
}

TEST(Directivity, Multiplies_all_spatial_filters) {
  GeneralConfig config;
  config.mics = {mic(0, 0, 0), mic(0.1F, 0, 0)};
  config.spatialfilters = {{{0, 0, 1}, {80, 100}}, {{1, 0, 0}, {80, 100}}};
  const Directivity directivity(config);
  EXPECT_NEAR(directivity.filters({0, 1, 0}), 0.25, 1e-6);
  EXPECT_EQ(directivity.filters({0, 0, -1}), 0);
}

TEST(Directivity, Takes_the_half_sphere_only_where_no_filter_list_is_given) {
  GeneralConfig config;
  config.mics = {mic(0, 0, 0), mic(0.1F, 0, 0), mic(0, 0.1F, 0)};
  EXPECT_TRUE(Directivity(config).half_sphere());
  EXPECT_EQ(Directivity(config).filters({0, 0, -1}), 0);
  EXPECT_EQ(Directivity(config).filters({1, 0, 0}), 1) << "the plane itself is heard";
  config.spatialfilters.emplace();
  EXPECT_FALSE(Directivity(config).half_sphere()) << "an empty list is the full sphere, as in ODAS";
  EXPECT_EQ(Directivity(config).filters({0, 0, -1}), 1);
}

}  // namespace
}  // namespace odas::directivity_test
