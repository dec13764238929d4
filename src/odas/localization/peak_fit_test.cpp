// SPDX-License-Identifier: MIT
#include "odas/localization/peak_fit.hpp"

#include <cmath>
#include <numbers>

#include "support/plane_wave.hpp"
#include <gtest/gtest.h>

namespace odas::peak_fit_test {
namespace {

/// Correlations of a wave from `u`: a smooth bump around its lag in each pair.
struct Bumps {
  Bumps(const GeneralConfig& general, Vec3 u)
      : plan(general, {}), fit(general, plan, SslConfig().interp_rate) {
    come_from(u);
  }
  void come_from(Vec3 u) {
    x = Grid<float>(plan.pairs.size(), plan.row_size);
    for (std::size_t q = 0; q < x.rows(); ++q) {
      for (std::size_t n = 0; n <= 2 * plan.half_lags; ++n) {
        const float l = static_cast<float>(n) - static_cast<float>(plan.half_lags) - fit.lag(q, u);
        x[q][n] = std::exp(-l * l / (2 * kWidth * kWidth));
      }
    }
  }
  [[nodiscard]] PeakFit::Fit from(Vec3 start) const {
    return fit.fit(x, std::vector<std::uint8_t>(x.rows(), 1), start);
  }

  static constexpr float kWidth = 6;  // columns
  SearchPlan plan;
  PeakFit fit;
  Grid<float> x;
};

TEST(PeakFit, Finds_the_direction_between_the_points_of_the_grid) {
  Bumps bumps(test::tetrahedron(0.15F), {1, 0, 0});
  for (float az = -170; az < 180; az += 47) {
    for (const float el : {-50.F, 3.F, 35.F, 88.F}) {
      const Vec3 u = direction_of(az, el);
      bumps.come_from(u);
      const auto found = bumps.from(direction_of(az + 4, std::min(el + 3, 90.F)));
      EXPECT_LT(test::angle_deg(found.direction, u), 0.1F) << az << " " << el;
      EXPECT_NEAR(found.energy, 1, 0.01);
      EXPECT_NEAR(norm(found.direction), 1, 1e-5);
    }
  }
}

// For Gaussian bumps the curvature at the top is sum of l_a l_b / width^2, as one works out by hand.
TEST(PeakFit, Tells_the_curvature_of_the_response) {
  const GeneralConfig general = test::tetrahedron(0.15F);
  const Vec3 u = direction_of(20, 30);
  const Bumps bumps(general, u);
  const auto found = bumps.from(u);
  const TangentPlane plane(u);
  float east = 0;
  float north = 0;
  for (std::size_t q = 0; q < bumps.x.rows(); ++q) {
    const float along_east = bumps.fit.lag(q, plane.east) / Bumps::kWidth;
    const float along_north = bumps.fit.lag(q, plane.north) / Bumps::kWidth;
    east += along_east * along_east / static_cast<float>(bumps.x.rows());
    north += along_north * along_north / static_cast<float>(bumps.x.rows());
  }
  EXPECT_NEAR(found.east, east, 0.05F * east);
  EXPECT_NEAR(found.north, north, 0.05F * north);
}

TEST(PeakFit, Of_a_flat_array_stays_on_the_side_that_it_listens_to) {
  GeneralConfig general = test::ring(6, 0.04F);
  general.spatialfilters.reset();
  const Bumps bumps(general, direction_of(50, 1));
  const auto found = bumps.from(direction_of(48, -3));
  EXPECT_GE(found.direction.z, -1e-6F);
  EXPECT_LT(std::abs(azimuth_deg(found.direction) - 50), 0.3F);
}

TEST(TangentPlane, Points_to_where_azimuth_and_elevation_grow) {
  const Vec3 u = direction_of(40, 25);
  const TangentPlane plane(u);
  EXPECT_GT(azimuth_deg(normalized(u + 0.01F * plane.east)), 40);
  EXPECT_NEAR(elevation_deg(normalized(u + 0.01F * plane.east)), 25, 0.05);
  EXPECT_GT(elevation_deg(normalized(u + 0.01F * plane.north)), 25);
  EXPECT_NEAR(azimuth_deg(normalized(u + 0.01F * plane.north)), 40, 0.05);
}

}  // namespace
}  // namespace odas::peak_fit_test
