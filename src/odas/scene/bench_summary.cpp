// SPDX-License-Identifier: MIT
#include "odas/scene/bench_summary.hpp"

#include <algorithm>
#include <numeric>

#include "odas/scene/random.hpp"

namespace odas {
namespace {

double middle_of(std::vector<double> values, Middle middle) {
  if (middle == Middle::median) return *median(std::move(values));
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::optional<double> in_percent(std::optional<double> share) {
  return share ? std::optional(100 * *share) : std::nullopt;
}

/// "0.4 s" for a level; sorts as the levels do.
struct Level {
  double order = 0;
  std::string name;
  friend auto operator<=>(const Level&, const Level&) = default;
};
using LevelOf = std::function<Level(const BenchScene&)>;

std::string print(double value, const char* unit) {
  std::string text = std::to_string(value);
  text.erase(text.find('.') + 2);
  if (text.ends_with(".0")) text.erase(text.size() - 2);
  return text + unit;
}

BenchTable table_of(const std::string& condition, std::span<const BenchOutcome> outcomes,
                    std::span<const BenchFigure> figures, const LevelOf& level_of) {
  std::vector<Level> levels;
  for (const BenchOutcome& outcome : outcomes) levels.push_back(level_of(outcome.scene));
  std::vector<Level> different = levels;
  std::ranges::stable_sort(different);
  different.erase(std::unique(different.begin(), different.end()), different.end());
  BenchTable table{condition, {}};
  for (const Level& level : different) {
    BenchRow row{level.name, 0, {}};
    row.scenes = static_cast<std::size_t>(std::ranges::count(levels, level));
    for (const BenchFigure& figure : figures) {
      std::vector<double> values;
      for (std::size_t i = 0; i < outcomes.size(); ++i) {
        if (levels[i] != level) continue;
        if (const auto value = figure.of(outcomes[i])) values.push_back(*value);
      }
      row.figures.push_back(estimate(values, figure.middle));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

std::optional<Estimate> estimate(std::span<const double> values, Middle middle) {
  constexpr std::size_t kResamples = 1000;
  if (values.empty()) return std::nullopt;
  Estimate result;
  result.scenes = values.size();
  result.value = middle_of({values.begin(), values.end()}, middle);
  Random random(1);
  std::vector<double> resampled(kResamples);
  std::vector<double> drawn(values.size());
  for (double& value : resampled) {
    for (double& x : drawn) x = values[random.below(values.size())];
    value = middle_of(drawn, middle);
  }
  std::ranges::sort(resampled);
  result.low = resampled[kResamples * 25 / 1000];
  result.high = resampled[kResamples * 975 / 1000 - 1];
  return result;
}

std::vector<BenchFigure> accuracy_figures() {
  using O = BenchOutcome;
  return {
      {"recall", "recall, %", 1, Middle::mean,
       [](const O& o) { return in_percent(o.score.azimuth.tracks.recall); }},
      {"recall_3d", "recall 3-D, %", 1, Middle::mean,
       [](const O& o) { return in_percent(o.score.angle.tracks.recall); }},
      {"err", "error, deg", 2, Middle::mean, [](const O& o) { return o.score.azimuth.tracks.error_deg; }},
      {"bound", "bound, deg", 2, Middle::median,
       [](const O& o) { return o.bound ? std::optional(o.bound->azimuth_deg) : std::nullopt; }},
      {"err_3d", "error 3-D, deg", 2, Middle::mean,
       [](const O& o) { return o.score.angle.tracks.error_deg; }},
      {"bound_3d", "bound 3-D, deg", 2, Middle::median,
       [](const O& o) { return o.bound ? std::optional(o.bound->angle_deg) : std::nullopt; }},
      {"false_s", "false, s/min", 1, Middle::mean,
       [](const O& o) { return std::optional(o.score.azimuth.tracks.false_s_per_min); }},
      {"dup", "second tracks", 3, Middle::mean, [](const O& o) { return o.score.azimuth.tracks.duplicates; }},
      {"switches", "switches/min", 1, Middle::mean,
       [](const O& o) { return o.score.azimuth.tracks.switches_per_min; }},
      {"switches_apart", "switches apart/min", 1, Middle::mean,
       [](const O& o) { return o.score.azimuth.tracks.switches_apart_per_min; }},
      {"onset_s", "onset, s", 2, Middle::median, [](const O& o) { return o.score.azimuth.tracks.onset_s; }},
      {"pot_in15", "potential in 15, %", 1, Middle::mean,
       [](const O& o) { return in_percent(o.score.azimuth.potentials.hits); }},
      {"ospa", "OSPA, deg", 1, Middle::mean,
       [](const O& o) { return std::optional(o.score.azimuth.ospa_deg); }}};
}

std::vector<BenchFigure> separation_figures() {
  using O = BenchOutcome;
  using S = SeparationScore;
  const auto db = [](const std::string& key, const std::string& title, auto which, auto member) {
    return BenchFigure{key, title + ", dB", 1, Middle::mean, [which, member](const O& o) {
                         const auto& voices = o.score.*which;
                         return voices ? std::optional<double>((*voices).*member) : std::nullopt;
                       }};
  };
  const auto share = [](const std::string& key, const std::string& title, auto which, auto member) {
    return BenchFigure{key, title + ", %", 1, Middle::mean, [which, member](const O& o) {
                         const auto& voices = o.score.*which;
                         return voices ? in_percent((*voices).*member) : std::nullopt;
                       }};
  };
  const auto separated = &Score::separated, filtered = &Score::postfiltered;
  return {{"recall", "recall, %", 1, Middle::mean,
           [](const O& o) { return in_percent(o.score.azimuth.tracks.recall); }},
          db("sdr_in", "SDR in", separated, &S::sdr_in),
          db("sdr", "SDR", separated, &S::sdr),
          db("pf_sdr", "SDR filtered", filtered, &S::sdr),
          {"irm_sdr", "SDR ideal mask, dB", 1, Middle::mean, [](const O& o) { return o.ideal_mask_sdr_db; }},
          {"mvdr_sdr", "SDR ideal MVDR, dB", 1, Middle::mean,
           [](const O& o) { return o.ideal_beamformer_sdr_db; }},
          db("si_sdr_in", "SI-SDR in", separated, &S::si_sdr_in),
          db("si_sdr", "SI-SDR", separated, &S::si_sdr),
          db("pf_si_sdr", "SI-SDR filtered", filtered, &S::si_sdr),
          db("sir_in", "SIR in", separated, &S::sir_in),
          db("sir", "SIR", separated, &S::sir),
          db("pf_sir", "SIR filtered", filtered, &S::sir),
          share("stoi_in", "STOI in", separated, &S::stoi_in),
          share("stoi", "STOI", separated, &S::stoi),
          share("pf_stoi", "STOI filtered", filtered, &S::stoi)};
}

std::vector<BenchTable> tables_of(std::span<const BenchOutcome> outcomes,
                                  std::span<const BenchFigure> figures) {
  std::vector<std::string> groups;
  for (const BenchOutcome& outcome : outcomes) {
    if (std::ranges::find(groups, outcome.scene.group) == groups.end()) groups.push_back(outcome.scene.group);
  }
  const auto group_level = [&](const BenchScene& scene) {
    return Level{static_cast<double>(std::ranges::find(groups, scene.group) - groups.begin()), scene.group};
  };
  std::vector<BenchTable> tables;
  tables.push_back(table_of("group", outcomes, figures, group_level));
  if (groups.size() > 1) {
    std::vector<BenchOutcome> others;
    for (const BenchOutcome& o : outcomes) {
      if (o.scene.group != groups.front()) others.push_back(o);
    }
    tables.push_back(table_of("group and microphones", others, figures, [&](const BenchScene& s) {
      return Level{group_level(s).order * 100 + s.mics, s.group + ", " + std::to_string(s.mics)};
    }));
  }
  std::vector<BenchOutcome> mixed;
  for (const BenchOutcome& outcome : outcomes) {
    if (outcome.scene.group == groups.front()) mixed.push_back(outcome);
  }
  const auto add = [&](const std::string& condition, const LevelOf& level) {
    BenchTable table = table_of(groups.front() + ", by " + condition, mixed, figures, level);
    if (table.rows.size() > 1) tables.push_back(std::move(table));
  };
  using S = BenchScene;
  const auto number = [](float x) { return static_cast<double>(x); };
  add("array", [&](const S& s) { return Level{number(static_cast<float>(s.mics)), s.array}; });
  add("rt60", [&](const S& s) { return Level{number(s.rt60), print(number(s.rt60), " s")}; });
  add("distance", [&](const S& s) { return Level{number(s.distance), print(number(s.distance), " m")}; });
  add("noise", [&](const S& s) { return Level{static_cast<double>(s.noise), name_of(s.noise)}; });
  add("SNR", [&](const S& s) { return Level{-number(s.snr_db), print(number(s.snr_db), " dB")}; });
  add("talkers", [](const S& s) { return Level{static_cast<double>(s.talkers), std::to_string(s.talkers)}; });
  add("motion", [](const S& s) { return Level{static_cast<double>(s.motion), name_of(s.motion)}; });
  add("microphones", [](const S& s) {
    return Level{s.inexact ? 1.0 : 0.0, s.inexact ? "2 mm, 3 dB off" : "exact"};
  });
  return tables;
}

}  // namespace odas
