// SPDX-License-Identifier: MIT
#include "odas/scene/bench_scene.hpp"

#include <algorithm>
#include <cmath>

#include "odas/array/directivity.hpp"
#include "odas/array/doa_error.hpp"
#include "odas/scene/bench_voice.hpp"
#include "odas/scene/random.hpp"

namespace odas {
namespace {

constexpr float kPlaceError = 0.002F;  // m, root mean square
constexpr float kGainError = 3;        // dB, at most, up or down
constexpr float kQuietDb = 30;
constexpr float kLeastApart = 35;                   // degrees of azimuth
constexpr double kCrossFrom = 0.2, kCrossTo = 0.8;  // shares of the scene in which talkers walk
constexpr double kPause = 4.7;                      // s from one sentence to the next of who pauses

enum Part : std::uint32_t { room_part, mic_part, place_part, noise_part, voice_part = 100 };

std::string short_number(float value) {
  const float rounded = std::round(value * 10) / 10;
  std::string text = std::to_string(rounded);
  text.erase(text.find('.') + 2);
  if (text.ends_with(".0")) text.erase(text.size() - 2);
  return text;
}

class Drawing {
 public:
  Drawing(const BenchScene& bench, const GeneralConfig& array)
      : bench_(bench), array_(array), directivity_(array), shape_(shape_of(array.mics)) {}

  Scene draw() {
    scene_.sample_rate = array_.samplerate.mu;
    scene_.hop = static_cast<std::size_t>(array_.size.hop_size);
    scene_.seconds = bench_.seconds;
    scene_.seed = bench_.seed;
    scene_.speed_of_sound = array_.speedofsound.mu;
    draw_room();
    draw_mics();
    draw_places();
    for (std::size_t t = 0; t < places_.size(); ++t) add_talker(t);
    add_noise();
    return std::move(scene_);
  }

 private:
  [[nodiscard]] Random random(std::uint32_t part) const { return Random::of(bench_.seed, part); }

  void draw_room() {
    Random r = random(room_part);
    const float least = 2 * 1.15F * bench_.distance + 1.2F;
    scene_.room = {std::max(r.between(5, 9), least), std::max(r.between(4, 7), least), r.between(2.5F, 3.3F)};
    scene_.rt60 = bench_.rt60;
    scene_.array_position = {scene_.room.x / 2 + r.between(-0.25F, 0.25F),
                             scene_.room.y / 2 + r.between(-0.25F, 0.25F), r.between(0.9F, 1.3F)};
  }

  void draw_mics() {
    Random r = random(mic_part);
    for (const MicConfig& mic : array_.mics) {
      SceneMic made;
      made.position = {mic.mu[0], mic.mu[1], mic.mu[2]};
      made.axis = normalized(Vec3{mic.direction[0], mic.direction[1], mic.direction[2]});
      made.omni = is_omni(mic) ? 1 : 0.5F;
      if (bench_.inexact) {
        const float each = kPlaceError / std::sqrt(3.F);
        const float x = r.uniform(), y = r.uniform(), z = r.uniform();
        made.position = made.position + each * Vec3{x, y, z};
        made.gain = std::pow(10.F, r.between(-kGainError, kGainError) / 20);
      }
      scene_.mics.push_back(made);
    }
  }

  /// Elevations at which a talker so far away is between floor and ceiling, and where the array hears him.
  [[nodiscard]] float draw_elevation(Random& r, float distance) const {
    const float up = scene_.room.z - scene_.array_position.z - 0.3F;
    const float down = scene_.array_position.z - 0.4F;
    const auto limit = [&](float height) {
      return height >= distance ? 90.F : std::asin(height / distance) * 57.29578F;
    };
    float low = -15, high = 30;
    if (shape_ == ArrayShape::plane) low = 3, high = 40;
    if (shape_ == ArrayShape::line) low = 0, high = 4;
    return r.between(std::max(low, -limit(down)), std::min(high, limit(up)));
  }

  [[nodiscard]] bool is_heard(float azimuth) const {
    const bool line = shape_ == ArrayShape::line;  // near its ends it tells nothing
    return directivity_.filters(direction_of(azimuth, 4)) > 0.9F &&
           (!line || std::abs(std::remainder(azimuth, 360.F)) <= 75);
  }

  void draw_places() {
    Random r = random(place_part);
    for (int t = 0; t < bench_.talkers; ++t) {
      Waypoint place;
      for (int tries = 0; tries < 1000; ++tries) {
        // Where there is no room for so many so far apart they stand closer, at last.
        const float apart = kLeastApart * (tries < 500 ? 1.F : 0.6F);
        place.azimuth = r.between(-180, 180);
        const bool free = std::ranges::none_of(places_, [&](const Waypoint& other) {
          return std::abs(std::remainder(other.azimuth - place.azimuth, 360.F)) < apart;
        });
        if (free && is_heard(place.azimuth)) break;
      }
      place.distance = bench_.distance * r.between(0.85F, 1.15F);
      place.elevation = draw_elevation(r, place.distance);
      places_.push_back(place);
    }
    for (int t = 0; t < bench_.talkers; ++t)
      walks_.push_back(draw_walk(r, places_[static_cast<std::size_t>(t)]));
  }

  /// Where one who walks comes to: round by 60 to 100 degrees, as long as the array hears him.
  [[nodiscard]] Waypoint draw_walk(Random& r, Waypoint from) const {
    const float way = r.between(60, 100) * (r.share() < 0.5F ? -1.F : 1.F);
    for (const float turn : {way, -way, 0.5F * way, -0.5F * way}) {
      if (!is_heard(from.azimuth + turn) || !is_heard(from.azimuth + turn / 2)) continue;
      from.azimuth += turn;
      break;
    }
    return from;
  }

