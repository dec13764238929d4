// SPDX-License-Identifier: MIT
#include "odas/separation/talker_masks.hpp"

#include "support/wave_field.hpp"
#include <gtest/gtest.h>

#include "odas/separation/factor_kernels.hpp"

namespace odas::talker_masks_test {
namespace {

constexpr std::size_t kBins = 129;

BinBlocks steering_of(const GeneralConfig& general, Vec3 u) {
  BinBlocks d(general.mics.size(), kBins);
  for (std::size_t m = 0; m < d.rows(); ++m) {
    for (std::size_t k = 0; k < kBins; ++k) d.set(m, k, cfloat(test::phase_at(general, m, u, k)));
  }
  return d;
}

double mean(const BinReals& mask) {
  double sum = 0;
  for (std::size_t k = 20; k < 100; ++k) sum += static_cast<double>(mask[k]) / 80;
  return sum;
}

TEST(TalkerMasks, a_plane_wave_is_his_who_stands_there) {
  const GeneralConfig general = test::ring(6, 0.04F);
  TalkerMasks masks(general, 2);
  const Vec3 here = direction_of(20, 0);
  const Vec3 there = direction_of(130, 0);
  masks.listen(0, steering_of(general, here));
  masks.listen(1, steering_of(general, there));
  std::vector<BinReals> powers(2, BinReals(kBins));
  for (BinReals& power : powers) power.fill(1);
  BinReals floor(kBins);
  floor.fill(0.1F);
  test::Noise noise;
  for (int hop = 0; hop < 20; ++hop) {
    Grid<cfloat> spectra(general.mics.size(), kBins);
    test::add_plane_wave(general, there, noise(kBins), spectra);
    BinBlocks x(general.mics.size(), kBins);
    for (std::size_t m = 0; m < x.rows(); ++m) x.set_row(m, spectra[m]);
    masks.update(x, powers, floor);
  }
  EXPECT_GT(mean(masks.mask(1)), 0.85);
  EXPECT_LT(mean(masks.mask(0)), 0.1);
  masks.leave(1);
  EXPECT_EQ(mean(masks.mask(1)), 0);
}

TEST(TalkerMasks, diffuse_coherence_is_one_at_zero_and_falls_with_distance) {
  const GeneralConfig general = test::ring(4, 0.1F);
  const BinBlocks factor = diffuse_factor(general, 0.1F);
  const auto coherence = [&](std::size_t k) {  // of microphones 0 and 1
    return (factor.get(factor_row(4, 1, 0), k) * factor.get(factor_row(4, 0, 0), k)).real();
  };
  EXPECT_NEAR(coherence(0), 0.9, 1e-5);
  const double x = 2 * M_PI * 20 * 62.5 * 0.1 * std::sqrt(2.0) / 343;
  EXPECT_NEAR(coherence(20), 0.9 * std::sin(x) / x, 1e-4);
}

}  // namespace
}  // namespace odas::talker_masks_test
