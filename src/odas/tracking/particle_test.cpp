// SPDX-License-Identifier: MIT
#include "odas/tracking/particle.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "support/plane_wave.hpp"
#include <gtest/gtest.h>

namespace odas::particle_test {
namespace {

using test::angle_deg;

constexpr double kHop = 0.008;
constexpr double kSigma2 = 0.0225;

/// One hop in which only this is heard.
void hear(Particle& filter, Vec3 z, double activity = 1) {
  const Potential potential{z, 0.5F};
  const double probability = activity;
  filter.predict();
  filter.update({&potential, 1}, {&probability, 1}, activity, kSigma2);
}

TEST(Particle, follows_a_walk) {
  Particle filter({}, kHop);
  filter.start(direction_of(0, 0));
  std::mt19937 random(1);
  std::normal_distribution<float> jitter(0, 5);
  float sum = 0;
  for (int hop = 0; hop < 1000; ++hop) {
    const float azimuth = 0.08F * static_cast<float>(hop);  // 10 degrees/s
    hear(filter, direction_of(azimuth + jitter(random), jitter(random)));
    ASSERT_NEAR(norm(filter.direction()), 1, 1e-5);
    if (hop >= 250) sum += angle_deg(filter.direction(), direction_of(azimuth, 0));
  }
  EXPECT_LT(sum / 750, 2);
}

TEST(Particle, likelihood_of_a_cloud_that_has_just_begun_is_the_density_of_a_Gaussian) {
  Particle filter({}, kHop);
  const Vec3 u = direction_of(20, 10);
  filter.start(u);
  for (const float away : {0.F, 5.F, 20.F}) {
    const Vec3 z = direction_of(20 + away, 10);
    const auto d2 = static_cast<double>(dot(z - u, z - u));
    const double expected = -1.5 * std::log(2 * std::numbers::pi * kSigma2) - d2 / (2 * kSigma2);
    EXPECT_NEAR(filter.log_likelihood(z, kSigma2), expected, 1e-3) << away;
  }
}

TEST(Particle, likelihood_of_a_cloud_is_the_mean_over_its_particles_and_far_off_it_ends) {
  Particle filter({}, kHop);
  const Vec3 u{0, 0, 1};
  filter.start(u);
  for (int hop = 0; hop < 50; ++hop) filter.predict();
  EXPECT_LT(filter.log_likelihood(u, 1e-4), -1.5 * std::log(2 * std::numbers::pi * 1e-4) - 0.01)
      << "it has spread";
  const double floor = -1.5 * std::log(2 * std::numbers::pi * 0.0025) - 20;
  EXPECT_NEAR(filter.log_likelihood({1, 0, 0}, 0.0025), floor, 1e-6);
  EXPECT_NEAR(filter.log_likelihood({0, 0, -1}, 0.0025), floor, 1e-6);
}

TEST(Particle, takes_the_likeliest_potential) {
  Particle filter({}, kHop);
  filter.start(direction_of(10, 0));
  const Potential heard[]{{direction_of(35, 0), 0.5F}, {direction_of(10, 0), 0.5F}};
  const double probability[]{0.4, 0.9};
  for (int hop = 0; hop < 250; ++hop) {
    filter.predict();
    filter.update(heard, probability, 1, kSigma2);
  }
  EXPECT_LT(angle_deg(filter.direction(), direction_of(10, 0)), 3);
}

TEST(Particle, stays_while_its_source_is_silent_and_finds_it_again_nearby) {
  Particle filter({}, kHop);
  filter.start(direction_of(10, 0));
  for (int hop = 0; hop < 100; ++hop) hear(filter, direction_of(10, 0));
  const Vec3 before = filter.direction();
  for (int hop = 0; hop < 500; ++hop) hear(filter, direction_of(90, 0), 0);
  EXPECT_LT(angle_deg(filter.direction(), before), 0.1F);
  for (int hop = 0; hop < 125; ++hop) hear(filter, direction_of(25, 0));
  EXPECT_LT(angle_deg(filter.direction(), direction_of(25, 0)), 5);
}

TEST(Particle, gives_the_same_bits_each_time_it_starts) {
  Particle used({}, kHop);
  for (int hop = 0; hop < 100; ++hop) hear(used, direction_of(static_cast<float>(hop), 30));
  Particle fresh({}, kHop);
  used.start({1, 0, 0});
  fresh.start({1, 0, 0});
  for (int hop = 0; hop < 100; ++hop) {
    hear(used, direction_of(static_cast<float>(hop) / 10, 0));
    hear(fresh, direction_of(static_cast<float>(hop) / 10, 0));
    ASSERT_EQ(used.direction(), fresh.direction());
  }
}

TEST(Particle, does_not_depend_on_how_many_particles_there_are_but_for_their_noise) {
  for (const int n : {1, 4, 5, 100, 999, 4000}) {
    ParticleConfig config;
    config.n_particles = n;
    Particle filter(config, kHop);
    filter.start(direction_of(10, 0));
    for (int hop = 0; hop < 100; ++hop) hear(filter, direction_of(10, 0));
    EXPECT_LT(angle_deg(filter.direction(), direction_of(10, 0)), n < 100 ? 15 : 2) << n;
  }
}

TEST(Particle, moves_as_the_ratios_say) {
  const auto after_a_turn = [](float st, float ve, float ac) {
    ParticleConfig config;
    config.st_ratio = st;
    config.ve_ratio = ve;
    config.ac_ratio = ac;
    Particle filter(config, kHop);
    filter.start(direction_of(0, 0));
    for (int hop = 0; hop < 40; ++hop) hear(filter, direction_of(20, 0));
    return angle_deg(filter.direction(), direction_of(0, 0));
  };
  EXPECT_LT(after_a_turn(1, 0, 0), after_a_turn(0, 0, 1)) << "those that stand still are the slowest";
  EXPECT_EQ(after_a_turn(0, 0, 1), after_a_turn(0, 0, 0.5F)) << "shares, whatever they add up to";
}

TEST(Particle, survives_what_no_particle_explains) {
  Particle filter({}, kHop);
  filter.start({0, 0, 1});
  for (int hop = 0; hop < 50; ++hop) hear(filter, {0, 0, -1});
  EXPECT_NEAR(norm(filter.direction()), 1, 1e-5);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  hear(filter, {nan, nan, nan}, 0);
  hear(filter, {0, 0, 1});
  EXPECT_NEAR(norm(filter.direction()), 1, 1e-5);
}

}  // namespace
}  // namespace odas::particle_test
