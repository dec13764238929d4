// SPDX-License-Identifier: MIT
#include "odas/tracking/association.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace odas::association_test {
namespace {

double gaussian(double x, double mu, double variance) {
  return std::exp(-(x - mu) * (x - mu) / (2 * variance)) / std::sqrt(2 * std::numbers::pi * variance);
}

/// ODAS's way: every assignment of every potential to false, new or a track, one by one.
struct Enumerated {
  Enumerated(const SstConfig& config, const std::vector<Potential>& pots,
             const std::vector<std::vector<double>>& track_likelihoods, double share)
      : from_track(track_likelihoods.size(), std::vector<double>(pots.size(), 0)),
        activity(track_likelihoods.size(), 0),
        is_new(pots.size(), 0) {
    const std::size_t hypotheses = track_likelihoods.size() + 2;
    std::size_t combinations = 1;
    for (std::size_t s = 0; s < pots.size(); ++s) combinations *= hypotheses;
    const double diffuse = 1 / (4 * std::numbers::pi * share);
    const auto likelihood = [&](std::size_t c, std::size_t s) {
      double active = 0;
      double inactive = 0;
      const auto e = static_cast<double>(pots[s].energy);
      for (const auto& g : config.active)
        active += static_cast<double>(g.weight) *
                  gaussian(e, static_cast<double>(g.mu), static_cast<double>(g.sigma2));
      for (const auto& g : config.inactive)
        inactive += static_cast<double>(g.weight) *
                    gaussian(e, static_cast<double>(g.mu), static_cast<double>(g.sigma2));
      if (c == 0) return inactive * diffuse * static_cast<double>(config.p_false);
      if (c == 1) return active * diffuse * static_cast<double>(config.p_new);
      return active * track_likelihoods[c - 2][s] * static_cast<double>(config.p_track);
    };
    double total = 0;
    for (int pass = 0; pass < 2; ++pass) {
      for (std::size_t combination = 0; combination < combinations; ++combination) {
        double p = 1;
        std::vector<std::size_t> of(pots.size());
        std::size_t rest = combination;
        for (std::size_t s = 0; s < pots.size(); ++s, rest /= hypotheses) {
          of[s] = rest % hypotheses;
          p *= likelihood(of[s], s);
        }
        if (pass == 0) {
          total += p;
          continue;
        }
        std::vector<bool> any(track_likelihoods.size(), false);
        for (std::size_t s = 0; s < pots.size(); ++s) {
          if (of[s] == 1) is_new[s] += p / total;
          if (of[s] >= 2) {
            from_track[of[s] - 2][s] += p / total;
            any[of[s] - 2] = true;
          }
        }
        for (std::size_t t = 0; t < any.size(); ++t) activity[t] += any[t] ? p / total : 0;
      }
    }
  }
  std::vector<std::vector<double>> from_track;
  std::vector<double> activity, is_new;
};

TEST(Association, Agrees_with_the_sum_over_all_assignments) {
  std::mt19937 random(9);
  std::uniform_real_distribution<float> energy(0.05F, 0.6F);
  std::uniform_real_distribution<double> log_likelihood(-8, 4);
  SstConfig config;
  config.active = {{0.7F, 0.4F, 0.0025F}, {0.3F, 0.6F, 0.01F}};
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Potential> pots(3);
    for (Potential& p : pots) p.energy = energy(random);
    std::vector<std::vector<double>> likelihoods(2, std::vector<double>(3));
    Association association(config, 3, 3, 0.45);
    association.set_dead(2);
    for (std::size_t t = 0; t < 2; ++t) {
      for (std::size_t s = 0; s < 3; ++s) {
        const double l = log_likelihood(random);
        likelihoods[t][s] = std::exp(l);
        association.set_track(t, s, l);
      }
    }
    association.solve(pots);
    const Enumerated oracle(config, pots, likelihoods, 0.45);
    for (std::size_t t = 0; t < 2; ++t) {
      EXPECT_NEAR(association.activity(t), oracle.activity[t], 1e-9);
      for (std::size_t s = 0; s < 3; ++s) {
        EXPECT_NEAR(association.from_track(t)[s], oracle.from_track[t][s], 1e-9);
        EXPECT_NEAR(association.is_new(s), oracle.is_new[s], 1e-9);
      }
    }
    EXPECT_EQ(association.activity(2), 0);
    const double beside = association.is_new_beside(0, std::log(likelihoods[0][0]));
    std::vector<std::vector<double>> three = likelihoods;
    three.push_back(likelihoods[0]);
    EXPECT_NEAR(beside, Enumerated(config, pots, three, 0.45).is_new[0], 1e-9);
  }
}

// ODAS fault B5: a clean loud source made every hypothesis underflow, and nothing was ever created.
TEST(Association, Of_a_clean_loud_source_does_not_underflow) {
  Association association({}, 4, 4, 0.5);
  for (std::size_t t = 0; t < 4; ++t) association.set_dead(t);
  const std::vector<Potential> pots{
      {{0, 0, 1}, 0.99F}, {{0, 1, 0}, 0.0F}, {{1, 0, 0}, 0.0F}, {{0, 0, 1}, 0.0F}};
  association.solve(pots);
  EXPECT_GT(association.is_new(0), 0.99);
  EXPECT_LT(association.is_new(1), 0.01);
}

TEST(Association, Of_an_energy_that_is_no_number_finds_nothing) {
  Association association({}, 1, 1, 1);
  association.set_track(0, 0, 0);
  const Potential broken{{0, 0, 1}, std::nanf("")};
  association.solve({&broken, 1});
  EXPECT_EQ(association.is_new(0), 0);
  EXPECT_EQ(association.activity(0), 0);
}

}  // namespace
}  // namespace odas::association_test
