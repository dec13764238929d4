// SPDX-License-Identifier: MIT
#include "odas/dsp/noise_field.hpp"

#include <cmath>
#include <complex>
#include <limits>

#include "support/allocation_counter.hpp"
#include "support/machine_noise.hpp"
#include <gtest/gtest.h>

namespace odas::noise_field_test {
namespace {

using test::Machine;
using Complex = std::complex<double>;
constexpr std::size_t kMics = Machine::kMics;

/// x of A x = b, A Hermitian and positive.
std::vector<Complex> solve(GridView<const cfloat> matrix, std::vector<Complex> b) {
  std::vector<std::vector<Complex>> a(kMics);
  for (std::size_t i = 0; i < kMics; ++i) a[i].assign(matrix[i].begin(), matrix[i].end());
  for (std::size_t p = 0; p < kMics; ++p) {
    for (std::size_t i = p + 1; i < kMics; ++i) {
      const Complex f = a[i][p] / a[p][p];
      for (std::size_t j = p; j < kMics; ++j) a[i][j] -= f * a[p][j];
      b[i] -= f * b[p];
    }
  }
  for (std::size_t i = kMics; i-- > 0;) {
    for (std::size_t j = i + 1; j < kMics; ++j) b[i] -= a[i][j] * b[j];
    b[i] /= a[i][i];
  }
  return b;
}

/// By how much an MVDR towards the talker lowers a fan, dB, mean over the bins that tell something: the
/// weights from the field, or those of delay-and-sum.
double fan_lowered_db(const NoiseField* field, int fan) {
  Machine machine(99);
  std::vector<Grid<cfloat>> noise;
  for (int h = 0; h < 100; ++h) noise.push_back(machine.hop(fan));
  double sum = 0;
  int bins = 0;
  for (std::size_t k = 8; k < 112; ++k, ++bins) {
    std::vector<Complex> steering;
    for (std::size_t m = 0; m < kMics; ++m) {
      steering.push_back(test::phase_at(Machine::array(), m, Machine::talker(), k));
    }
    std::vector<Complex> w = field == nullptr ? steering : solve(field->scm(k), steering);
    Complex towards{};
    for (std::size_t m = 0; m < kMics; ++m) towards += std::conj(steering[m]) * w[m];
    double before = 0;
    double after = 0;
    for (const Grid<cfloat>& x : noise) {
      Complex y{};
      for (std::size_t m = 0; m < kMics; ++m) y += std::conj(w[m] / towards) * Complex(x[m][k]);
      before += std::norm(Complex(x[0][k]));
      after += std::norm(y);
    }
    sum += 10 * std::log10(before / after);
  }
  return sum / bins;
}

TEST(NoiseField, nulls_a_fan_from_the_first_hop_and_another_that_starts) {
  const NoiseDictionary dictionary = Machine::dictionary();
  ASSERT_EQ(dictionary.entries.size(), 2U);
  NoiseField field(dictionary);
  Machine machine;
  for (const int fan : {0, 1, 0}) {
    for (int h = 0; h < 20; ++h) field.update(machine.hop(fan), false);  // 0.16 s
    const double without = fan_lowered_db(nullptr, fan);
    EXPECT_GT(fan_lowered_db(&field, fan), without + 8) << fan;
    EXPECT_TRUE(field.heard_noise());
  }
}

TEST(NoiseField, learns_nothing_from_a_talker) {
  NoiseField field(Machine::dictionary());
  Machine machine;
  for (int h = 0; h < 50; ++h) field.update(machine.hop(0), false);
  const double before = fan_lowered_db(&field, 0);
  std::vector<cfloat> scm(field.scm(50)[0].begin(), field.scm(50)[0].end());
  // Not yet followed in the first half second, then followed.
  for (int h = 0; h < 500; ++h) field.update(machine.hop(0, 1, 1), h > 60);
  EXPECT_FALSE(field.heard_noise());
  EXPECT_NEAR(fan_lowered_db(&field, 0), before, 1.5);
}

TEST(NoiseField, hears_its_noise_although_it_is_followed_as_if_it_were_somebody) {
  NoiseField field(Machine::dictionary());
  Machine machine;
  int heard = 0;
  for (int h = 0; h < 200; ++h) {
    field.update(machine.hop(1), true);
    heard += field.heard_noise() ? 1 : 0;
  }
  EXPECT_GT(heard, 180);
  EXPECT_GT(fan_lowered_db(&field, 1), fan_lowered_db(nullptr, 1) + 8);
}

TEST(NoiseField, follows_the_level) {
  NoiseField field(Machine::dictionary());
  Machine machine;
  const float before = field.scm(40)[0][0].real();
  for (int h = 0; h < 250; ++h) field.update(machine.hop(0, 10), false);
  EXPECT_NEAR(field.scm(40)[0][0].real() / before, 100, 40);
}

TEST(NoiseField, has_columns_whose_squares_are_the_covariance) {
  const NoiseField field(Machine::dictionary());
  for (const std::size_t k : {0U, 77U, 128U}) {
    for (std::size_t i = 0; i < kMics; ++i) {
      for (std::size_t j = 0; j < kMics; ++j) {
        cfloat sum{};
        for (std::size_t c = 0; c < kMics; ++c)
          sum += field.column(c)[i][k] * std::conj(field.column(c)[j][k]);
        EXPECT_LT(std::abs(sum - field.scm(k)[i][j]), 1e-4F * field.scm(k)[0][0].real()) << k;
      }
    }
  }
}

TEST(NoiseField, changes_nothing_for_silence_and_what_is_not_finite) {
  NoiseField field(Machine::dictionary());
  const cfloat before = field.scm(30)[1][2];
  Grid<cfloat> x(kMics, Machine::kBins);
  field.update(x, false);
  x.fill({std::numeric_limits<float>::quiet_NaN(), 1});
  field.update(x, false);
  EXPECT_EQ(field.scm(30)[1][2], before);
}

TEST(NoiseField, is_new_after_a_reset_the_same_each_time_and_allocates_nothing) {
  NoiseField field(Machine::dictionary());
  NoiseField fresh(Machine::dictionary());
  Machine machine;
  std::vector<Grid<cfloat>> hops;
  for (int h = 0; h < 60; ++h) hops.push_back(machine.hop(h / 20 % 2));
  const auto allocations = test::allocations();
  for (const auto& x : hops) field.update(x, false);
  field.reset();
  for (const auto& x : hops) field.update(x, false);
  for (const auto& x : hops) fresh.update(x, false);
  EXPECT_EQ(test::allocations(), allocations);
  for (std::size_t k = 0; k < Machine::kBins; ++k) {
    for (std::size_t i = 0; i < kMics; ++i) EXPECT_EQ(field.scm(k)[i][0], fresh.scm(k)[i][0]);
  }
  EXPECT_EQ(field.entry(), fresh.entry());
}

}  // namespace
}  // namespace odas::noise_field_test
