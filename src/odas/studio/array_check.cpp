// SPDX-License-Identifier: MIT
#include "odas/studio/array_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "odas/array/doa_error.hpp"
#include "odas/array/sphere_grid.hpp"
#include "odas/config/describe.hpp"
#include "odas/pipeline/pipeline.hpp"
#include "odas/studio/engine_commands.hpp"

namespace odas {

using nlohmann::json;

namespace {

constexpr int kMapLevel = 3, kTwinLevel = 2;  // of the grids for errors, and for directions that look alike
constexpr double kFar = 30;                   // degrees
constexpr std::size_t kMostTwins = 100;

json vector_json(Vec3 u) { return {u.x, u.y, u.z}; }

/// A TDoA is read off at steps of an interpolated sample: the error is even over one of them.
double tdoa_error_s(const PipelineConfig& pipeline) {
  return 1.0 / (pipeline.general.samplerate.mu * pipeline.ssl.interp_rate * std::sqrt(12.0));
}

/// From which frequency on one pair alone is ambiguous: the closest, which is the last, and the widest.
void add_aliasing(json& answer, const GeneralConfig& general) {
  float closest = std::numeric_limits<float>::infinity();
  for (const Pair& pair : all_pairs(general.mics.size())) {
    closest = std::min(closest, norm(position(general.mics[pair.i]) - position(general.mics[pair.j])));
  }
  const float widest = aperture(general.mics), c = general.speedofsound.mu;
  answer["aperture"] = widest;
  answer["aliasing_hz"] = closest > 0 && std::isfinite(closest) ? json(c / (2 * closest)) : json();
  answer["aliasing_hz_worst"] = widest > 0 ? json(c / (2 * widest)) : json();
}

void add_errors(json& answer, const PipelineConfig& pipeline) {
  const DoaError error(pipeline.general, tdoa_error_s(pipeline));
  json directions = json::array(), degrees = json::array(), twins = json::array();
  const SphereGrid fine(kMapLevel), coarse(kTwinLevel);
  for (const Vec3 u : fine.points()) {
    const auto at = error.at(u);
    directions.push_back(vector_json(u));
    degrees.push_back(at ? json(at->angle_deg()) : json());
  }
  for (const DoaError::Ambiguity& twin : error.ambiguities(coarse.points(), kFar, kMostTwins)) {
    twins.push_back({{"a", vector_json(twin.a)}, {"b", vector_json(twin.b)}, {"apart", twin.apart_deg()}});
  }
  answer["error_map"] = {{"directions", std::move(directions)}, {"degrees", std::move(degrees)}};
  answer["ambiguous"] = std::move(twins);
}

}  // namespace

json check_array(LoadedConfiguration loaded) {
  json answer{{"faults", faults_json(loaded.faults)}};
  if (!loaded.ok()) return answer;
  PipelineConfig& pipeline = loaded.config.pipeline;
  const GeneralConfig& general = pipeline.general;
  pipeline.wanted = {true, false, false, false};
  try {
    const Pipeline::Plan plan = Pipeline(pipeline).plan();
    answer["mics"] = json::array();
    for (const MicConfig& mic : general.mics) {
      answer["mics"].push_back({{"position", mic.mu}, {"direction", mic.direction}});
    }
    answer["pairs"] = plan.pairs;
    answer["pairs_used"] = plan.pairs_used;
    answer["scans"] = json::array();
    for (const Pipeline::Plan::Scan& scan : plan.scans) {
      answer["scans"].push_back(
          {{"level", scan.level}, {"points", scan.points}, {"active", scan.active_points}});
    }
    answer["flat"] = shape_of(general.mics) != ArrayShape::volume;
    answer["text"] = describe_plan(loaded.config, plan);
    add_aliasing(answer, general);
    add_errors(answer, pipeline);
  } catch (const ConfigError& error) {
    for (const json& fault : faults_json(loaded.locations.locate(error).faults()))
      answer["faults"].push_back(fault);
  }
  return answer;
}

}  // namespace odas
