// SPDX-License-Identifier: MIT
#include "odas/scene/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "odas/base/contract.hpp"
#include "odas/scene/activity.hpp"
#include "odas/scene/convolver.hpp"
#include "odas/scene/noise.hpp"
#include "odas/scene/room.hpp"
#include "odas/scene/trajectory.hpp"

namespace odas {
namespace {

constexpr Orders kEarly{0, 2};
constexpr Orders kLate{3, 1 << 20};
constexpr double kEarlyStep = 0.008;  // s
constexpr double kLateStep = 0.128;   // s
constexpr float kHighestPeak = 0.95F;

/// What lies under 20 Hz is no sound, but the images of a room would make much of it (room.hpp).
void block_dc(std::vector<float>& sound, int sample_rate) {
  const auto pole = static_cast<float>(std::exp(-2 * std::numbers::pi * 20 / sample_rate));
  float in = 0;
  float out = 0;
  for (float& x : sound) {
    out = x - in + pole * out;
    in = x;
    x = out;
  }
}

float farthest(const SceneSource& source) {
  float distance = 0;
  for (const Waypoint& w : source.path) distance = std::max(distance, w.distance);
  return distance;
}

Grid<float> responses_at(const Scene& scene, const Room& room, Vec3 position, Orders orders,
                         std::size_t length) {
  Grid<float> responses(scene.mics.size(), length);
  for (std::size_t m = 0; m < scene.mics.size(); ++m) {
    room.add_response(position, scene.mics[m], orders, responses[m]);
  }
  return responses;
}

void play_at_rest(const Scene& scene, const Room& room, const SceneSource& source, GridView<float> out) {
  const std::size_t length = room.response_length(farthest(source));
  const std::size_t piece = std::max<std::size_t>(4096, length);
  Convolver convolver(scene.mics.size(), piece, length);
  convolver.set_responses(responses_at(scene, room, position_at(source.path, 0), {}, length));
  const std::size_t end = std::min(source.sound.size(), out.cols());
  for (std::size_t start = 0; start < end; start += piece) {
    convolver.add(std::span(source.sound).subspan(start, std::min(piece, end - start)), start, out);
  }
}

void play_moving(const Scene& scene, const Room& room, const SceneSource& source, Orders orders,
                 double seconds_a_step, std::size_t length, GridView<float> out) {
  const auto step = static_cast<std::size_t>(seconds_a_step * scene.sample_rate);
  Convolver convolver(scene.mics.size(), 2 * step, length);
  std::vector<float> piece(2 * step);
  const std::size_t end = std::min(source.sound.size(), out.cols());
  // A triangle has its middle at `centre` and its ends a step before and behind.
  for (std::size_t centre = 0; centre < end + step; centre += step) {
    const std::size_t start = centre - std::min(centre, step);
    const std::size_t stop = std::min(end, centre + step);
    if (start >= stop) continue;
    bool silent = true;
    for (std::size_t n = start; n < stop; ++n) {
      const std::size_t off = n > centre ? n - centre : centre - n;
      piece[n - start] = source.sound[n] * (1 - static_cast<float>(off) / static_cast<float>(step));
      silent = silent && source.sound[n] == 0;
    }
    if (silent) continue;
    const double time = static_cast<double>(centre) / scene.sample_rate;
    convolver.set_responses(responses_at(scene, room, position_at(source.path, time), orders, length));
    convolver.add(std::span(piece).first(stop - start), start, out);
  }
}

void play(const Scene& scene, const Room& room, const SceneSource& source, GridView<float> out) {
  if (is_at_rest(source.path)) return play_at_rest(scene, room, source, out);
  const std::size_t length = room.response_length(farthest(source));
  // Two walls at most: no longer way than the direct one and twice there and back.
  const float detour = 4 * norm(scene.room) / scene.speed_of_sound * static_cast<float>(scene.sample_rate);
  const std::size_t early = scene.rt60 > 0 ? std::min(length, static_cast<std::size_t>(detour) + 64) : length;
  play_moving(scene, room, source, kEarly, kEarlyStep, early, out);
  if (scene.rt60 > 0) play_moving(scene, room, source, kLate, kLateStep, length, out);
}

SourceTruth truth_of(const Scene& scene, const SceneSource& source) {
  SourceTruth truth;
  truth.name = source.name;
  std::vector<float> heard(scene.hops() * scene.hop);
  std::copy_n(source.sound.begin(), std::min(heard.size(), source.sound.size()), heard.begin());
  const auto emitted = activity_of(heard, scene.hop, scene.sample_rate);
  for (std::size_t h = 0; h < scene.hops(); ++h) {
    const double middle = (static_cast<double>(h) + 0.5) * static_cast<double>(scene.hop) / scene.sample_rate;
    const double way = static_cast<double>(waypoint_at(source.path, middle).distance / scene.speed_of_sound);
    const double left = std::max(0.0, middle - way);
    truth.direction.push_back(direction_at(source.path, left));
    truth.active.push_back(emitted[static_cast<std::size_t>(left * scene.sample_rate) / scene.hop]);
  }
  return truth;
}

/// Mean power over the microphones, in those hops where somebody speaks; 0 where nobody ever does.
double power_while_active(const Scene& scene, const Grid<float>& mics,
                          const std::vector<SourceTruth>& truth) {
  double power = 0;
  std::size_t count = 0;
  for (std::size_t h = 0; h < scene.hops(); ++h) {
    if (std::none_of(truth.begin(), truth.end(), [h](const SourceTruth& t) { return t.active[h] != 0; })) {
      continue;
    }
    for (std::size_t m = 0; m < mics.rows(); ++m) {
      for (const float x : mics[m].subspan(h * scene.hop, scene.hop)) power += static_cast<double>(x) * x;
    }
    count += mics.rows() * scene.hop;
  }
  return count == 0 ? 0 : power / static_cast<double>(count);
}

double power_of(const Grid<float>& mics) {
  double power = 0;
  for (std::size_t m = 0; m < mics.rows(); ++m) {
    for (const float x : mics[m]) power += static_cast<double>(x) * x;
  }
  return power / static_cast<double>(std::max<std::size_t>(1, mics.rows() * mics.cols()));
}

void add(const Grid<float>& from, Grid<float>& to) {
  for (std::size_t m = 0; m < to.rows(); ++m) {
    for (std::size_t n = 0; n < to.cols(); ++n) to[m][n] += from[m][n];
  }
}

void scale(Grid<float>& sound, float gain) {
  for (std::size_t m = 0; m < sound.rows(); ++m) {
    for (float& x : sound[m]) x *= gain;
  }
}

/// The amplifiers come behind the microphones: they change no SNR.
void amplify(const Scene& scene, SimulatedScene& result) {
  for (std::size_t m = 0; m < scene.mics.size(); ++m) {
    for (float& x : result.mics[m]) x *= scene.mics[m].gain;
  }
  for (auto& image : result.images) {
    for (float& x : image) x *= scene.mics[0].gain;
  }
  for (Grid<float>& images : result.images_at_all) {
    for (std::size_t m = 0; m < images.rows(); ++m) {
      for (float& x : images[m]) x *= scene.mics[m].gain;
    }
  }
}

/// One factor for all, where the loudest sample would not fit into full scale.
void avoid_clipping(SimulatedScene& scene) {
  float peak = 0;
  for (std::size_t m = 0; m < scene.mics.rows(); ++m) {
    for (const float x : scene.mics[m]) peak = std::max(peak, std::abs(x));
  }
  if (peak <= kHighestPeak) return;
  scene.scale = kHighestPeak / peak;
  scale(scene.mics, scene.scale);
  for (float& x : scene.played) x *= scene.scale;
  for (auto& image : scene.images) {
    for (float& x : image) x *= scene.scale;
  }
  for (Grid<float>& images : scene.images_at_all) scale(images, scene.scale);
}

}  // namespace

SimulatedScene simulate(const Scene& scene, const std::function<void(double)>& progress, Images images) {
  ODAS_EXPECT(!scene.mics.empty() && scene.samples() > 0);
  const auto report = [&progress](double share) {
    if (progress) progress(share);
  };
  const Room room(scene);
  const double parts = static_cast<double>(scene.sources.size()) + 1;
  SimulatedScene result;
  result.mics = Grid<float>(scene.mics.size(), scene.samples());
  Grid<float> targets(scene.mics.size(), scene.samples());
  for (std::size_t s = 0; s < scene.sources.size(); ++s) {
    SceneSource source = scene.sources[s];
    if (scene.rt60 > 0) block_dc(source.sound, scene.sample_rate);
    report(static_cast<double>(s) / parts);
    if (source.is_played) {
      result.played.resize(scene.samples());
      const std::size_t end = std::min(source.sound.size(), result.played.size());
      for (std::size_t n = 0; n < end; ++n) result.played[n] += scene.sources[s].sound[n];
    }
    Grid<float> image(scene.mics.size(), scene.samples());
    play(scene, room, source, image);
    add(image, source.is_target ? targets : result.mics);
    if (!source.is_target) continue;
    result.truth.push_back(truth_of(scene, source));
    result.images.emplace_back(image[0].begin(), image[0].end());
    if (images == Images::of_all) result.images_at_all.push_back(std::move(image));
  }
  const double heard = power_while_active(scene, targets, result.truth);
  const auto set_level = [&](Grid<float>& noise, float snr_db) {
    double wanted = heard * std::pow(10.0, -static_cast<double>(snr_db) / 10);
    if (wanted <= 0) wanted = std::pow(10.0, static_cast<double>(scene.noise_level_db) / 10);
    scale(noise, static_cast<float>(std::sqrt(wanted / std::max(power_of(noise), 1e-30))));
  };
  if (scene.directional_snr_db) set_level(result.mics, *scene.directional_snr_db);
  if (scene.noise) {
    report(1 - 1 / parts);
    Grid<float> noise = diffuse_noise(scene, scene.noise->colour, scene.seed);
    set_level(noise, scene.noise->snr_db);
    add(noise, result.mics);
  }
  add(targets, result.mics);
  amplify(scene, result);
  avoid_clipping(result);
  report(1);
  return result;
}

}  // namespace odas
