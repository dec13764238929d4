// SPDX-License-Identifier: MIT
#include "odas/io/interval_chart.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace odas::interval_chart_test {
namespace {

/// Keeps what is drawn.
class Kept : public Canvas {
 public:
  void polyline(std::span<const Spot> spots, bool, const Style& style) override {
    if (style.width > 1) bars.push_back({spots.begin(), spots.end()});
  }
  void circle(Spot centre, double, const Style&) override { dots.push_back(centre); }
  void text(Spot, std::string_view what, const Font&) override { texts.emplace_back(what); }

  std::vector<std::vector<Spot>> bars;
  std::vector<Spot> dots;
  std::vector<std::string> texts;
};

IntervalChart chart() {
  return {
      "Recall",
      "%",
      {"0 dB", "10 dB"},
      {{"4", {Interval{50, 40, 60}, Interval{100, 90, 100}}}, {"16", {Interval{75, 70, 80}, std::nullopt}}},
      100};
}

TEST(IntervalChart, Higher_values_are_higher_up_and_lie_within_their_intervals) {
  Kept canvas;
  draw_intervals(canvas, chart(), {0, 0}, {300, 200});
  ASSERT_EQ(canvas.dots.size(), 3U);
  ASSERT_EQ(canvas.bars.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(canvas.bars[i][0].x, canvas.dots[i].x);
    EXPECT_GE(canvas.bars[i][0].y, canvas.dots[i].y);
    EXPECT_LE(canvas.bars[i][1].y, canvas.dots[i].y);
  }
  // The last series is drawn first: 75, 50, 100.
  EXPECT_LT(canvas.dots[2].y, canvas.dots[0].y);
  EXPECT_LT(canvas.dots[0].y, canvas.dots[1].y);
  EXPECT_NEAR(canvas.dots[0].y - canvas.dots[2].y, canvas.dots[1].y - canvas.dots[0].y, 1e-9);
}

TEST(IntervalChart, Names_its_levels_and_its_series) {
  Kept canvas;
  draw_intervals(canvas, chart(), {0, 0}, {300, 200});
  for (const char* text : {"Recall", "%", "0 dB", "10 dB", "4", "16", "100"}) {
    EXPECT_NE(std::ranges::find(canvas.texts, text), canvas.texts.end()) << text;
  }
}

TEST(IntervalChart, Stays_in_its_rectangle_whatever_the_values) {
  Kept canvas;
  IntervalChart much = chart();
  much.series[0].values[0] = Interval{5000, -20, 1e9};
  draw_intervals(canvas, much, {10, 20}, {310, 220});
  for (const auto& bar : canvas.bars) {
    for (const Spot spot : bar) {
      EXPECT_GE(spot.y, 20);
      EXPECT_LE(spot.y, 220);
    }
  }
}

}  // namespace
}  // namespace odas::interval_chart_test
