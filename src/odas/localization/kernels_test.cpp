// SPDX-License-Identifier: MIT
#include "odas/localization/kernels.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <hwy/targets.h>

namespace odas::kernels_test {
namespace {

/// Every test runs with every instruction set that this machine has.
class Kernels : public ::testing::TestWithParam<std::int64_t> {
 protected:
  void SetUp() override { choose(GetParam()); }
  void TearDown() override { choose(0); }

 private:
  static void choose(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

Grid<float> noise(std::size_t rows, std::size_t cols, std::size_t used, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<float> normal;
  Grid<float> grid(rows, cols);
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < used; ++c) grid[r][c] = normal(random);
  }
  return grid;
}

TEST_P(Kernels, Lag_products_are_the_inverse_DFT_of_the_zero_padded_cross_spectrum) {
  struct Case {
    std::size_t frame, mics, half;
    int r;
    bool only_some;
  };
  for (const auto [frame, mics, half, r, only_some] :
       {Case{256, 4, 14, 4, false}, Case{256, 4, 14, 4, true}, Case{256, 3, 30, 1, false},
        Case{90, 2, 7, 3, true}, Case{16, 5, 8, 1, false}}) {
    const std::size_t bins = frame / 2 + 1;
    auto re = noise(mics, padded(bins), bins, 1);
    auto im = noise(mics, padded(bins), bins, 2);
    const auto pairs = all_pairs(mics);
    const LagTable table(frame, r, half);
    std::vector<std::uint16_t> some;
    for (const std::uint16_t k : table.all_bins()) {
      if (only_some && k % 3 != 0) {
        for (std::size_t m = 0; m < mics; ++m) re[m][k] = im[m][k] = 0;
      } else {
        some.push_back(k);
      }
    }
    std::vector<float> scratch(lag_scratch_size(table));
    Grid<float> out(pairs.size(), 2 * half + 1);
    lag_products(re, im, pairs, table, some, scratch, out);
    const auto period = static_cast<double>(frame) * r;
    for (std::size_t q = 0; q < pairs.size(); ++q) {
      for (int lag = -static_cast<int>(half); lag <= static_cast<int>(half); ++lag) {
        double sum = 0;
        for (std::size_t k = 0; k < bins; ++k) {
          const std::complex<double> a(re[pairs[q].i][k], im[pairs[q].i][k]);
          const std::complex<double> b(re[pairs[q].j][k], im[pairs[q].j][k]);
          const double angle = 2 * std::numbers::pi * static_cast<double>(k) * lag / period;
          const bool once = k == 0 || (k == bins - 1 && r == 1);
          sum += (once ? 1 : 2) * (a * std::conj(b) * std::polar(1.0, angle)).real();
        }
        EXPECT_NEAR(out[q][static_cast<std::size_t>(static_cast<int>(half) + lag)],
                    sum / static_cast<double>(frame), 2e-5)
            << kernel_target() << ": pair " << q << " lag " << lag << " of frame " << frame;
      }
    }
  }
}

TEST_P(Kernels, Sliding_max_agrees_with_a_plain_loop) {
  const auto x = noise(1, 80, 80, 3);
  for (const std::size_t delta : {0U, 1U, 2U, 5U, 9U}) {
    for (const std::size_t last : {10U, 17U, 40U}) {
      std::vector<float> y(80, -100.F);
      sliding_max(x[0].data(), 10, last, delta, y.data());
      for (std::size_t n = 10; n <= last; ++n) {
        float best = -10;
        for (std::size_t k = n - delta; k <= n + delta; ++k) best = std::max(best, x[0][k]);
        EXPECT_EQ(y[n], best) << kernel_target();
      }
      for (std::size_t n = 0; n < 10; ++n) EXPECT_EQ(y[n], -100.F) << "untouched before the first";
    }
  }
}

TEST_P(Kernels, Gather_sums_agree_with_a_plain_loop_to_the_last_bit) {
  std::mt19937 random(4);
  for (const std::size_t candidates : {8U, 24U, 32U, 40U, 168U}) {
    const std::size_t pairs = 21;
    const auto x = noise(pairs, 50, 50, 5);
    std::vector<const float*> rows;
    Grid<std::uint16_t> columns(pairs, candidates);
    for (std::size_t q = 0; q < pairs; ++q) {
      rows.push_back(x[q].data());
      for (auto& c : columns[q]) c = static_cast<std::uint16_t>(random() % 50);
    }
    std::vector<float> sums(candidates);
    gather_sums(rows, columns, sums);
    for (std::size_t c = 0; c < candidates; ++c) {
      float sum = 0;
      for (std::size_t q = 0; q < pairs; ++q) sum += x[q][columns[q][c]];
      EXPECT_EQ(sums[c], sum) << kernel_target();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, Kernels, ::testing::ValuesIn(hwy::SupportedAndGeneratedTargets()),
                         [](const auto& target) { return std::string(hwy::TargetName(target.param)); });

}  // namespace
}  // namespace odas::kernels_test
