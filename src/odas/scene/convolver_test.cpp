// SPDX-License-Identifier: MIT
#include "odas/scene/convolver.hpp"

#include <gtest/gtest.h>

#include "odas/scene/random.hpp"

namespace odas::convolver_test {
namespace {

TEST(Convolver, Pieces_sum_to_the_plain_convolution) {
  constexpr std::size_t kPiece = 37;
  constexpr std::size_t kResponse = 23;
  Random random(3);
  std::vector<float> sound(150);
  for (float& x : sound) x = random.uniform();
  Grid<float> responses(2, kResponse);
  for (std::size_t m = 0; m < 2; ++m) {
    for (float& h : responses[m]) h = random.uniform();
  }
  Convolver convolver(2, kPiece, kResponse);
  convolver.set_responses(responses.view());
  Grid<float> out(2, 160);  // shorter than the whole convolution: its end is lost
  for (std::size_t start = 0; start < sound.size(); start += kPiece) {
    convolver.add(std::span(sound).subspan(start, std::min(kPiece, sound.size() - start)), start, out.view());
  }
  for (std::size_t m = 0; m < 2; ++m) {
    for (std::size_t n = 0; n < out.cols(); ++n) {
      double expected = 0;
      for (std::size_t k = 0; k < kResponse && k <= n; ++k) {
        if (n - k < sound.size()) expected += static_cast<double>(responses[m][k]) * sound[n - k];
      }
      EXPECT_NEAR(out[m][n], expected, 1e-4);
    }
  }
}

}  // namespace
}  // namespace odas::convolver_test
