// SPDX-License-Identifier: MIT
#include "odas/io/interval_chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace odas {
namespace {

constexpr std::array kInks{Ink{0.1, 0.38, 0.7, 1}, Ink{0.85, 0.45, 0.1, 1}, Ink{0.2, 0.6, 0.35, 1},
                           Ink{0.6, 0.3, 0.65, 1}};

/// 1, 2 or 5 times a power of ten, so that there are about four lines.
double step_of(double top) {
  const double raw = top / 4;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (raw <= step * power) return step * power;
  }
  return 10 * power;
}

double highest(const IntervalChart& chart) {
  double top = 0;
  for (const auto& series : chart.series) {
    for (const auto& value : series.values) {
      if (value) top = std::max(top, value->high);
    }
  }
  return top > 0 ? 1.08 * top : 1;
}

/// 0, or below what is lowest.
double lowest(const IntervalChart& chart) {
  double bottom = 0;
  for (const auto& series : chart.series) {
    for (const auto& value : series.values) {
      if (value) bottom = std::min(bottom, 1.08 * value->low);
    }
  }
  return bottom;
}

}  // namespace

void draw_intervals(Canvas& canvas, const IntervalChart& chart, Spot upper_left, Spot lower_right) {
  const double left = upper_left.x + 46, right = lower_right.x - 10;
  const double top = upper_left.y + 50, bottom = lower_right.y - 34;
  const double most = chart.top.value_or(highest(chart));
  const double least = chart.top ? 0 : lowest(chart);
  const auto y = [&](double value) {
    return bottom - (bottom - top) * std::clamp((value - least) / (most - least), 0.0, 1.0);
  };

  canvas.text({upper_left.x + 8, upper_left.y + 18}, chart.title, {.size = 13, .bold = true});
  canvas.text({upper_left.x + 8, upper_left.y + 36}, chart.unit, {.size = 10, .ink = kGrey});
  const double step = step_of(most - least);
  for (double line = std::ceil(least / step) * step; line <= most * 1.001; line += step) {
    canvas.polyline(std::array{Spot{left, y(line)}, Spot{right, y(line)}}, false,
                    {.line = std::abs(line) < 1e-9 * step ? kGrey : kFaint});
    canvas.text({left - 6, y(line) + 4}, fmt::format("{:g}", std::abs(line) < 1e-9 * step ? 0 : line),
                {.size = 10, .anchor = Canvas::Anchor::right, .ink = kGrey});
  }
  const double place = (right - left) / static_cast<double>(std::max<std::size_t>(1, chart.levels.size()));
  for (std::size_t l = 0; l < chart.levels.size(); ++l) {
    canvas.text({left + place * (static_cast<double>(l) + 0.5), bottom + 16}, chart.levels[l],
                {.size = 9, .anchor = Canvas::Anchor::middle, .ink = kGrey});
  }
  double legend = right;
  for (std::size_t s = chart.series.size(); s-- > 0;) {
    const auto& series = chart.series[s];
    const Ink ink = kInks[s % kInks.size()];
    if (chart.series.size() > 1) {
      canvas.text({legend, upper_left.y + 36}, series.name,
                  {.size = 10, .anchor = Canvas::Anchor::right, .bold = true, .ink = ink});
      legend -= 14 + 6 * static_cast<double>(series.name.size());
    }
    const double beside = (static_cast<double>(s) + 1) / (static_cast<double>(chart.series.size()) + 1);
    for (std::size_t l = 0; l < series.values.size(); ++l) {
      const auto& value = series.values[l];
      if (!value) continue;
      const double x = left + place * (static_cast<double>(l) + 0.25 + 0.5 * beside);
      canvas.polyline(std::array{Spot{x, y(value->low)}, Spot{x, y(value->high)}}, false,
                      {.line = ink, .width = 1.5});
      canvas.circle({x, y(value->value)}, 3.5, {.fill = ink});
    }
  }
}

}  // namespace odas
