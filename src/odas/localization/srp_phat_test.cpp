// SPDX-License-Identifier: MIT
#include "odas/localization/srp_phat.hpp"

#include <limits>

#include "support/allocation_counter.hpp"
#include "support/plane_wave.hpp"
#include <gtest/gtest.h>

namespace odas::srp_phat_test {
namespace {

using test::angle_deg;

constexpr float kHalfStep = 2.7F;  // degrees: the farthest that a direction lies from the grid of level 4

std::vector<Potential> located(SrpPhat& localizer, const Grid<cfloat>& spectra, std::size_t potentials = 4) {
  std::vector<Potential> found(potentials);
  localizer.locate(spectra, {}, found);
  return found;
}

class SrpPhatArrays : public ::testing::TestWithParam<GeneralConfig> {};

TEST_P(SrpPhatArrays, Finds_a_plane_wave_within_half_a_grid_step_and_gives_it_E_of_one) {
  const GeneralConfig& general = GetParam();
  SrpPhat localizer(general, {});
  unsigned seed = 1;
  for (float az = -180; az < 180; az += 33) {
    for (const float el : {-60.F, -20.F, 5.F, 40.F, 75.F}) {
      const Vec3 u = direction_of(az, el);
      const auto found = located(localizer, test::plane_wave(general, u, seed++));
      EXPECT_LT(angle_deg(found[0].direction, u), 2 * kHalfStep) << az << " " << el;
      EXPECT_GT(found[0].energy, 0.9F);
      EXPECT_LT(found[0].energy, 1.02F);
      EXPECT_LT(found[1].energy, found[0].energy);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Arrays, SrpPhatArrays,
                         ::testing::Values(test::tetrahedron(0.12F), test::tetrahedron(0.2F)));

TEST(SrpPhat, Hears_two_plane_waves) {
  const GeneralConfig general = test::tetrahedron(0.2F);
  SrpPhat localizer(general, {});
  const Vec3 a = direction_of(30, 10);
  const Vec3 b = direction_of(-100, 20);
  // Each has half of the bins.
  Grid<cfloat> both = test::plane_wave(general, a, 5);
  const Grid<cfloat> other = test::plane_wave(general, b, 6);
  for (std::size_t m = 0; m < both.rows(); ++m) {
    for (std::size_t k = 0; k < both.cols(); k += 2) both[m][k] = other[m][k];
  }
  const auto found = located(localizer, both);
  const auto near = [&](Vec3 u) {
    return std::min(angle_deg(found[0].direction, u), angle_deg(found[1].direction, u));
  };
  EXPECT_LT(near(a), 6);
  EXPECT_LT(near(b), 6);
  EXPECT_NEAR(found[0].energy, 0.5F, 0.15F);
}

TEST(SrpPhat, Keeps_the_energy_of_all_directions_where_it_is_asked_to) {
  const GeneralConfig general = test::tetrahedron(0.12F);
  SrpPhat localizer(general, {});
  const Vec3 u = direction_of(70, 20);
  const auto without = located(localizer, test::plane_wave(general, u));
  EXPECT_TRUE(localizer.power_map().empty());

  localizer.reset();
  localizer.keep_power_map();
  const auto with = located(localizer, test::plane_wave(general, u));
  const auto map = localizer.power_map();
  ASSERT_EQ(map.size(), localizer.power_grid().size());
  const auto peak = static_cast<std::size_t>(std::max_element(map.begin(), map.end()) - map.begin());
  EXPECT_LT(angle_deg(localizer.power_grid()[peak], u), 15) << "the coarse grid's nearest direction";
  EXPECT_GT(map[peak], 0.9F) << "not that of a later search, whose peak was cut out";
  for (std::size_t p = 0; p < with.size(); ++p) {
    EXPECT_EQ(with[p].direction, without[p].direction);
    EXPECT_EQ(with[p].energy, without[p].energy);
  }
}

TEST(SrpPhat, Does_not_depend_on_the_level) {
  const GeneralConfig general = test::tetrahedron(0.12F);
  SrpPhat localizer(general, {});
  Grid<cfloat> spectra = test::plane_wave(general, direction_of(10, 10));
  const auto loud = located(localizer, spectra);
  for (std::size_t m = 0; m < spectra.rows(); ++m) {
    for (cfloat& x : spectra[m]) x *= 1.F / 1024;
  }
  const auto quiet = located(localizer, spectra);
  for (std::size_t p = 0; p < loud.size(); ++p) {
    EXPECT_EQ(loud[p].direction, quiet[p].direction);
    EXPECT_EQ(loud[p].energy, quiet[p].energy);
  }
}

TEST(SrpPhat, Turns_with_the_array) {
  GeneralConfig general = test::tetrahedron(0.15F);
  const Vec3 u = direction_of(25, 15);
  SrpPhat before(general, {});
  const auto a = located(before, test::plane_wave(general, u), 1);
  for (MicConfig& m : general.mics) m.mu = {-m.mu[1], m.mu[0], m.mu[2]};  // by 90 degrees
  SrpPhat after(general, {});
  const auto b = located(after, test::plane_wave(general, {-u.y, u.x, u.z}), 1);
  const Vec3 turned{-a[0].direction.y, a[0].direction.x, a[0].direction.z};
  EXPECT_LT(angle_deg(turned, b[0].direction), 2 * kHalfStep) << "the grid does not turn with it";
  EXPECT_NEAR(a[0].energy, b[0].energy, 0.05F);
}

TEST(SrpPhat, Does_not_mind_the_order_of_the_microphones) {
  GeneralConfig general = test::tetrahedron(0.15F);
  const Vec3 u = direction_of(-70, 30);
  SrpPhat before(general, {});
  const auto a = located(before, test::plane_wave(general, u), 1);
  std::swap(general.mics[0], general.mics[3]);
  SrpPhat after(general, {});
  const auto b = located(after, test::plane_wave(general, u), 1);
  EXPECT_LT(angle_deg(a[0].direction, b[0].direction), 2 * kHalfStep);
}

// ODAS fault B8: with fewer potentials than scans it wrote beyond its buffers.
TEST(SrpPhat, Finds_one_potential_with_two_and_with_three_scans) {
  const GeneralConfig general = test::tetrahedron(0.15F);
  SslConfig ssl;
  ssl.n_pots = 1;
  for (const auto& scans :
       {std::vector<ScanConfig>{{2, -1}, {4, -1}}, std::vector<ScanConfig>{{1, -1}, {3, 1}, {4, -1}},
        std::vector<ScanConfig>{{4, -1}}}) {
    ssl.scans = scans;
    SrpPhat localizer(general, ssl);
    const Vec3 u = direction_of(50, -10);
    EXPECT_LT(angle_deg(located(localizer, test::plane_wave(general, u), 1)[0].direction, u), 2 * kHalfStep);
  }
}

// ODAS fault B14: when no candidate was positive it took the number of a coarse direction for a fine one.
TEST(SrpPhat, Of_correlations_that_are_all_negative_takes_the_best_candidate) {
  GeneralConfig general;
  general.mics = {test::mic_at({0.02F, 0, 0}), test::mic_at({-0.02F, 0, 0})};
  general.spatialfilters.emplace();
  SrpPhat localizer(general, {});
  Grid<cfloat> spectra(2, 129);
  for (std::size_t k = 0; k < 129;
       ++k) {  // turned over, and without the high bins: negative at all lags here
    spectra[0][k] = k < 20 ? 1.F : 0.F;
    spectra[1][k] = -spectra[0][k];
  }
  const auto found = located(localizer, spectra, 1);
  EXPECT_LT(found[0].energy, 0);
  EXPECT_GT(found[0].energy, -1);
  EXPECT_GT(std::abs(found[0].direction.x), 0.8F) << "least negative at the longest lag, along the axis";
}

// ODAS fault B14: lags beyond half a frame were read out of bounds.
TEST(SrpPhat, Survives_an_array_wider_than_half_a_frame_of_sound) {
  const GeneralConfig general = test::ring(3, 3.0F);
  SslConfig ssl;
  ssl.scans = {{1, -1}, {2, 2}};
  SrpPhat localizer(general, ssl);
  for (const Potential& p : located(localizer, test::noise_spectra(general, 1))) {
    EXPECT_TRUE(std::isfinite(p.energy));
    EXPECT_NEAR(norm(p.direction), 1, 1e-5);
  }
}

TEST(SrpPhat, Of_silence_gives_no_energy) {
  const GeneralConfig general = test::ring(4, 0.03F);
  SrpPhat localizer(general, {});
  for (const Potential& p : located(localizer, Grid<cfloat>(4, 129))) {
    EXPECT_EQ(p.energy, 0);
    EXPECT_NEAR(norm(p.direction), 1, 1e-5);
  }
}

TEST(SrpPhat, Is_not_moved_by_a_hop_that_is_not_finite) {
  const GeneralConfig general = test::tetrahedron(0.15F);
  SrpPhat localizer(general, {});
  Grid<cfloat> broken = test::plane_wave(general, direction_of(0, 0));
  broken[1][7] = {std::numeric_limits<float>::quiet_NaN(), 1};
  broken[2][9] = {std::numeric_limits<float>::infinity(), 1};
  for (const Potential& p : located(localizer, broken)) EXPECT_TRUE(std::isfinite(p.energy));
  const auto spectra = test::plane_wave(general, direction_of(60, 20));
  SrpPhat fresh(general, {});
  EXPECT_EQ(located(localizer, spectra)[0].energy, located(fresh, spectra)[0].energy);
}

TEST(SrpPhat, Weighted_hears_a_talker_through_a_fan) {
  GeneralConfig general = test::tetrahedron(0.15F);
  SslConfig ssl;
  ssl.weighting = "snr";
  SrpPhat plain(general, {});
  SrpPhat weighted(general, ssl);
  const Vec3 fan = direction_of(-60, 0);
  const Vec3 talker = direction_of(90, 10);
  Grid<float> noise_psd(4, 129);
  std::vector<Potential> with(1);
  std::vector<Potential> without(1);
  for (unsigned hop = 0; hop < 30; ++hop) {
    Grid<cfloat> spectra = test::plane_wave(general, fan, 100 + hop);
    const Grid<cfloat> voice = test::plane_wave(general, talker, 200 + hop);
    for (std::size_t m = 0; m < 4; ++m) {
      for (std::size_t k = 0; k < 129; ++k) {
        const bool voiced = k % 4 == 0;  // a voice has a quarter of the bins, well above the fan
        spectra[m][k] = spectra[m][k] + (voiced ? 10.F : 0.F) * voice[m][k];
        noise_psd[m][k] = 2;
      }
    }
    weighted.locate(spectra, noise_psd, with);
    plain.locate(spectra, {}, without);
  }
  EXPECT_LT(angle_deg(with[0].direction, talker), 6);
  EXPECT_LT(angle_deg(without[0].direction, fan), 6) << "without weights the fan, in most bins, wins";
}

TEST(SrpPhat, Allocates_nothing_once_made_and_is_as_new_after_reset) {
  const GeneralConfig general = test::ring(8, 0.1F);
  SrpPhat localizer(general, {});
  SrpPhat fresh(general, {});
  const auto spectra = test::noise_spectra(general, 3);
  std::vector<Potential> a(4);
  std::vector<Potential> b(4);
  const auto before = test::allocations();
  for (int i = 0; i < 3; ++i) localizer.locate(spectra, {}, a);
  EXPECT_EQ(test::allocations(), before);
  localizer.reset();
  localizer.locate(spectra, {}, a);
  fresh.locate(spectra, {}, b);
  for (std::size_t p = 0; p < 4; ++p) {
    EXPECT_EQ(a[p].direction, b[p].direction);
    EXPECT_EQ(a[p].energy, b[p].energy);
  }
}

}  // namespace
}  // namespace odas::srp_phat_test
