// SPDX-License-Identifier: MIT
#include "odas/separation/mask_filter.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <random>

#include "support/wave_field.hpp"
#include <gtest/gtest.h>

namespace odas::mask_filter_test {
namespace {

constexpr std::size_t kBins = 129;

/// Says whose the bins are.
class Masks final : public Beamformer {
 public:
  explicit Masks(bool known) : known_(known) {}
  void say(std::size_t slot, float share) { masks_[slot].assign(kBins, share); }
  void separate(GridView<const cfloat>, std::span<const Track>, GridView<cfloat>) noexcept override {}
  [[nodiscard]] GridView<const cfloat> weights(std::size_t) const noexcept override { return {}; }
  [[nodiscard]] std::span<const float> mask(std::size_t slot) const noexcept override {
    return known_ ? std::span<const float>(masks_[slot]) : std::span<const float>();
  }
  void reset() noexcept override {}

 private:
  bool known_;
  std::array<std::vector<float>, 2> masks_{std::vector<float>(kBins), std::vector<float>(kBins)};
};

/// Two voices that speak in turn, for 0.2 s each, then pause, over a noise; some of each leaks into the
/// other's beam.
class Conversation {
 public:
  Conversation(float leak, float noise, bool masks_known) : leak_(leak), noise_(noise), masks_(masks_known) {
    config_.g_min = 0.05F;
    filter_.emplace(config_, test::ring(4), 2);
  }

  /// Of the second beam, while the other speaks and while its own voice does: what comes out to what went in,
  /// dB, over the last half of `hops`.
  struct Gains {
    double other = 0, own = 0;
  };
  Gains hear(int hops) {
    std::array<double, 3> in{}, out{};
    for (int hop = 0; hop < hops; ++hop) {
      const std::size_t speaks = static_cast<std::size_t>(hop / 25) % 3;  // 2: nobody
      for (std::size_t k = 0; k < kBins; ++k) {
        const cfloat voice{normal_(random_), normal_(random_)};
        for (std::size_t s = 0; s < 2; ++s) {
          const cfloat own_noise{normal_(random_), normal_(random_)};
          beams_[s][k] = (s == speaks ? 1 : speaks == 2 ? 0 : leak_) * voice + noise_ * own_noise;
        }
        mics_[0][k] = beams_[speaks % 2][k];
      }
      for (std::size_t s = 0; s < 2; ++s) masks_.say(s, s == speaks ? 0.95F : 0.05F);
      filter_->apply(mics_, {}, tracks_, masks_, beams_, filtered_);
      for (std::size_t k = 0; k < kBins && hop >= hops / 2; ++k) {
        in[speaks] += std::norm(beams_[1][k]);
        out[speaks] += std::norm(filtered_[1][k]);
      }
    }
    return {10 * std::log10(out[0] / in[0]), 10 * std::log10(out[1] / in[1])};
  }

 private:
  float leak_, noise_;
  Masks masks_;
  MaskFilterConfig config_;
  std::optional<MaskFilter> filter_;
  std::mt19937 random_{1};
  std::normal_distribution<float> normal_;
  std::vector<Track> tracks_{test::track(1, {1, 0, 0}), test::track(2, {0, 1, 0})};
  Grid<cfloat> mics_{4, kBins}, beams_{2, kBins}, filtered_{2, kBins};
};

TEST(MaskFilter, takes_out_what_leaks_from_another_voice_and_leaves_its_own) {
  for (const bool masks_known : {true, false}) {
    const auto gains = Conversation(0.3F, 1e-3F, masks_known).hear(500);
    EXPECT_LT(gains.other, -12) << masks_known;
    EXPECT_GT(gains.own, -1) << masks_known;
  }
}

TEST(MaskFilter, takes_out_no_more_than_leaks) {
  const auto gains = Conversation(0, 0.1F, true).hear(500);
  EXPECT_GT(gains.own, -0.5);
}

TEST(MaskFilter, holds_a_steady_noise_near_the_floor_and_never_under_it) {
  MaskFilterConfig config;
  config.g_min = 0.1F;
  MaskFilter filter(config, test::ring(4), 1);
  Masks beamformer(true);
  beamformer.say(0, 0.5F);
  const std::vector<Track> tracks{test::track(1, {1, 0, 0})};
  std::mt19937 random(1);
  std::normal_distribution<float> normal;
  Grid<cfloat> mics(4, kBins), beams(1, kBins), filtered(1, kBins);
  double in = 0, out = 0;
  for (int hop = 0; hop < 400; ++hop) {
    for (std::size_t k = 0; k < kBins; ++k) mics[0][k] = beams[0][k] = {normal(random), normal(random)};
    filter.apply(mics, {}, tracks, beamformer, beams, filtered);
    for (std::size_t k = 0; k < kBins && hop >= 200; ++k) {
      in += std::norm(beams[0][k]);
      out += std::norm(filtered[0][k]);
      ASSERT_GE(std::abs(filtered[0][k]), 0.0999F * std::abs(beams[0][k]));
    }
  }
  EXPECT_LT(10 * std::log10(out / in), -10);
}

TEST(MaskFilter, approximates_the_gain_of_the_least_error_of_log_spectra_within_2_percent) {
  for (double v = 1e-3; v < 100; v *= 1.1) {
    const double exact = std::exp(-std::expint(-v) / 2);
    EXPECT_NEAR(static_cast<double>(log_spectral_gain(static_cast<float>(v))) / exact, 1, 0.02) << v;
  }
}

}  // namespace
}  // namespace odas::mask_filter_test
