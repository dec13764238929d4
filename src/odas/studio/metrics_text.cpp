// SPDX-License-Identifier: MIT
#include "odas/studio/metrics_text.hpp"

#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace odas {
namespace {

struct Figure {
  const char* key;   // of the message
  const char* name;  // of Prometheus: base units
  const char* kind;  // counter or gauge
  double factor;     // to the base unit
  const char* meaning;
};

constexpr std::array kFigures{
    Figure{"hops", "odas_hops_total", "counter", 1, "Hops processed since the start of the run."},
    Figure{"hop_p50_us", "odas_hop_seconds_median", "gauge", 1e-6, "Time that a hop takes, median."},
    Figure{"hop_p99_us", "odas_hop_seconds_p99", "gauge", 1e-6, "Time that a hop takes, 99th percentile."},
    Figure{"hop_max_us", "odas_hop_seconds_max", "gauge", 1e-6, "Time that a hop takes, the longest."},
    Figure{"real_time_share", "odas_real_time_share", "gauge", 1,
           "Share of real time that the engine is busy."},
    Figure{"dropped_hops", "odas_dropped_hops_total", "counter", 1, "Hops that an output was too slow for."},
    Figure{"lost_records", "odas_lost_records_total", "counter", 1,
           "Hops and blocks that peers did not get."},
    Figure{"overruns", "odas_overruns_total", "counter", 1, "Blocks that the engine was too slow for."},
    Figure{"lost_frames", "odas_lost_frames_total", "counter", 1, "Samples of the source that were lost."},
    Figure{"clipped_samples", "odas_clipped_samples_total", "counter", 1, "Samples louder than full scale."},
    Figure{"cpu", "odas_cpu_share", "gauge", 1, "Share of one core that the process takes."},
    Figure{"rss_bytes", "odas_resident_memory_bytes", "gauge", 1, "Memory of the process."},
    Figure{"temperature", "odas_temperature_celsius", "gauge", 1, "Temperature of the machine."},
    Figure{"clients", "odas_studio_clients", "gauge", 1, "Browsers that look on."},
    Figure{"latency", "odas_latency_seconds", "gauge", 1, "From the microphones to the page's server."},
};

constexpr std::array kBeamFigures{
    Figure{"", "odas_beam_snr_decibels", "gauge", 1, "Of each beam: its talker against all else."},
    Figure{"", "odas_beam_white_noise_gain_decibels", "gauge", 1, "Of each beam, against white noise."},
    Figure{"", "odas_beam_condition_decibels", "gauge", 1, "Of the covariance that each beam is made of."},
};

std::string head_of(const Figure& figure) {
  return fmt::format("# HELP {0} {1}\n# TYPE {0} {2}\n", figure.name, figure.meaning, figure.kind);
}

std::string stage_lines(const nlohmann::json& stages) {
  if (stages.empty()) return "";
  const Figure figure{"", "odas_stage_seconds", "gauge", 1e-6, "Time that a stage takes of a hop, mean."};
  std::string text = head_of(figure);
  for (const auto& stage : stages) {
    text += fmt::format("{}{{stage=\"{}\"}} {}\n", figure.name, stage.at(0).get<std::string>(),
                        stage.at(1).get<double>() * figure.factor);
  }
  return text;
}

std::string beam_lines(const nlohmann::json& beams) {
  std::string text;
  for (std::size_t f = 0; f < kBeamFigures.size(); ++f) {
    std::string lines;
    for (const auto& beam : beams) {
      const auto& value = beam.at(2 + f);
      if (!value.is_number()) continue;
      lines += fmt::format("{}{{slot=\"{}\"}} {}\n", kBeamFigures[f].name, beam.at(0).get<int>(),
                           value.get<double>());
    }
    if (!lines.empty()) text += head_of(kBeamFigures[f]) + lines;
  }
  return text;
}

}  // namespace

std::string metrics_text(const nlohmann::json& health) {
  std::string text;
  for (const Figure& figure : kFigures) {
    const auto found = health.find(figure.key);
    if (found == health.end() || !found->is_number()) continue;
    text += head_of(figure) + fmt::format("{} {}\n", figure.name, found->get<double>() * figure.factor);
  }
  const auto nothing = nlohmann::json::array();
  return text + stage_lines(health.value("stages", nothing)) + beam_lines(health.value("beams", nothing));
}

}  // namespace odas
