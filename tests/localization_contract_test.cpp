// SPDX-License-Identifier: MIT
// What every registered localizer promises.
#include <cmath>
#include <limits>
#include <string>

#include "support/allocation_counter.hpp"
#include "support/plane_wave.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"
#include "odas/localization/registry.hpp"

namespace odas::localization_contract_test {
namespace {

constexpr std::size_t kBins = 129;

class LocalizationContract : public ::testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] static std::unique_ptr<Localizer> make(const GeneralConfig& general) {
    SslConfig ssl;
    ssl.mode = GetParam();
    return make_localizer(general, ssl);
  }
  static std::vector<Potential> hop(Localizer& localizer, const Grid<cfloat>& spectra,
                                    std::size_t potentials = 4) {
    Grid<float> psd(spectra.rows(), spectra.cols());
    psd.fill(0.1F);
    std::vector<Potential> found(potentials, Potential{{7, 7, 7}, 7});
    localizer.locate(spectra, localizer.needs_noise() ? psd.view() : GridView<float>(), found);
    return found;
  }
  static void expect_same(const std::vector<Potential>& a, const std::vector<Potential>& b) {
    for (std::size_t p = 0; p < a.size(); ++p) {
      EXPECT_EQ(a[p].direction, b[p].direction);
      EXPECT_EQ(a[p].energy, b[p].energy);
      EXPECT_EQ(a[p].evidence, b[p].evidence);
      EXPECT_EQ(a[p].covariance.north, b[p].covariance.north);
    }
  }
};

TEST_P(LocalizationContract, Fills_every_potential_with_a_unit_direction_for_any_number_of_microphones) {
  for (const std::size_t mics : {2U, 3U, 7U, 16U}) {
    const GeneralConfig general = test::ring(mics, 0.05F);
    const auto localizer = make(general);
    for (const std::size_t potentials : {1U, 4U, 9U}) {
      for (const Potential& p : hop(*localizer, test::noise_spectra(general, 3), potentials)) {
        EXPECT_NEAR(norm(p.direction), 1, 1e-4);
        EXPECT_TRUE(std::isfinite(p.energy) && p.energy < 1.1F);
        EXPECT_TRUE(std::isfinite(p.evidence));
        EXPECT_GE(p.covariance.east * p.covariance.north, p.covariance.cross * p.covariance.cross);
      }
    }
  }
}

TEST_P(LocalizationContract, Finds_a_plane_wave_at_its_onset) {
  const GeneralConfig general = test::tetrahedron(0.15F);
  const auto localizer = make(general);
  const Vec3 u = direction_of(-130, 25);
  EXPECT_LT(test::angle_deg(hop(*localizer, test::plane_wave(general, u))[0].direction, u), 5.4F);
}

TEST_P(LocalizationContract, Is_as_new_after_reset_and_gives_the_same_twice) {
  const GeneralConfig general = test::ring(6, 0.05F);
  const auto used = make(general);
  for (unsigned i = 0; i < 5; ++i) hop(*used, test::noise_spectra(general, i));
  used->reset();
  const auto fresh = make(general);
  for (unsigned i = 9; i < 12; ++i) {
    const auto spectra = test::noise_spectra(general, i);
    expect_same(hop(*used, spectra), hop(*fresh, spectra));
  }
}

TEST_P(LocalizationContract, Keeps_what_is_not_finite_out_of_its_state) {
  const GeneralConfig general = test::ring(4, 0.05F);
  const auto localizer = make(general);
  Grid<cfloat> broken = test::noise_spectra(general, 1);
  broken[0][20] = {std::numeric_limits<float>::quiet_NaN(), 0};
  broken[3][30] = {0, std::numeric_limits<float>::infinity()};
  for (int i = 0; i < 3; ++i) {
    for (const Potential& p : hop(*localizer, broken)) EXPECT_TRUE(std::isfinite(p.energy));
  }
  for (const Potential& p : hop(*localizer, test::noise_spectra(general, 2))) {
    EXPECT_TRUE(std::isfinite(p.energy) && std::isfinite(p.direction.x));
  }
}

TEST_P(LocalizationContract, Keeps_a_map_of_the_coarsest_grid_where_it_is_asked_to) {
  const GeneralConfig general = test::tetrahedron(0.15F);
  const auto localizer = make(general);
  const auto spectra = test::plane_wave(general, direction_of(70, 10));
  hop(*localizer, spectra);
  EXPECT_TRUE(localizer->power_map().empty());
  localizer->keep_power_map();
  localizer->reset();
  hop(*localizer, spectra);
  const auto map = localizer->power_map();
  ASSERT_EQ(map.size(), localizer->power_grid().size());
  const auto peak = static_cast<std::size_t>(std::max_element(map.begin(), map.end()) - map.begin());
  EXPECT_LT(test::angle_deg(localizer->power_grid()[peak], direction_of(70, 10)), 20);
}

TEST_P(LocalizationContract, Allocates_nothing_once_made) {
  const GeneralConfig general = test::ring(8, 0.1F);
  const auto localizer = make(general);
  const auto spectra = test::noise_spectra(general, 3);
  Grid<float> psd(8, kBins);
  psd.fill(0.1F);
  std::vector<Potential> found(4);
  const auto before = test::allocations();
  for (int i = 0; i < 3; ++i) localizer->locate(spectra, psd, found);
  EXPECT_EQ(test::allocations(), before);
}

INSTANTIATE_TEST_SUITE_P(All, LocalizationContract, ::testing::Values("srp_phat", "srp_clean"));

TEST(LocalizerRegistry, Refuses_a_name_that_it_does_not_know) {
  SslConfig ssl;
  ssl.mode = "esp";
  EXPECT_THROW((void)make_localizer(test::ring(4, 0.05F), ssl), ConfigError);
}

}  // namespace
}  // namespace odas::localization_contract_test
