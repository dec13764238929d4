// SPDX-License-Identifier: MIT
#include "odas/array/geometry.hpp"

#include <gtest/gtest.h>

namespace odas::geometry_test {
namespace {

MicConfig mic(Vec3 p, std::array<float, 3> direction = {0, 0, 1}) {
  return {{p.x, p.y, p.z}, {}, direction, {180, 180}};
}

TEST(Geometry, All_pairs_come_in_the_order_of_ODAS) {
  const auto pairs = all_pairs(4);
  ASSERT_EQ(pairs.size(), 6U);
  EXPECT_EQ(pairs[0].i, 0U);
  EXPECT_EQ(pairs[0].j, 1U);
  EXPECT_EQ(pairs[3].i, 1U);
  EXPECT_EQ(pairs[3].j, 2U);
  EXPECT_EQ(pairs[5].i, 2U);
  EXPECT_EQ(pairs[5].j, 3U);
}

TEST(Geometry, Aperture_is_the_widest_pair) {
  const std::vector<MicConfig> mics{mic({0, 0, 0}), mic({0.1F, 0, 0}), mic({0, 0.2F, 0})};
  EXPECT_NEAR(aperture(mics), std::hypot(0.1F, 0.2F), 1e-6);
}

TEST(FlatArray, Listens_to_the_side_that_its_microphones_face) {
  std::vector<MicConfig> mics{mic({0, 0, 0}), mic({0.1F, 0, 0}), mic({0, 0.1F, 0})};
  ASSERT_TRUE(flat_array_side(mics).has_value());
  EXPECT_LT(norm(*flat_array_side(mics) - Vec3{0, 0, 1}), 1e-5F);
  for (MicConfig& m : mics) m.direction = {0, 0, -1};
  EXPECT_LT(norm(*flat_array_side(mics) - Vec3{0, 0, -1}), 1e-5F);
}

TEST(FlatArray, Listens_upwards_where_its_microphones_face_everywhere) {
  const std::vector<MicConfig> mics{mic({0.1F, 0, 0}, {1, 0, 0}), mic({-0.1F, 0, 0}, {-1, 0, 0}),
                                    mic({0, 0.1F, 0}, {0, 1, 0}), mic({0, -0.1F, 0}, {0, -1, 0})};
  EXPECT_LT(norm(*flat_array_side(mics) - Vec3{0, 0, 1}), 1e-5F);
}

TEST(FlatArray, May_lie_in_any_plane) {
  // In the plane x = 1, microphones facing -x.
  const std::array<float, 3> back{-1, 0, 0};
  const std::vector<MicConfig> mics{mic({1, 0, 0}, back), mic({1, 0.1F, 0}, back), mic({1, 0, 0.1F}, back)};
  EXPECT_LT(norm(*flat_array_side(mics) - Vec3{-1, 0, 0}), 1e-5F);
}

TEST(FlatArray, On_a_line_takes_the_half_sphere_before_it) {
  const std::array<float, 3> ahead{1, 0, 0};
  const std::vector<MicConfig> mics{mic({0, -0.03F, 0}, ahead), mic({0, 0, 0}, ahead),
                                    mic({0, 0.03F, 0}, ahead)};
  EXPECT_LT(norm(*flat_array_side(mics) - Vec3{1, 0, 0}), 1e-5F);
  const std::vector<MicConfig> upright{mic({0, 0, 0}), mic({0, 0, 0.1F})};  // and facing along itself
  ASSERT_TRUE(flat_array_side(upright).has_value());
  EXPECT_NEAR(dot(*flat_array_side(upright), {0, 0, 1}), 0, 1e-5);
}

TEST(FlatArray, With_depth_is_none) {
  const std::vector<MicConfig> deep{mic({0, 0, 0}), mic({0.1F, 0, 0}), mic({0, 0.1F, 0}), mic({0, 0, 0.1F})};
  EXPECT_FALSE(flat_array_side(deep).has_value());
  const std::vector<MicConfig> uneven{mic({0, 0, 0}), mic({0.1F, 0, 0}), mic({0, 0.1F, 0}),
                                      mic({0.1F, 0.1F, 0.0005F})};
  EXPECT_TRUE(flat_array_side(uneven).has_value()) << "half a millimetre is no depth";
  EXPECT_FALSE(flat_array_side(std::vector<MicConfig>{mic({0, 0, 0}), mic({0, 0, 0})}).has_value());
}

}  // namespace
}  // namespace odas::geometry_test
