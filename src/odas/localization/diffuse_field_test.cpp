// SPDX-License-Identifier: MIT
#include "odas/localization/diffuse_field.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "support/plane_wave.hpp"
#include <gtest/gtest.h>

namespace odas::diffuse_field_test {
namespace {

constexpr std::size_t kFrame = 256;
constexpr std::size_t kBins = kFrame / 2 + 1;
constexpr int kRate = 4;
constexpr std::size_t kHalf = 25;
constexpr float kBinHz = 62.5F;

struct Field {
  explicit Field(const GeneralConfig& config)
      : general(config), pairs(all_pairs(config.mics.size())), field(general, pairs, table, kBinHz) {}
  GeneralConfig general;
  std::vector<Pair> pairs;
  LagTable table{kFrame, kRate, kHalf};
  DiffuseField field;
  std::vector<float> scratch = std::vector<float>(lag_scratch_size(table));
};

TEST(DiffuseField, Subtracts_the_transform_of_the_coherence_of_each_pair) {
  Field f(test::ring(5, 0.06F));
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(0, 1);
  std::vector<float> share(kBins);
  for (float& s : share) s = uniform(random);
  Grid<float> x(f.pairs.size(), 2 * kHalf + 1);
  f.field.subtract(share, f.table, f.table.all_bins(), f.scratch, x);
  for (std::size_t q = 0; q < f.pairs.size(); ++q) {
    const auto [i, j] = f.pairs[q];
    const auto d = static_cast<double>(norm(position(f.general.mics[i]) - position(f.general.mics[j])));
    for (std::size_t n = 0; n < x.cols(); ++n) {
      const double lag = (static_cast<double>(n) - static_cast<double>(kHalf)) / (kRate * 16000.0);
      double sum = 0;
      for (std::size_t k = 0; k < kBins; ++k) {
        const double omega = 2 * std::numbers::pi * static_cast<double>(k) * static_cast<double>(kBinHz);
        const double kd = omega * d / 343;
        const double coherence = kd > 0 ? std::sin(kd) / kd : 1;
        sum += (k == 0 ? 1 : 2) * static_cast<double>(share[k]) * coherence * std::cos(omega * lag) / kFrame;
      }
      EXPECT_NEAR(x[q][n], -sum, 1e-4);
    }
  }
}

TEST(DiffuseField, Leaves_directional_microphones_alone) {
  GeneralConfig general = test::ring(4, 0.06F);
  general.mics[2].angle = {80, 90};
  Field f(general);
  Grid<float> x(f.pairs.size(), 2 * kHalf + 1);
  f.field.subtract(std::vector<float>(kBins, 1.F), f.table, f.table.all_bins(), f.scratch, x);
  for (std::size_t q = 0; q < x.rows(); ++q) {
    for (const float value : x[q]) EXPECT_EQ(value, 0);
  }
}

}  // namespace
}  // namespace odas::diffuse_field_test
