// SPDX-License-Identifier: MIT
#include "odas/localization/snr_weights.hpp"

#include <gtest/gtest.h>

namespace odas::snr_weights_test {
namespace {

struct Weights {
  Weights() : spectra(1, 2), noise(1, 2), re(1, 8), im(1, 8) {
    noise[0][0] = 1;
    noise[0][1] = 100;
  }
  void hop(cfloat x) {
    spectra[0][0] = spectra[0][1] = x;
    re.fill(1);
    im.fill(1);
    weights.apply(spectra, noise, re, im);
  }
  SnrWeights weights{1, 2};
  Grid<cfloat> spectra;
  Grid<float> noise, re, im;
};

TEST(SnrWeights, Follow_the_formula_of_their_source) {
  Weights w;
  w.hop({3, 4});  // |X|^2 = 25: xi = 0.1 * 25 / 1
  EXPECT_NEAR(w.re[0][0], 2.5 / 3.5, 1e-6);
  EXPECT_NEAR(w.re[0][1], 0.025 / 1.025, 1e-6);
  const double kept = (2.5 / 3.5) * (2.5 / 3.5) * 25;
  w.hop({3, 4});
  const double xi = 0.9 * kept + 2.5;
  EXPECT_NEAR(w.re[0][0], xi / (xi + 1), 1e-6);
  EXPECT_EQ(w.re[0][0], w.im[0][0]);
}

TEST(SnrWeights, Are_nearly_one_for_loud_sound_and_small_for_noise) {
  Weights w;
  for (int i = 0; i < 20; ++i) w.hop({30, 0});
  EXPECT_GT(w.re[0][0], 0.99F);
  Weights n;
  for (int i = 0; i < 20; ++i) n.hop({1, 0});
  EXPECT_LT(n.re[0][0], 0.2F);
}

TEST(SnrWeights, Stay_finite_whatever_comes) {
  Weights w;
  w.noise[0][0] = 0;
  for (const float x : {0.F, 1e30F, 0.F, 1.F}) {
    w.hop({x, 0});
    EXPECT_GE(w.re[0][0], 0);
    EXPECT_LE(w.re[0][0], 1);
  }
}

}  // namespace
}  // namespace odas::snr_weights_test
