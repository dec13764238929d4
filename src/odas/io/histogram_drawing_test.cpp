// SPDX-License-Identifier: MIT
#include "odas/io/histogram_drawing.hpp"

#include <gtest/gtest.h>

namespace odas::histogram_drawing_test {
namespace {

TEST(HistogramDrawing, shows_both_histograms_the_mixtures_and_where_they_part) {
  Heard silence, talk;
  for (int i = 0; i < 1000; ++i) {
    silence.strongest.add(0.05 + 0.00003 * i);
    talk.strongest.add(0.2 + 0.0002 * i);
  }
  const MeasuredMixtures found{{{1, 0.3F, 0.003F}}, {{1, 0.06F, 0.0002F}}, 1};
  SvgCanvas canvas(kHistogramWidth, kHistogramHeight);
  draw_histograms(canvas, "Kitchen", silence, talk, found, 0.123);
  const std::string text = canvas.document();
  for (const char* piece : {">Kitchen<", ">told apart at 0.123<", ">0.10<", "<polyline", "<polygon"}) {
    EXPECT_NE(text.find(piece), std::string::npos) << piece;
  }
  EXPECT_EQ(text.find("nan"), std::string::npos);
}

TEST(HistogramDrawing, draws_what_there_is_where_nothing_was_found) {
  SvgCanvas canvas(kHistogramWidth, kHistogramHeight);
  draw_histograms(canvas, "Nothing", {}, {}, {}, 0);
  EXPECT_EQ(canvas.document().find("told apart"), std::string::npos);
  EXPECT_EQ(canvas.document().find("nan"), std::string::npos);
}

}  // namespace
}  // namespace odas::histogram_drawing_test
