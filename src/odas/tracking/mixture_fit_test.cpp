// SPDX-License-Identifier: MIT
#include "odas/tracking/mixture_fit.hpp"

#include <random>

#include <gtest/gtest.h>

namespace odas::mixture_fit_test {
namespace {

/// `hops` draws of a mixture.
EnergyHistogram drawn(const Mixture& mixture, int hops, unsigned seed) {
  std::mt19937 random(seed);
  EnergyHistogram histogram;
  std::vector<double> weights;
  for (const GaussianConfig& g : mixture) weights.push_back(g.weight);
  std::discrete_distribution<std::size_t> which(weights.begin(), weights.end());
  for (int i = 0; i < hops; ++i) {
    const GaussianConfig& g = mixture[which(random)];
    histogram.add(std::normal_distribution<double>(g.mu, std::sqrt(g.sigma2))(random));
  }
  return histogram;
}

const Mixture kSilence{{1, 0.06F, 0.0004F}};
const Mixture kSpeech{{1, 0.3F, 0.0025F}};

/// Talk of which this share is pauses.
EnergyHistogram talk(double pauses, unsigned seed = 2) {
  Mixture both = kSpeech;
  both[0].weight = static_cast<float>(1 - pauses);
  both.push_back(kSilence[0]);
  both[1].weight = static_cast<float>(pauses);
  return drawn(both, 6000, seed);
}

TEST(MixtureFit, finds_one_gaussian_each_where_there_is_one_each_whatever_the_pauses) {
  for (const double pauses : {0.0, 0.3, 0.7}) {
    const auto found = fit_mixtures({drawn(kSilence, 6000, 1), {}}, {talk(pauses), {}});
    ASSERT_EQ(found.inactive.size(), 1U);
    ASSERT_EQ(found.active.size(), 1U);
    EXPECT_NEAR(found.inactive[0].mu, 0.06, 0.002);
    EXPECT_NEAR(found.inactive[0].sigma2, 0.0004, 4e-5);
    EXPECT_NEAR(found.active[0].mu, 0.3, 0.01);
    EXPECT_NEAR(found.active[0].sigma2, 0.0025, 4e-4);
    EXPECT_NEAR(found.heard, 1 - pauses, 0.02);
    EXPECT_FLOAT_EQ(found.active[0].weight, 1);
  }
}

TEST(MixtureFit, takes_more_gaussians_where_they_pay) {
  const Mixture two{{0.6F, 0.02F, 0.0002F}, {0.4F, 0.12F, 0.0006F}};
  const auto found = fit_mixtures({drawn(two, 24000, 3), {}}, {talk(0), {}});
  ASSERT_EQ(found.inactive.size(), 2U);
  EXPECT_NEAR(found.inactive[0].mu, 0.02, 0.003);
  EXPECT_NEAR(found.inactive[1].mu, 0.12, 0.005);
  EXPECT_NEAR(found.inactive[0].weight, 0.6, 0.03);
}

TEST(MixtureFit, counts_the_reflections_of_talk_among_the_inactive) {
  const Mixture reflections{{1, 0.14F, 0.0006F}};
  const auto without = fit_mixtures({drawn(kSilence, 6000, 1), {}}, {talk(0.3), {}});
  const auto with = fit_mixtures({drawn(kSilence, 6000, 1), {}}, {talk(0.3), drawn(reflections, 18000, 4)});
  EXPECT_LT(density(without.inactive, 0.14), 0.5 * density(without.active, 0.14));
  EXPECT_GT(density(with.inactive, 0.14), density(with.active, 0.14));
}

TEST(MixtureFit, keeps_the_order_the_more_energy_the_more_active) {
  const Mixture wide{{1, 0.2F, 0.02F}};  // reaches far below the silence
  const Mixture narrow{{1, 0.05F, 0.0002F}};
  const auto found = fit_mixtures({drawn(narrow, 6000, 5), {}}, {drawn(wide, 6000, 6), {}});
  ASSERT_FALSE(found.active.empty());
  int crossings = 0;
  bool active = false;
  for (double energy = 0; energy < 1; energy += 0.001) {
    const double a = density(found.active, energy), i = density(found.inactive, energy);
    if (a != i && (a > i) != active) {
      active = a > i;
      ++crossings;
    }
  }
  EXPECT_EQ(crossings, 1) << "from the silent to the active, and never back";
  EXPECT_TRUE(active);
}

TEST(MixtureFit, never_trusts_a_silence_more_than_to_a_hundredth) {
  EnergyHistogram still;
  still.add(0.004, 24000);
  const auto found = fit_mixtures({still, {}}, {talk(0.2), {}});
  for (const GaussianConfig& g : found.inactive) EXPECT_GE(g.sigma2, 0.99e-4F);
}

TEST(MixtureFit, says_that_nothing_was_heard_where_talk_is_like_silence) {
  const Mixture weaker{{1, 0.03F, 0.0004F}};
  const auto found = fit_mixtures({drawn(kSilence, 6000, 1), drawn(weaker, 18000, 8)},
                                  {drawn(kSilence, 6000, 7), drawn(weaker, 18000, 9)});
  EXPECT_TRUE(found.active.empty()) << found.heard << ' ' << found.active[0].mu;
  EXPECT_TRUE(fit_mixtures({}, {}).active.empty());
}

TEST(MixtureFit, gives_the_same_from_the_same) {
  const auto once = fit_mixtures({drawn(kSilence, 6000, 1), {}}, {talk(0.4), {}});
  const auto again = fit_mixtures({drawn(kSilence, 6000, 1), {}}, {talk(0.4), {}});
  EXPECT_EQ(once.active[0].mu, again.active[0].mu);
  EXPECT_EQ(once.heard, again.heard);
}

TEST(Separation, is_what_two_equal_gaussians_make_it) {
  // Means d apart, deviation s: equal error Q(d / 2s), overlap 2 Q(d / 2s). Here d / 2s = 1.
  const Separation s = separation({{1, 0.3F, 0.01F}}, {{1, 0.1F, 0.01F}});
  EXPECT_NEAR(s.equal_error, 0.1587, 0.003);
  EXPECT_NEAR(s.overlap, 0.3173, 0.003);
  EXPECT_NEAR(s.threshold, 0.2, 0.002);
}

TEST(Separation, is_none_without_mixtures) { EXPECT_EQ(separation({}, {}).equal_error, 1); }

}  // namespace
}  // namespace odas::mixture_fit_test
