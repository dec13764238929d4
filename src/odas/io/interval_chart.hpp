// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "odas/io/canvas.hpp"

namespace odas {

/// A value, and between what it may lie.
struct Interval {
  double value = 0, low = 0, high = 0;
};

/// Values side by side, each with its interval: a place a level, a colour a series.
struct IntervalChart {
  struct Series {
    std::string name;
    std::vector<std::optional<Interval>> values;  // [level]
  };
  std::string title;
  std::string unit;                 // over the vertical axis
  std::vector<std::string> levels;  // under the horizontal axis
  std::vector<Series> series;
  std::optional<double> top;  // of the axis, which begins at 0; none: all fits
};

/// Draws the chart into the rectangle.
void draw_intervals(Canvas& canvas, const IntervalChart& chart, Spot upper_left, Spot lower_right);

}  // namespace odas
