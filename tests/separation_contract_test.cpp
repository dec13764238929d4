// SPDX-License-Identifier: MIT
// What every registered beamformer and post-filter promises.
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "support/allocation_counter.hpp"
#include "support/wave_field.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"
#include "odas/separation/registry.hpp"

namespace odas::separation_contract_test {
namespace {

constexpr std::size_t kBins = 129;

/// A beamformer and a post-filter at work on noise that is the same for the same seed.
class Separation {
 public:
  Separation(const std::string& mode_sep, const std::string& mode_pf, std::size_t mics, std::size_t slots)
      : general_(test::ring(mics)),
        config_(modes(mode_sep, mode_pf)),
        beamformer_(make_beamformer(config_, general_, slots)),
        filter_(make_post_filter(config_, {}, general_, slots)),
        psd_(mics, kBins),
        beams(slots, kBins),
        filtered(slots, kBins),
        tracks(slots) {
    psd_.fill(1);
    for (std::size_t s = 0; s < slots; ++s) {
      tracks[s] = test::track(s + 1, direction_of(77.F * static_cast<float>(s), 15));
    }
  }

  void hop(const Grid<cfloat>& spectra) {
    beams.fill({7, 7});
    filtered.fill({7, 7});
    beamformer_->separate(spectra, tracks, beams);
    filter_->apply(spectra, filter_->needs_noise() ? psd_.view() : GridView<const float>{}, tracks,
                   *beamformer_, beams, filtered);
  }

  void reset() {
    beamformer_->reset();
    filter_->reset();
  }

  [[nodiscard]] const Beamformer& beamformer() const { return *beamformer_; }

 private:
  static SssConfig modes(const std::string& mode_sep, const std::string& mode_pf) {
    SssConfig config;
    config.mode_sep = mode_sep;
    config.mode_pf = mode_pf;
    return config;
  }

  GeneralConfig general_;
  SssConfig config_;
  std::unique_ptr<Beamformer> beamformer_;
  std::unique_ptr<PostFilter> filter_;
  Grid<float> psd_;

 public:
  Grid<cfloat> beams;
  Grid<cfloat> filtered;
  std::vector<Track> tracks;
};

bool is_finite(const Grid<cfloat>& grid) {
  for (std::size_t r = 0; r < grid.rows(); ++r) {
    if (!std::isfinite(test::power(grid[r]))) return false;
  }
  return true;
}

bool are_equal(const Grid<cfloat>& a, const Grid<cfloat>& b) {
  return std::equal(a.data(), a.data() + a.rows() * a.cols(), b.data());
}

using Names = std::tuple<std::string_view, std::string_view>;

class SeparationContract : public testing::TestWithParam<Names> {
 protected:
  [[nodiscard]] Separation make(std::size_t mics = 5, std::size_t slots = 3) const {
    return {std::string(std::get<0>(GetParam())), std::string(std::get<1>(GetParam())), mics, slots};
  }
};

TEST_P(SeparationContract, takes_any_number_of_microphones_and_slots) {
  test::Noise noise;
  for (const std::size_t mics : {1U, 2U, 3U, 16U, 33U}) {
    for (const std::size_t slots : {0U, 1U, 4U, 7U}) {
      Separation separation = make(mics, slots);
      for (int hop = 0; hop < 5; ++hop) separation.hop(noise(mics, kBins));
      EXPECT_TRUE(is_finite(separation.beams)) << mics << " mics, " << slots << " slots";
      EXPECT_TRUE(is_finite(separation.filtered)) << mics << " mics, " << slots << " slots";
      for (std::size_t s = 0; s < slots; ++s) {
        EXPECT_EQ(separation.beamformer().weights(s).rows(), mics);
        EXPECT_EQ(separation.beamformer().weights(s).cols(), kBins);
        EXPECT_GT(test::power(separation.beams[s]), 0);
      }
    }
  }
}

TEST_P(SeparationContract, weights_are_those_that_were_applied) {
  Separation separation = make();
  test::Noise noise;
  Grid<cfloat> spectra;
  for (int hop = 0; hop < 5; ++hop) separation.hop(spectra = noise(5, kBins));
  for (std::size_t s = 0; s < 3; ++s) {
    const auto weights = separation.beamformer().weights(s);
    for (std::size_t k = 0; k < kBins; ++k) {
      cfloat y{};
      for (std::size_t m = 0; m < 5; ++m) y += weights[m][k] * spectra[m][k];
      EXPECT_LT(std::abs(y - separation.beams[s][k]), 1e-5F);
    }
  }
}

TEST_P(SeparationContract, an_empty_slot_is_silent) {
  Separation separation = make();
  test::Noise noise;
  separation.hop(noise(5, kBins));
  separation.tracks[1] = Track{};
  separation.hop(noise(5, kBins));
  EXPECT_EQ(test::power(separation.beams[1]), 0);
  EXPECT_EQ(test::power(separation.filtered[1]), 0);
  EXPECT_GT(test::power(separation.beams[2]), 0);
  for (std::size_t m = 0; m < 5; ++m) EXPECT_EQ(test::power(separation.beamformer().weights(1)[m]), 0);
}

TEST_P(SeparationContract, a_post_filter_never_amplifies) {
  Separation separation = make();
  test::Noise noise;
  for (int hop = 0; hop < 50; ++hop) {
    separation.hop(noise(5, kBins));
    for (std::size_t s = 0; s < 3; ++s) {
      for (std::size_t k = 0; k < kBins; ++k) {
        ASSERT_LE(std::abs(separation.filtered[s][k]), 1.00001F * std::abs(separation.beams[s][k]));
      }
    }
  }
}

TEST_P(SeparationContract, reset_is_as_new_and_the_same_input_gives_the_same_bits) {
  Separation used = make();
  test::Noise other(5);
  for (int hop = 0; hop < 30; ++hop) used.hop(other(5, kBins));
  used.reset();
  Separation fresh = make();
  test::Noise noise;
  for (int hop = 0; hop < 30; ++hop) {
    const Grid<cfloat> spectra = noise(5, kBins);
    used.hop(spectra);
    fresh.hop(spectra);
    ASSERT_TRUE(are_equal(used.beams, fresh.beams));
    ASSERT_TRUE(are_equal(used.filtered, fresh.filtered));
  }
}

TEST_P(SeparationContract, a_new_id_in_a_slot_begins_as_new) {
  Separation used = make(5, 1);
  Separation fresh = make(5, 1);
  test::Noise noise;
  for (int hop = 0; hop < 30; ++hop) used.hop(noise(5, kBins));
  used.tracks[0].id = fresh.tracks[0].id = 9;
  for (int hop = 0; hop < 5; ++hop) {
    const Grid<cfloat> spectra = noise(5, kBins);
    used.hop(spectra);
    fresh.hop(spectra);
    ASSERT_TRUE(are_equal(used.beams, fresh.beams));
    ASSERT_TRUE(are_equal(used.filtered, fresh.filtered));
  }
}

TEST_P(SeparationContract, what_is_not_finite_is_gone_with_its_hop) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          std::numeric_limits<float>::max()}) {
    Separation separation = make();
    test::Noise noise;
    for (int hop = 0; hop < 20; ++hop) {
      Grid<cfloat> spectra = noise(5, kBins);
      if (hop == 10) {
        spectra[2][17] = {bad, bad};
        spectra[3][128] = {bad, 0};
      }
      separation.hop(spectra);
      if (hop != 10) {
        ASSERT_TRUE(is_finite(separation.beams)) << bad << " hop " << hop;
        ASSERT_TRUE(is_finite(separation.filtered)) << bad << " hop " << hop;
        ASSERT_GT(test::power(separation.beams[0]), 0);
      }
    }
  }
}

