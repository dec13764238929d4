// SPDX-License-Identifier: MIT
#include "odas/dsp/window.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace odas::window_test {
namespace {

TEST(Window, Root_hann_is_symmetric_with_zero_ends) {
  for (const std::size_t size : {2U, 255U, 256U}) {
    const auto w = root_hann(size);
    EXPECT_EQ(w.front(), 0);
    EXPECT_NEAR(w.back(), 0, 1e-7);
    for (std::size_t n = 0; n < size; ++n) EXPECT_NEAR(w[n], w[size - 1 - n], 1e-6);
  }
}

TEST(Window, Synthesis_restores_a_gain_of_exactly_one) {
  struct Case {
    std::size_t frame, hop;
  };
  for (const auto [frame, hop] :
       {Case{256, 128}, Case{256, 64}, Case{256, 100}, Case{882, 441}, Case{512, 128}, Case{256, 165}}) {
    const auto w = root_hann(frame);
    const auto v = synthesis_window(w, hop);
    for (std::size_t n = 0; n < hop; ++n) {
      double gain = 0;
      for (std::size_t m = n; m < frame; m += hop)
        gain += static_cast<double>(w[m]) * static_cast<double>(v[m]);
      EXPECT_NEAR(gain, 1, 1e-6) << frame << "/" << hop << " at " << n;
    }
  }
}

TEST(Window, Synthesis_without_overlap_fades_at_the_ends_of_a_frame_and_amplifies_little) {
  const auto w = root_hann(256);
  const auto v = synthesis_window(w, 256);
  EXPECT_EQ(v.front(), 0);
  EXPECT_EQ(v.back(), 0);
  for (std::size_t n = 0; n < 256; ++n) EXPECT_LE(v[n], std::sqrt(2.F) + 1e-6F);
  for (std::size_t n = 65; n < 191; ++n) EXPECT_NEAR(w[n] * v[n], 1, 1e-6F);
}

}  // namespace
}  // namespace odas::window_test
