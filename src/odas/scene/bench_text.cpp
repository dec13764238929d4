// SPDX-License-Identifier: MIT
#include "odas/scene/bench_text.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

namespace odas {
namespace {

using nlohmann::ordered_json;

std::string number(double value, int decimals) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

std::string cell(const std::optional<Estimate>& figure, int decimals) {
  if (!figure) return "-";
  std::string text = number(figure->value, decimals);
  if (figure->scenes < 2) return text;
  return text + " (" + number(figure->low, decimals) + ", " + number(figure->high, decimals) + ")";
}

double thousandths(double value) { return std::round(value * 1000) / 1000; }

ordered_json scene_json(const BenchOutcome& outcome, std::span<const BenchFigure> figures) {
  const BenchScene& s = outcome.scene;
  ordered_json out{{"scene", s.name()},
                   {"array", s.array},
                   {"mics", s.mics},
                   {"rt60", thousandths(static_cast<double>(s.rt60))},
                   {"distance", s.distance},
                   {"noise", name_of(s.noise)},
                   {"snr_db", s.snr_db},
                   {"talkers", s.talkers},
                   {"motion", name_of(s.motion)},
                   {"inexact", s.inexact}};
  for (const BenchFigure& figure : figures) {
    const auto value = figure.of(outcome);
    out[figure.key] = value ? ordered_json(thousandths(*value)) : ordered_json(nullptr);
  }
  return out;
}

}  // namespace

std::string bench_markdown(std::span<const BenchTable> tables, std::span<const BenchFigure> figures) {
  std::string text;
  for (const BenchTable& table : tables) {
    if (!text.empty()) text += '\n';
    text += "| " + table.condition + " | scenes |";
    for (const BenchFigure& figure : figures) text += " " + figure.title + " |";
    text += "\n|---|---|";
    for (std::size_t i = 0; i < figures.size(); ++i) text += "---|";
    text += '\n';
    for (const BenchRow& row : table.rows) {
      text += "| " + row.name + " | " + std::to_string(row.scenes) + " |";
      for (std::size_t i = 0; i < figures.size(); ++i)
        text += " " + cell(row.figures[i], figures[i].decimals) + " |";
      text += '\n';
    }
  }
  return text;
}

std::string bench_json(std::span<const BenchOutcome> outcomes, std::span<const BenchTable> tables,
                       std::span<const BenchFigure> figures) {
  ordered_json out;
  out["scenes"] = ordered_json::array();
  for (const BenchOutcome& outcome : outcomes) out["scenes"].push_back(scene_json(outcome, figures));
  out["tables"] = ordered_json::array();
  for (const BenchTable& table : tables) {
    ordered_json rows = ordered_json::array();
    for (const BenchRow& row : table.rows) {
      ordered_json entry{{"name", row.name}, {"scenes", row.scenes}};
      for (std::size_t i = 0; i < figures.size(); ++i) {
        const auto& figure = row.figures[i];
        entry[figures[i].key] = figure ? ordered_json{thousandths(figure->value), thousandths(figure->low),
                                                      thousandths(figure->high)}
                                       : ordered_json(nullptr);
      }
      rows.push_back(std::move(entry));
    }
    out["tables"].push_back({{"condition", table.condition}, {"rows", std::move(rows)}});
  }
  return out.dump() + "\n";
}

}  // namespace odas