  [[nodiscard]] std::vector<Waypoint> path_of(std::size_t talker) const {
    Waypoint from = places_[talker];
    Waypoint to = from;
    if (bench_.motion == BenchMotion::walking) to = walks_[talker];
    if (bench_.motion == BenchMotion::crossing && talker < 2) {
      const float way = std::remainder(places_[1].azimuth - places_[0].azimuth, 360.F);
      // Past each other, and not round the back of an array that hears none there.
      const bool behind = !is_heard(places_[0].azimuth + way / 2);
      const float turn = behind ? way - std::copysign(360.F, way) : way;
      to = places_[1 - talker];
      to.azimuth = from.azimuth + (talker == 0 ? turn : -turn);
    }
    from.time = kCrossFrom * bench_.seconds;
    to.time = kCrossTo * bench_.seconds;
    return {from, to};
  }

  void add_talker(std::size_t talker) {
    Random r = random(voice_part + static_cast<std::uint32_t>(talker));
    SoundRecipe recipe = draw_voice(r, bench_.test);
    recipe.start = r.between(0.2F, 0.9F);
    if (bench_.motion == BenchMotion::pausing) {
      for (double time = 0; time < bench_.seconds; time += kPause) {
        recipe.utterances.push_back({time, draw_words(r, bench_.test, 1)});
      }
    } else {
      recipe.utterances.push_back({0, draw_words(r, bench_.test, 2 + static_cast<int>(bench_.seconds / 2))});
    }
    SceneSource source;
    source.name = "talker " + std::to_string(talker);
    source.path = path_of(talker);
    source.sound = make_sound(recipe, scene_.sample_rate, scene_.samples(), 0);
    scene_.sources.push_back(std::move(source));
  }

  void add_point_noise(Random& r, NoiseColour colour, Waypoint place, float gain_db) {
    SoundRecipe recipe;
    recipe.colour = colour;
    recipe.gain_db = gain_db;
    SceneSource source;
    source.name = "noise " + std::to_string(scene_.sources.size());
    source.is_target = false;
    source.path = {place};
    const auto seed = static_cast<std::uint32_t>(r.below(1U << 30U));
    source.sound = make_sound(recipe, scene_.sample_rate, scene_.samples(), seed);
    scene_.sources.push_back(std::move(source));
  }

  /// Away from all talkers' places, if there is such a place.
  [[nodiscard]] float free_azimuth(Random& r) const {
    float azimuth = 0;
    for (int tries = 0; tries < 1000; ++tries) {
      azimuth = r.between(-180, 180);
      if (std::ranges::none_of(places_, [&](const Waypoint& other) {
            return std::abs(std::remainder(other.azimuth - azimuth, 360.F)) < kLeastApart;
          })) {
        break;
      }
    }
    return azimuth;
  }

  void add_noise() {
    Random r = random(noise_part);
    scene_.noise = DiffuseNoise{NoiseColour::pink, kQuietDb, {}};
    switch (bench_.noise) {
      case BenchNoise::none:
        break;
      case BenchNoise::diffuse:
        scene_.noise->snr_db = bench_.snr_db;
        break;
      case BenchNoise::fan: {
        const float azimuth = free_azimuth(r);
        const float distance = r.between(1, std::min(2.5F, 0.45F * std::min(scene_.room.x, scene_.room.y)));
        add_point_noise(r, NoiseColour::fan, {0, azimuth, r.between(0, 10), distance}, 0);
        scene_.directional_snr_db = bench_.snr_db;
        break;
      }
      case BenchNoise::babble:
        scene_.noise->colour = NoiseColour::babble;
        scene_.noise->snr_db = bench_.snr_db;
        scene_.noise->voices = crowd_voices(bench_.seed, bench_.test, scene_.sample_rate, bench_.seconds);
        break;
      case BenchNoise::ego:
        add_point_noise(r, NoiseColour::fan,
                        {0, r.between(-180, 180), r.between(-40, 0), r.between(0.2F, 0.35F)}, 0);
        for (int motor = 0; motor < 2; ++motor) {
          add_point_noise(r, NoiseColour::motor,
                          {0, r.between(-180, 180), r.between(-40, 0), r.between(0.2F, 0.35F)}, -3);
        }
        scene_.directional_snr_db = bench_.snr_db;
        break;
    }
  }

  const BenchScene& bench_;
  const GeneralConfig& array_;
  Directivity directivity_;
  ArrayShape shape_;
  Scene scene_;
  std::vector<Waypoint> places_;  // [talker]: where each begins
  std::vector<Waypoint> walks_;   // [talker]: where each would walk to
};

}  // namespace

const char* name_of(BenchNoise noise) noexcept {
  constexpr const char* kNames[] = {"none", "diffuse", "fan", "babble", "ego"};
  return kNames[static_cast<std::size_t>(noise)];
}

const char* name_of(BenchMotion motion) noexcept {
  constexpr const char* kNames[] = {"still", "walking", "crossing", "pausing"};
  return kNames[static_cast<std::size_t>(motion)];
}

std::string BenchScene::name() const {
  return group + (test ? "/test/" : "/train/") + std::to_string(number);
}

std::string BenchScene::text() const {
  return name() + " " + array + " mics=" + std::to_string(mics) + " rt60=" + short_number(rt60) +
         " distance=" + short_number(distance) + " noise=" + name_of(noise) + " snr=" + short_number(snr_db) +
         " talkers=" + std::to_string(talkers) + " motion=" + name_of(motion) +
         " mics_are=" + (inexact ? "inexact" : "exact") +
         " seconds=" + short_number(static_cast<float>(seconds)) + " seed=" + std::to_string(seed);
}

Scene make_scene(const BenchScene& bench, const GeneralConfig& array) { return Drawing(bench, array).draw(); }

}  // namespace odas
