// SPDX-License-Identifier: MIT
#include "odas/separation/factor_kernels.hpp"

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace odas::factor_kernels_test {
namespace {

constexpr std::size_t kBins = 37;  // not whole blocks

using cdouble = std::complex<double>;
using Matrix = std::vector<std::vector<cdouble>>;

class Factor : public testing::TestWithParam<std::size_t> {
 protected:
  /// A positive definite matrix in each bin, and its factor.
  void SetUp() override {
    for (std::size_t k = 0; k < kBins; ++k) {
      for (std::size_t j = 0; j < mics; ++j) {
        for (std::size_t i = j; i < mics; ++i) {
          factor.set(factor_row(mics, i, j), k, i == j ? cfloat{1 + std::abs(draw()), 0} : 0.3F * random());
        }
      }
    }
    // Bins past the last are worked on as well.
    for (std::size_t k = kBins; k < factor.blocks() * kBlockBins; ++k) {
      for (std::size_t i = 0; i < mics; ++i) factor.set(factor_row(mics, i, i), k, 1);
    }
  }

  float draw() { return normal_(engine_); }
  cfloat random() { return {draw(), draw()}; }

  BinBlocks random_vectors() {
    BinBlocks v(mics, kBins);
    for (std::size_t m = 0; m < mics; ++m) {
      for (std::size_t k = 0; k < kBins; ++k) v.set(m, k, random());
    }
    return v;
  }

  [[nodiscard]] Matrix matrix(std::size_t k) const {
    Matrix r(mics, std::vector<cdouble>(mics));
    for (std::size_t i = 0; i < mics; ++i) {
      for (std::size_t j = 0; j < mics; ++j) {
        for (std::size_t n = 0; n <= std::min(i, j); ++n) {
          r[i][j] += cdouble(factor.get(factor_row(mics, i, n), k)) *
                     std::conj(cdouble(factor.get(factor_row(mics, j, n), k)));
        }
      }
    }
    return r;
  }

  std::size_t mics = GetParam();
  BinBlocks factor{factor_rows(mics), kBins};

 private:
  std::mt19937 engine_{7};
  std::normal_distribution<float> normal_;
};

TEST_P(Factor, after_an_update_is_that_of_the_sum) {
  std::vector<Matrix> expected;
  BinBlocks v = random_vectors();
  BinReals keep(kBins);
  for (std::size_t k = 0; k < kBins; ++k) {
    keep[k] = 0.5F + 0.01F * static_cast<float>(k);
    expected.push_back(matrix(k));
    for (std::size_t i = 0; i < mics; ++i) {
      for (std::size_t j = 0; j < mics; ++j) {
        expected[k][i][j] = static_cast<double>(keep[k]) * expected[k][i][j] +
                            cdouble(v.get(i, k)) * std::conj(cdouble(v.get(j, k)));
      }
    }
  }
  factor_update(factor, keep, v);
  for (std::size_t k = 0; k < kBins; ++k) {
    const Matrix found = matrix(k);
    for (std::size_t i = 0; i < mics; ++i) {
      for (std::size_t j = 0; j < mics; ++j) ASSERT_LT(std::abs(found[i][j] - expected[k][i][j]), 2e-4) << k;
    }
  }
}

TEST_P(Factor, is_loaded_at_one_microphone) {
  const std::size_t mic = mics / 2;
  const Matrix before = matrix(5);
  BinReals amplitude(kBins);
  amplitude.fill(0.7F);
  BinBlocks scratch(mics, kBins);
  factor_load(factor, amplitude, mic, scratch);
  const Matrix after = matrix(5);
  for (std::size_t i = 0; i < mics; ++i) {
    for (std::size_t j = 0; j < mics; ++j) {
      const double more = i == mic && j == mic ? 0.49 : 0;
      EXPECT_LT(std::abs(after[i][j] - before[i][j] - more), 1e-4);
    }
  }
}

TEST_P(Factor, solves_what_the_matrix_makes) {
  const BinBlocks b = random_vectors();
  BinBlocks x = b;
  BinReals norm(kBins);
  factor_forward(factor, x, norm);
  factor_backward(factor, x);
  for (std::size_t k = 0; k < kBins; ++k) {
    const Matrix r = matrix(k);
    cdouble quadratic = 0;
    for (std::size_t i = 0; i < mics; ++i) {
      cdouble sum = 0;
      for (std::size_t j = 0; j < mics; ++j) sum += r[i][j] * cdouble(x.get(j, k));
      ASSERT_LT(std::abs(sum - cdouble(b.get(i, k))), 2e-3) << k;
      quadratic += std::conj(cdouble(b.get(i, k))) * cdouble(x.get(i, k));
    }
    ASSERT_NEAR(static_cast<double>(norm[k]), quadratic.real(), 2e-3 * quadratic.real());
  }
}

TEST_P(Factor, columns_and_inner_products_are_those_of_plain_loops) {
  const BinBlocks x = random_vectors();
  BinBlocks c = random_vectors();
  const BinBlocks before = c;
  BinReals gain(kBins);
  gain.fill(0.25F);
  column_update(c, gain, x, mics - 1);
  BinBlocks inner(1, kBins);
  inner_product(before, x, inner);
  for (std::size_t k = 0; k < kBins; ++k) {
    cfloat sum = 0;
    for (std::size_t m = 0; m < mics; ++m) {
      const cfloat expected = 0.75F * before.get(m, k) + 0.25F * x.get(m, k) * std::conj(x.get(mics - 1, k));
      EXPECT_LT(std::abs(c.get(m, k) - expected), 1e-5F);
      sum += std::conj(before.get(m, k)) * x.get(m, k);
    }
    EXPECT_LT(std::abs(inner.get(0, k) - sum), 1e-4F);
  }
}

INSTANTIATE_TEST_SUITE_P(Mics, Factor, testing::Values(1U, 2U, 5U, 16U));

}  // namespace
}  // namespace odas::factor_kernels_test
