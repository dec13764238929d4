// SPDX-License-Identifier: MIT
#include "odas/dsp/resampler.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace odas {
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
  const std::size_t expected_size =
      (size * static_cast<std::size_t>(out) + static_cast<std::size_t>(in) - 1) /
      static_cast<std::size_t>(in);
  ASSERT_EQ(output[0].size(), expected_size);
  const std::size_t edge =
      (resampler.lookahead() + 1) * static_cast<std::size_t>(out) / static_cast<std::size_t>(in) + 1;
  EXPECT_LT(worst(output[0], sine(997, out, expected_size), edge), 1e-5);
  EXPECT_LT(worst(output[1], sine(440, out, expected_size, 1), edge), 1e-5);
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
                                         Rates{16000, 44100}, Rates{16000, 48000}, Rates{8000, 16000},
                                         Rates{16000, 16001}, Rates{44101, 16000}, Rates{8000, 192000},
                                         Rates{192000, 8000}),
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

TEST(Resampler, keeps_the_level_to_84_percent_of_the_lower_nyquist_frequency) {
  for (const auto& [in, out] : {Rates{48000, 16000}, Rates{16000, 44100}}) {
    Resampler resampler(1, in, out, 480, 128);
    const std::vector<float> output = resample(resampler, {sine(6700, in, 24000)}, 480, 128)[0];
    EXPECT_LT(worst(output, sine(6700, out, output.size()), 300), 1e-3) << in;
  }
}

TEST(Resampler, leaves_no_images_when_the_rate_rises) {
  Resampler resampler(1, 16000, 48000, 480, 128);
  const std::vector<float> output = resample(resampler, {sine(6000, 16000, 8000)}, 480, 128)[0];
  const std::vector<float> expected = sine(6000, 48000, output.size());
  double power = 0;
  for (std::size_t i = 500; i < 23000; ++i) {
    power += std::pow(static_cast<double>(output[i] - expected[i]), 2) / 22500;
  }
  EXPECT_LT(10 * std::log10(power / 0.5), -95);
}

TEST(Resampler, does_not_depend_on_the_size_of_its_blocks) {
  const Signal input{sine(1234, 44100, 5000)};
  Resampler small(1, 44100, 16000, 7, 128);
  Resampler large(1, 44100, 16000, 1024, 128);
  const Signal a = resample(small, input, 7, 128);
  const Signal b = resample(large, input, 1024, 128);
  EXPECT_EQ(a, b);
}

TEST(Resampler, gives_exact_silence_for_a_silent_channel_and_the_others_as_if_alone) {
  Signal input{sine(1234, 16000, 8000), std::vector<float>(8000), sine(500, 16000, 8000)};
  std::fill(input[2].begin() + 2000, input[2].begin() + 5000, 0.0F);
  Resampler together(3, 16000, 44100, 128, 512);
  const Signal output = resample(together, input, 128, 512);
  for (std::size_t c = 0; c < 3; ++c) {
    Resampler one(1, 16000, 44100, 8000, 512);  // in one block, so that no part of it is silent
    EXPECT_EQ(resample(one, {input[c]}, 8000, 512)[0], output[c]) << c;
  }
  EXPECT_EQ(output[1], std::vector<float>(output[1].size()));
}

TEST(Resampler, is_new_after_reset) {
  const Signal input{sine(1234, 44100, 5000)};
  Resampler resampler(1, 44100, 16000, 64, 128);
  const Signal first = resample(resampler, input, 64, 128);
  resampler.reset();
  EXPECT_EQ(resample(resampler, input, 64, 128), first);
}

}  // namespace
}  // namespace odas
