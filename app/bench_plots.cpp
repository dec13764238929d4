// SPDX-License-Identifier: MIT
#include "bench_plots.hpp"

#include <algorithm>

#include "odas/io/interval_chart.hpp"

namespace odas {
namespace {

constexpr double kWidth = 420, kHeight = 260, kTitle = 46;
constexpr std::size_t kAcross = 3;

IntervalChart chart_of(const BenchPanel& panel, const BenchTable& table,
                       std::span<const BenchFigure> figures) {
  IntervalChart chart;
  chart.title = panel.title;
  chart.top = panel.top;
  for (const BenchRow& row : table.rows) chart.levels.push_back(row.name.substr(0, 16));
  for (const std::string& key : panel.figures) {
    const auto figure = std::ranges::find(figures, key, &BenchFigure::key);
    if (figure == figures.end()) continue;
    IntervalChart::Series series{figure->title, {}};
    if (chart.unit.empty()) chart.unit = figure->title;
    for (const BenchRow& row : table.rows) {
      const auto& value = row.figures[static_cast<std::size_t>(figure - figures.begin())];
      series.values.push_back(value ? std::optional(Interval{value->value, value->low, value->high})
                                    : std::nullopt);
    }
    chart.series.push_back(std::move(series));
  }
  if (chart.series.size() > 1) chart.unit.clear();
  return chart;
}

}  // namespace

std::string bench_svg(const std::string& title, std::span<const BenchTable> tables,
                      std::span<const BenchFigure> figures, std::span<const BenchPanel> panels) {
  std::vector<IntervalChart> charts;
  for (const BenchPanel& panel : panels) {
    const auto table = std::ranges::find(tables, panel.condition, &BenchTable::condition);
    if (table != tables.end() && !table->rows.empty()) charts.push_back(chart_of(panel, *table, figures));
  }
  const std::size_t rows = (charts.size() + kAcross - 1) / kAcross;
  SvgCanvas canvas(kWidth * kAcross, kTitle + kHeight * static_cast<double>(std::max<std::size_t>(1, rows)));
  canvas.text({16, 30}, title, {.size = 17, .bold = true});
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const double x = kWidth * static_cast<double>(i % kAcross);
    const double y = kTitle + kHeight * static_cast<double>(i / kAcross);
    draw_intervals(canvas, charts[i], {x, y}, {x + kWidth, y + kHeight});
  }
  return canvas.document();
}

std::vector<BenchPanel> accuracy_panels() {
  return {{"mixed, by SNR", "Recall by SNR", {"recall", "recall_3d"}, 100},
          {"mixed, by rt60", "Recall by reverberation", {"recall", "recall_3d"}, 100},
          {"mixed, by distance", "Recall by distance", {"recall", "recall_3d"}, 100},
          {"mixed, by array", "Recall by array", {"recall", "recall_3d"}, 100},
          {"mixed, by talkers", "Recall by talkers", {"recall", "recall_3d"}, 100},
          {"mixed, by noise", "Recall by noise", {"recall", "recall_3d"}, 100},
          {"mixed, by array", "Azimuth error and bound", {"err", "bound"}, std::nullopt},
          {"mixed, by SNR", "Azimuth error and bound", {"err", "bound"}, std::nullopt},
          {"mixed, by array", "Error in 3-D and bound", {"err_3d", "bound_3d"}, std::nullopt},
          {"mixed, by SNR", "False tracks", {"false_s"}, std::nullopt},
          {"mixed, by motion", "Changes of id", {"switches"}, std::nullopt},
          {"group", "Recall by group", {"recall"}, 100}};
}

std::vector<BenchPanel> separation_panels() {
  return {{"group", "SDR by group", {"sdr_in", "sdr", "pf_sdr", "mvdr_sdr"}, std::nullopt},
          {"group", "SI-SDR by group", {"si_sdr_in", "si_sdr", "pf_si_sdr"}, std::nullopt},
          {"group", "STOI by group", {"stoi_in", "stoi", "pf_stoi"}, 100},
          {"two, by array", "SDR of two talkers by array", {"sdr_in", "sdr", "pf_sdr"}, std::nullopt},
          {"two, by rt60", "SDR of two talkers by reverberation", {"sdr_in", "sdr", "pf_sdr"}, std::nullopt},
          {"two, by distance", "SDR of two talkers by distance", {"sdr_in", "sdr", "pf_sdr"}, std::nullopt}};
}

}  // namespace odas
