// SPDX-License-Identifier: MIT
#include "odas/array/doa_error.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "odas/array/sphere_grid.hpp"

namespace odas::doa_error_test {
namespace {

constexpr double kError = 4e-6;  // s

GeneralConfig array_of(const std::vector<Vec3>& positions, bool full_sphere = true) {
  GeneralConfig general;
  for (const Vec3& p : positions) {
    MicConfig mic;
    mic.mu = {p.x, p.y, p.z};
    general.mics.push_back(mic);
  }
  if (full_sphere) general.spatialfilters.emplace();
  return general;
}

std::vector<Vec3> ring(int mics, float radius) {
  std::vector<Vec3> all;
  for (int m = 0; m < mics; ++m) {
    all.push_back(radius * direction_of(360.F * static_cast<float>(m) / static_cast<float>(mics), 0));
  }
  return all;
}

TEST(DoaError, of_two_microphones_is_that_of_the_arccosine) {
  // tau = d cos(theta) / c: sigma_theta = c sigma / (d sin theta).
  const DoaError error(array_of({{0.05F, 0, 0}, {-0.05F, 0, 0}}), kError);
  const double broadside = degrees(343.F) * kError / 0.1;
  EXPECT_NEAR(error.at(direction_of(90, 0))->azimuth_deg, broadside, 1e-3 * broadside);
  EXPECT_NEAR(error.at(direction_of(30, 0))->azimuth_deg, 2 * broadside, 2e-3 * broadside);
  EXPECT_NEAR(error.at(direction_of(0, 0))->angle_deg(), 90, 1) << "along the line nothing is known";
}

TEST(DoaError, of_a_ring_is_the_same_all_around_and_halves_with_twice_the_size) {
  const DoaError small(array_of(ring(8, 0.05F)), kError), large(array_of(ring(8, 0.1F)), kError);
  const double first = small.at(direction_of(0, 40))->angle_deg();
  for (float azimuth = 0; azimuth < 360; azimuth += 10) {
    EXPECT_NEAR(small.at(direction_of(azimuth, 40))->angle_deg(), first, 1e-3 * first);
  }
  EXPECT_NEAR(large.at(direction_of(0, 40))->angle_deg(), first / 2, 1e-2 * first);
}

TEST(DoaError, of_a_flat_array_grows_in_elevation_towards_its_plane) {
  const DoaError error(array_of(ring(6, 0.05F)), kError);
  EXPECT_GT(error.at(direction_of(0, 10))->elevation_deg, 4 * error.at(direction_of(0, 60))->elevation_deg);
  EXPECT_NEAR(error.at(direction_of(0, 10))->azimuth_deg, error.at(direction_of(0, 60))->azimuth_deg, 1e-3);
}

TEST(DoaError, is_what_least_squares_makes_of_noisy_differences) {
  // Independent errors on each pair; the estimate that reaches the bound: least squares about the truth.
  const std::vector<Vec3> mics{
      {0.04F, 0, 0.02F}, {-0.03F, 0.02F, 0}, {0, -0.05F, 0.01F}, {0.01F, 0.03F, 0.05F}};
  const GeneralConfig general = array_of(mics);
  const Vec3 u = direction_of(70, 25), east = direction_of(160, 0), north = cross(u, east);
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 343 * kError);
  double squares = 0;
  constexpr int kTrials = 20000;
  for (int trial = 0; trial < kTrials; ++trial) {
    double aa = 0, ee = 0, ae = 0, a1 = 0, e1 = 0;
    for (const Pair& pair : all_pairs(mics.size())) {
      const Vec3 d = mics[pair.i] - mics[pair.j];
      const auto a = static_cast<double>(dot(d, east)), e = static_cast<double>(dot(d, north));
      const double y = noise(random);
      aa += a * a;
      ee += e * e;
      ae += a * e;
      a1 += a * y;
      e1 += e * y;
    }
    const double determinant = aa * ee - ae * ae;
    const double off_azimuth = (ee * a1 - ae * e1) / determinant;
    squares += off_azimuth * off_azimuth;
  }
  const double measured = std::sqrt(squares / kTrials) * 57.29578;
  EXPECT_NEAR(DoaError(general, kError).at(u)->azimuth_deg, measured, 0.03 * measured);
}

TEST(DoaError, leaves_out_pairs_that_do_not_hear_and_says_nothing_where_none_does) {
  GeneralConfig general = array_of(ring(4, 0.05F));
  for (std::size_t m = 0; m < 4; ++m) {
    const Vec3 out = normalized(position(general.mics[m]));
    general.mics[m].direction = {out.x, out.y, out.z};
    general.mics[m].angle = {80, 90};
  }
  const DoaError error(general, kError);
  EXPECT_EQ(error.at(direction_of(45, 0))->pairs, 1U);
  EXPECT_EQ(error.at({0, 0, 1}), std::nullopt);
}

TEST(DoaError, finds_the_mirror_image_of_a_flat_array_and_none_where_one_side_is_listened_to) {
  const SphereGrid grid(2);
  const auto mirrored = DoaError(array_of(ring(6, 0.05F)), kError).ambiguities(grid.points(), 60, 100);
  ASSERT_FALSE(mirrored.empty());
  for (const auto& pair : mirrored) {
    EXPECT_NEAR(pair.a.x, pair.b.x, 0.05);
    EXPECT_NEAR(pair.a.y, pair.b.y, 0.05);
    EXPECT_LT(pair.a.z * pair.b.z, 0);
  }
  EXPECT_GE(mirrored.front().apart_deg(), mirrored.back().apart_deg());
  const DoaError half(array_of(ring(6, 0.05F), false), kError);
  EXPECT_TRUE(half.ambiguities(grid.points(), 60, 100).empty());
}

TEST(ArrayShape, is_told_from_the_positions) {
  EXPECT_EQ(shape_of(array_of({{0, 0, 0}, {0, 0, 0}}).mics), ArrayShape::point);
  EXPECT_EQ(shape_of(array_of({{0, 0, 0}, {0, 0.1F, 0}, {0, 0.3F, 0}}).mics), ArrayShape::line);
  EXPECT_EQ(shape_of(array_of(ring(5, 0.05F)).mics), ArrayShape::plane);
  EXPECT_EQ(shape_of(array_of({{0, 0, 0}, {0.1F, 0, 0}, {0, 0.1F, 0}, {0, 0, 0.1F}}).mics),
            ArrayShape::volume);
}

}  // namespace
}  // namespace odas::doa_error_test
