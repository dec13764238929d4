// SPDX-License-Identifier: MIT
#include "odas/localization/srp_clean.hpp"

#include <limits>

#include "support/plane_wave.hpp"
#include <gtest/gtest.h>

namespace odas::srp_clean_test {
namespace {

using test::angle_deg;

constexpr std::size_t kBins = 129;

/// What a localizer that knows nothing yet makes of the onset of these spectra.
std::vector<Potential> onset(SrpClean& localizer, const Grid<cfloat>& spectra, std::size_t potentials = 4) {
  localizer.reset();
  const Grid<float> silence(spectra.rows(), spectra.cols());
  std::vector<Potential> found(potentials);
  localizer.locate(spectra, silence, found);
  return found;
}

std::vector<Potential> onset(const GeneralConfig& general, const Grid<cfloat>& spectra) {
  SrpClean localizer(general, {});
  return onset(localizer, spectra);
}

class SrpCleanArrays : public ::testing::TestWithParam<GeneralConfig> {};

TEST_P(SrpCleanArrays, Finds_a_plane_wave_within_a_degree_and_is_sure_of_it) {
  const GeneralConfig& general = GetParam();
  SrpClean localizer(general, {});
  unsigned seed = 1;
  for (float az = -180; az < 180; az += 33) {
    for (const float el : {-60.F, -20.F, 5.F, 40.F, 75.F}) {
      const Vec3 u = direction_of(az, el);
      const auto found = onset(localizer, test::plane_wave(general, u, seed++));
      EXPECT_LT(angle_deg(found[0].direction, u), 1) << az << " " << el;
      EXPECT_GT(found[0].evidence, 4) << "as sure as a single hop may be";
      EXPECT_LT(std::sqrt(found[0].covariance.east), radians(3.F));
      EXPECT_LT(found[1].energy, 0.15F * found[0].energy) << "its pattern was taken out";
      EXPECT_LT(found[1].evidence, found[0].evidence - 3);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Arrays, SrpCleanArrays,
                         ::testing::Values(test::tetrahedron(0.12F), test::tetrahedron(0.2F)));

TEST(SrpClean, Hears_two_plane_waves_one_after_the_other) {
  const GeneralConfig general = test::tetrahedron(0.2F);
  const Vec3 a = direction_of(30, 10);
  const Vec3 b = direction_of(-100, 20);
  // Each has half of the bins.
  Grid<cfloat> both = test::plane_wave(general, a, 5);
  const Grid<cfloat> other = test::plane_wave(general, b, 6);
  for (std::size_t m = 0; m < both.rows(); ++m) {
    for (std::size_t k = 0; k < both.cols(); k += 2) both[m][k] = other[m][k];
  }
  const auto found = onset(general, both);
  const auto nearest = [&](Vec3 u) {
    return std::min(angle_deg(found[0].direction, u), angle_deg(found[1].direction, u));
  };
  EXPECT_LT(nearest(a), 4);
  EXPECT_LT(nearest(b), 4);
  EXPECT_GT(found[1].evidence, 0);
}

TEST(SrpClean, Searches_no_further_where_nothing_is_left_to_be_found) {
  const GeneralConfig general = test::tetrahedron(0.2F);
  SrpClean localizer(general, {});
  const auto found = onset(localizer, test::plane_wave(general, direction_of(30, 10)), 16);
  std::size_t searched = 0;
  while (searched < found.size() && found[searched].energy > 0) ++searched;
  EXPECT_GE(searched, 1U);
  EXPECT_LT(searched, 16U);
  for (std::size_t p = searched; p < found.size(); ++p) {
    EXPECT_EQ(found[p].energy, 0);
    EXPECT_LT(found[p].evidence, -5);
    EXPECT_GT(found[p].covariance.east, 0) << "its evidence is told";
    EXPECT_NEAR(norm(found[p].direction), 1, 1e-5);
  }
}

/// Averages over ten hops, and hears them one after the other without noise.
class SrpCleanInTime : public ::testing::Test {
 protected:
  static SslConfig ten_hops() {
    SslConfig ssl;
    ssl.averaging = 80;  // ms
    return ssl;
  }
  const Potential& hop(const Grid<cfloat>& spectra) {
    localizer_.locate(spectra, silence_, found_);
    return found_[0];
  }

  GeneralConfig general_ = test::tetrahedron(0.15F);
  SrpClean localizer_{general_, ten_hops()};
  Grid<float> silence_{4, kBins};
  std::vector<Potential> found_ = std::vector<Potential>(1);
};

TEST_F(SrpCleanInTime, Averages_over_its_time_constant) {
  const Potential first = hop(test::plane_wave(general_, direction_of(60, 20)));
  for (int h = 0; h < 10; ++h) hop(Grid<cfloat>(4, kBins));
  EXPECT_NEAR(found_[0].energy, first.energy * std::exp(-1.F), 0.01F * first.energy);
  EXPECT_LT(angle_deg(found_[0].direction, first.direction), 0.1F) << "it rings out where it was";
}

TEST_F(SrpCleanInTime, Forgets_in_one_clear_hop_what_was_before) {
  for (const float azimuth : {60.F, -100.F}) {
    const Vec3 u = direction_of(azimuth, 20);
    Grid<cfloat> spectra = test::plane_wave(general_, u);
    for (std::size_t m = 0; m < spectra.rows(); ++m) {
      for (cfloat& x : spectra[m]) x *= azimuth < 0 ? 100.F : 1.F;  // far above the echoes of the one before
    }
    const Potential found = hop(spectra);
    EXPECT_LT(angle_deg(found.direction, u), 1);
    EXPECT_GT(found.energy, 0.45F) << "of 0.5, where all bins are clear";
  }
}

TEST(SrpClean, Does_not_depend_on_the_level) {
  const GeneralConfig general = test::tetrahedron(0.12F);
  Grid<cfloat> spectra = test::plane_wave(general, direction_of(10, 10));
  const auto loud = onset(general, spectra);
  for (std::size_t m = 0; m < spectra.rows(); ++m) {
    for (cfloat& x : spectra[m]) x *= 1.F / 1024;
  }
  const auto quiet = onset(general, spectra);
  for (std::size_t p = 0; p < 2; ++p) {
    EXPECT_LT(angle_deg(loud[p].direction, quiet[p].direction), 0.01F);
    EXPECT_NEAR(loud[p].evidence, quiet[p].evidence, 1e-3F);
  }
}

TEST(SrpClean, Turns_with_the_array) {
  GeneralConfig general = test::tetrahedron(0.15F);
  const Vec3 u = direction_of(25, 15);
  const auto a = onset(general, test::plane_wave(general, u));
  for (MicConfig& m : general.mics) m.mu = {-m.mu[1], m.mu[0], m.mu[2]};  // by 90 degrees
  const auto b = onset(general, test::plane_wave(general, {-u.y, u.x, u.z}));
  const Vec3 turned{-a[0].direction.y, a[0].direction.x, a[0].direction.z};
  EXPECT_LT(angle_deg(turned, b[0].direction), 0.2F);
  EXPECT_NEAR(a[0].energy, b[0].energy, 0.01F * a[0].energy);
}

TEST(SrpClean, Does_not_mind_the_order_of_the_microphones) {
  GeneralConfig general = test::tetrahedron(0.15F);
  const Vec3 u = direction_of(-70, 30);
  const auto a = onset(general, test::plane_wave(general, u));
  std::swap(general.mics[0], general.mics[3]);
  const auto b = onset(general, test::plane_wave(general, u));
  EXPECT_LT(angle_deg(a[0].direction, b[0].direction), 0.2F);
}

TEST(SrpClean, Of_a_flat_array_is_less_sure_of_the_elevation_than_of_the_azimuth) {
  GeneralConfig general = test::ring(4, 0.032F);
  general.spatialfilters.reset();
  const auto found = onset(general, test::plane_wave(general, direction_of(110, 15)));
  EXPECT_NEAR(azimuth_deg(found[0].direction), 110, 1.5);
  EXPECT_GT(found[0].covariance.north, 4 * found[0].covariance.east);
}

TEST(SrpClean, Of_silence_and_of_steady_noise_has_no_evidence) {
  const GeneralConfig general = test::ring(4, 0.032F);
  for (const Potential& p : onset(general, Grid<cfloat>(4, kBins))) {
    EXPECT_EQ(p.energy, 0);
    EXPECT_LT(p.evidence, -5);
    EXPECT_NEAR(norm(p.direction), 1, 1e-5);
  }
  SrpClean localizer(general, {});
  Grid<float> psd(4, kBins);
  psd.fill(2);
  std::vector<Potential> found(4);
  int sure = 0;
  for (unsigned hop = 0; hop < 400; ++hop) {
    localizer.locate(test::noise_spectra(general, hop), psd, found);
    sure += found[0].evidence > 0;
  }
  EXPECT_LE(sure, 4);
}

TEST(SrpClean, Is_less_sure_of_a_crowd_than_of_one_talker_who_is_no_louder_than_its_loudest_voice) {
  const GeneralConfig general = test::tetrahedron(0.2F);
  constexpr std::size_t kVoices = 12;
  Grid<cfloat> crowd(4, kBins);
  Grid<cfloat> talker(4, kBins);
  for (std::size_t voice = 0; voice < kVoices; ++voice) {
    const auto turn = static_cast<float>(voice);
    const Vec3 from = direction_of(30 * turn, 40 * std::sin(turn));
    const Grid<cfloat> wave = test::plane_wave(general, from, 40 + static_cast<unsigned>(voice));
    for (std::size_t m = 0; m < 4; ++m) {
      for (std::size_t k = voice; k < kBins; k += kVoices) {
        crowd[m][k] = wave[m][k];
        if (voice == 0) talker[m][k] = wave[m][k];
      }
    }
  }
  const auto of_crowd = onset(general, crowd);
  const auto of_talker = onset(general, talker);
  EXPECT_GT(of_crowd[0].energy, of_talker[0].energy) << "with what the others happen to add";
  EXPECT_LT(of_crowd[0].evidence, of_talker[0].evidence - 1);
}

TEST(SrpClean, Hears_a_talker_through_a_fan) {
  const GeneralConfig general = test::tetrahedron(0.15F);
  SrpClean localizer(general, {});
  const Vec3 fan = direction_of(-60, 0);
  const Vec3 talker = direction_of(90, 10);
  Grid<float> psd(4, kBins);
  psd.fill(2);
  std::vector<Potential> found(2);
  int right = 0;
  for (unsigned hop = 0; hop < 60; ++hop) {
    Grid<cfloat> spectra = test::plane_wave(general, fan, 100 + hop);
    const Grid<cfloat> voice = test::plane_wave(general, talker, 200 + hop);
    const bool syllable = hop % 20 < 8;  // in a quarter of the bins, 14 dB over the fan
    for (std::size_t m = 0; m < 4; ++m) {
      for (std::size_t k = 0; syllable && k < kBins; k += 4) spectra[m][k] += 5.F * voice[m][k];
    }
    localizer.locate(spectra, psd, found);
    right += angle_deg(found[0].direction, talker) < 10;
    EXPECT_FALSE(found[0].evidence > 1 && angle_deg(found[0].direction, fan) < 10);
  }
  EXPECT_GT(right, 50);
}

TEST(SrpClean, Is_not_moved_by_a_hop_that_is_not_finite) {
  const GeneralConfig general = test::tetrahedron(0.15F);
  SrpClean localizer(general, {});
  const Grid<float> silence(4, kBins);
  std::vector<Potential> found(4);
  Grid<cfloat> broken(4, kBins);
  broken[1][7] = {std::numeric_limits<float>::quiet_NaN(), 1};
  broken[2][9] = {std::numeric_limits<float>::infinity(), 1};
  localizer.locate(broken, silence, found);
  for (const Potential& p : found) EXPECT_TRUE(std::isfinite(p.energy));
  const auto spectra = test::plane_wave(general, direction_of(60, 20));
  localizer.locate(spectra, silence, found);
  EXPECT_EQ(found[0].energy, onset(general, spectra)[0].energy);
}

}  // namespace
}  // namespace odas::srp_clean_test