TEST_P(SeparationContract, a_direction_that_is_not_finite_gives_silence) {
  Separation separation = make();
  test::Noise noise;
  const Vec3 good = separation.tracks[0].direction;
  separation.hop(noise(5, kBins));
  separation.tracks[0].direction = {std::numeric_limits<float>::quiet_NaN(), 0, 0};
  separation.hop(noise(5, kBins));
  EXPECT_EQ(test::power(separation.beams[0]), 0);
  EXPECT_EQ(test::power(separation.filtered[0]), 0);
  separation.tracks[0].direction = good;
  separation.hop(noise(5, kBins));
  EXPECT_GT(test::power(separation.beams[0]), 0);
}

TEST_P(SeparationContract, allocates_nothing_in_a_hop) {
  Separation separation = make(16, 4);
  const Grid<cfloat> spectra = test::Noise()(16, kBins);
  const std::size_t before = test::allocations();
  for (int hop = 0; hop < 10; ++hop) {
    separation.tracks[1].direction = direction_of(static_cast<float>(hop), 0);
    separation.tracks[2].id = hop % 3 == 0 ? 0 : 9;
    separation.hop(spectra);
  }
  separation.reset();
  EXPECT_EQ(test::allocations(), before);
}

INSTANTIATE_TEST_SUITE_P(All, SeparationContract,
                         testing::Combine(testing::ValuesIn(beamformer_names()),
                                          testing::ValuesIn(post_filter_names())),
                         [](const testing::TestParamInfo<Names>& names) {
                           return std::string(std::get<0>(names.param)) + "_" +
                                  std::string(std::get<1>(names.param));
                         });

TEST(SeparationRegistry, refuses_a_name_that_is_not_there_and_says_which_are) {
  SssConfig config;
  config.mode_sep = "lcmv";
  try {
    (void)make_beamformer(config, test::ring(4), 4);
    FAIL() << "made an lcmv";
  } catch (const ConfigError& error) {
    ASSERT_EQ(error.faults().size(), 1U);
    EXPECT_EQ(error.faults()[0].path, "sss.mode_sep");
    EXPECT_NE(error.faults()[0].what.find("dds, dgss, dmvdr, dgev"), std::string::npos);
  }
  config.mode_pf = "none";
  EXPECT_THROW((void)make_post_filter(config, {}, test::ring(4), 4), ConfigError);
}

}  // namespace
}  // namespace odas::separation_contract_test
