// SPDX-License-Identifier: MIT
#include "odas/dsp/stft.hpp"

#include <random>

#include <gtest/gtest.h>

#include "odas/dsp/window.hpp"

namespace odas::stft_test {
namespace {

struct Sizes {
  std::size_t channels, hop, frame;
};
class StftSizes : public ::testing::TestWithParam<Sizes> {};

TEST_P(StftSizes, Synthesis_returns_the_signal_late_by_frame_minus_hop) {
  const auto [channels, hop, frame] = GetParam();
  Stft stft(channels, hop, frame);
  Istft istft(channels, hop, frame);
  Grid<cfloat> spectra(channels, stft.bins());
  Grid<float> in(channels, hop * 40);
  Grid<float> out(channels, hop * 40);
  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  for (std::size_t c = 0; c < channels; ++c) {
    for (float& x : in[c]) x = normal(random);
  }
  for (std::size_t h = 0; h < 40; ++h) {
    stft.analyse({in.data() + h * hop, channels, hop, in.cols()}, spectra);
    istft.synthesise(spectra, {out.data() + h * hop, channels, hop, out.cols()});
  }
  const std::size_t delay = frame - hop;
  for (std::size_t c = 0; c < channels; ++c) {
    for (std::size_t n = frame; n + frame < in.cols(); ++n) {
      ASSERT_NEAR(out[c][n + delay], in[c][n], 2e-5) << "channel " << c << " sample " << n;
    }
  }
}

TEST_P(StftSizes, Reset_gives_the_state_after_construction) {
  const auto [channels, hop, frame] = GetParam();
  Stft used(channels, hop, frame);
  Stft fresh(channels, hop, frame);
  Grid<float> noise(channels, hop);
  std::mt19937 random(5);
  for (std::size_t c = 0; c < channels; ++c) {
    for (float& x : noise[c]) x = static_cast<float>(random() % 1000) / 1000;
  }
  Grid<cfloat> a(channels, used.bins());
  Grid<cfloat> b(channels, used.bins());
  for (int i = 0; i < 5; ++i) used.analyse(noise, a);
  used.reset();
  used.analyse(noise, a);
  fresh.analyse(noise, b);
  for (std::size_t c = 0; c < channels; ++c) {
    EXPECT_TRUE(std::equal(a[c].begin(), a[c].end(), b[c].begin()));
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, StftSizes,
                         ::testing::Values(Sizes{1, 128, 256}, Sizes{4, 128, 256}, Sizes{2, 128, 512},
                                           Sizes{3, 100, 256}, Sizes{2, 441, 1024}, Sizes{1, 160, 512}));

TEST(Istft, An_empty_channel_rings_out_and_then_is_silent) {
  Stft stft(1, 128, 256);
  Istft istft(1, 128, 256);
  Grid<cfloat> spectra(1, 129);
  Grid<float> hop(1, 128);
  std::fill(hop[0].begin(), hop[0].end(), 1.F);
  stft.analyse(hop, spectra);
  istft.synthesise(spectra, hop);
  spectra.fill({});
  istft.synthesise(spectra, hop);
  EXPECT_GT(*std::max_element(hop[0].begin(), hop[0].end()), 0.1F);
  for (int i = 0; i < 3; ++i) istft.synthesise(spectra, hop);
  EXPECT_EQ(*std::max_element(hop[0].begin(), hop[0].end()), 0.F);
}

}  // namespace
}  // namespace odas::stft_test
