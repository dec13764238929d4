// SPDX-License-Identifier: MIT
#include "odas/dsp/resampler.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace odas::resampler_test {
namespace {

using Signal = std::vector<std::vector<float>>;  // [channel][sample]

/// The whole of `input` through the resampler, in blocks.
Signal resample(Resampler& resampler, const Signal& input, std::size_t block, std::size_t hop) {
  Signal output(input.size());
  Grid<float> out(input.size(), hop);
  const auto take = [&](std::size_t n) {
    for (std::size_t c = 0; c < output.size(); ++c) {
      output[c].insert(output[c].end(), out[c].begin(), out[c].begin() + static_cast<std::ptrdiff_t>(n));
    }
  };
  for (std::size_t at = 0; at < input[0].size(); at += block) {
    const std::size_t n = std::min(block, input[0].size() - at);
    Grid<float> in(input.size(), n);
    for (std::size_t c = 0; c < input.size(); ++c) {
      std::copy_n(input[c].begin() + static_cast<std::ptrdiff_t>(at), n, in[c].begin());
    }
    resampler.push(in);
    while (resampler.pop(out)) take(hop);
  }
  resampler.finish();
  while (resampler.pop(out)) take(hop);
  take(resampler.pop_rest(out));
  return output;
}

std::vector<float> sine(double frequency, int rate, std::size_t size, double phase = 0) {
  std::vector<float> x(size);
  for (std::size_t i = 0; i < size; ++i) {
    x[i] = static_cast<float>(
        std::sin(2 * std::numbers::pi * frequency * static_cast<double>(i) / rate + phase));
  }
  return x;
}

/// Largest difference, but for the ends where the filter sees the edge of the signal.
double worst(const std::vector<float>& a, const std::vector<float>& b, std::size_t margin) {
  double most = 0;
  for (std::size_t i = margin; i + margin < std::min(a.size(), b.size()); ++i) {
    most = std::max(most, static_cast<double>(std::fabs(a[i] - b[i])));
  }
  return most;
}

struct Rates {
  int in, out;
};
class ResamplerBetween : public testing::TestWithParam<Rates> {};

TEST_P(ResamplerBetween, keeps_the_length_and_a_sine_stays_a_sine_without_delay) {
  const auto [in, out] = GetParam();
  Resampler resampler(2, in, out, 100, 128);
  const std::size_t size = static_cast<std::size_t>(in) / 5 + 17;
  const Signal output = resample(resampler, {sine(997, in, size), sine(440, in, size, 1)}, 100, 128);
  const auto expected_size =
      static_cast<std::size_t>(std::llround(static_cast<double>(size) * out / static_cast<double>(in)));
  ASSERT_EQ(output[0].size(), expected_size);
  EXPECT_LT(worst(output[0], sine(997, out, expected_size), 300), 1e-4);
  EXPECT_LT(worst(output[1], sine(440, out, expected_size, 1), 300), 1e-4);
}

TEST_P(ResamplerBetween, holds_back_no_more_than_its_lookahead) {
  const auto [in, out] = GetParam();
  const std::size_t block = 160;
  const std::size_t hop = 32;
  Resampler resampler(1, in, out, block, hop);
  const Grid<float> silence(1, block);
  Grid<float> hops(1, hop);
  std::size_t taken = 0;
  std::size_t given = 0;
  for (int i = 0; i < 50; ++i) {
    resampler.push(silence);
    taken += block;
    while (resampler.pop(hops)) given += hop;
    const double ratio = static_cast<double>(out) / in;
    const double due = (static_cast<double>(taken) - static_cast<double>(resampler.lookahead())) * ratio;
    EXPECT_GE(static_cast<double>(given), due - static_cast<double>(hop) - 2) << "after " << taken;
  }
}

INSTANTIATE_TEST_SUITE_P(Resampler, ResamplerBetween,
                         testing::Values(Rates{16000, 16000}, Rates{48000, 16000}, Rates{44100, 16000},
                                         Rates{16000, 44100}, Rates{16000, 48000}, Rates{8000, 16000}),
                         [](const auto& rates) {
                           return std::to_string(rates.param.in) + "_to_" + std::to_string(rates.param.out);
                         });

TEST(Resampler, suppresses_what_would_alias_by_100_dB) {
  Resampler resampler(1, 48000, 16000, 480, 128);
  const std::vector<float> output = resample(resampler, {sine(10000, 48000, 24000)}, 480, 128)[0];
  double power = 0;
  for (std::size_t i = 500; i < 7500; ++i) power += static_cast<double>(output[i]) * output[i] / 7000;
  EXPECT_LT(10 * std::log10(power / 0.5), -100);
}

RC_GTEST_PROP(Resampler, at_equal_rates_gives_the_very_samples_in_other_blocks, ()) {
  const auto block = *rc::gen::inRange<std::size_t>(1, 40);
  const auto hop = *rc::gen::inRange<std::size_t>(1, 40);
  const auto size = *rc::gen::inRange<std::size_t>(1, 300);
  Resampler resampler(2, 16000, 16000, block, hop);
  Signal input(2, std::vector<float>(size));
  for (std::size_t i = 0; i < size; ++i) {
    input[0][i] = static_cast<float>(i);
    input[1][i] = -static_cast<float>(i);
  }
  RC_ASSERT(resample(resampler, input, block, hop) == input);
}

TEST(Resampler, does_not_depend_on_the_size_of_its_blocks) {
  const Signal input{sine(1234, 44100, 5000)};
  Resampler small(1, 44100, 16000, 7, 128);
  Resampler large(1, 44100, 16000, 1024, 128);
  const Signal a = resample(small, input, 7, 128);
  const Signal b = resample(large, input, 1024, 128);
  ASSERT_EQ(a[0].size(), b[0].size());
  EXPECT_LT(worst(a[0], b[0], 0), 1e-6);
}

TEST(Resampler, is_new_after_reset) {
  const Signal input{sine(1234, 44100, 5000)};
  Resampler resampler(1, 44100, 16000, 64, 128);
  const Signal first = resample(resampler, input, 64, 128);
  resampler.reset();
  EXPECT_EQ(resample(resampler, input, 64, 128), first);
}

}  // namespace
}  // namespace odas::resampler_test
