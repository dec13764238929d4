// SPDX-License-Identifier: MIT
#include "odas/scene/scene_file.hpp"

#include <cmath>
#include <fstream>
#include <sstream>
#include <utility>

#include <nlohmann/json.hpp>

#include "odas/config/reader.hpp"
#include "odas/scene/bench_voice.hpp"
#include "odas/scene/json_reader.hpp"
#include "odas/scene/sound.hpp"
#include "odas/scene/trajectory.hpp"

namespace odas {
namespace {

constexpr std::initializer_list<const char*> kPatterns{"omni", "subcardioid", "cardioid", "supercardioid",
                                                       "figure-of-eight"};
constexpr float kOmniShare[] = {1, 0.7F, 0.5F, 0.366F, 0};
constexpr std::size_t kCardioid = 2;
constexpr std::initializer_list<const char*> kColours{"white", "pink", "fan", "motor"};
constexpr std::initializer_list<const char*> kDiffuse{"white", "pink", "fan", "motor", "babble"};

Vec3 vec3(const std::array<float, 3>& a) { return {a[0], a[1], a[2]}; }

class SceneFile {
 public:
  explicit SceneFile(std::filesystem::path folder) : folder_(std::move(folder)) {}

  Scene read(const nlohmann::json& json, const std::string& name) {
    JsonReader root(json, "", faults_);
    read_general(root);
    read_array(root);
    read_room(root);
    for (JsonReader& source : root.list("sources")) read_source(source);
    read_noise(root);
    root.finish();
    check_places();
    if (!faults_.empty()) {
      for (Fault& fault : faults_) fault.file = name;
      throw ConfigError(std::move(faults_));
    }
    for (std::size_t s = 0; s < scene_.sources.size(); ++s) {
      scene_.sources[s].sound = make_sound(recipes_[s], scene_.sample_rate, scene_.samples(),
                                           scene_.seed + 1000003U * static_cast<std::uint32_t>(s + 1));
    }
    if (scene_.noise && scene_.noise->colour == NoiseColour::babble) {
      scene_.noise->voices = crowd_voices(scene_.seed, false, scene_.sample_rate, scene_.seconds);
    }
    return std::move(scene_);
  }

 private:
  void read_general(JsonReader& root) {
    scene_.sample_rate = static_cast<int>(root.number("sample_rate", 16000, {4000, 192000}));
    scene_.seconds = root.number("seconds", std::nullopt, {0.1, 3600});
    scene_.hop = static_cast<std::size_t>(root.number("hop", 128, {16, 65536}));
    scene_.seed = static_cast<std::uint32_t>(root.number("seed", 1, {0, 4294967295.0}));
  }

  void read_array(JsonReader& root) {
    if (root.is_text("array")) {
      load_array(root.text("array", std::nullopt), std::nullopt, root);
    } else if (!root.has("array")) {
      root.fault("array", "is missing; it is the name of a configuration, or { mics = ... }");
    } else {
      JsonReader array = root.object("array");
      std::optional<std::size_t> pattern;
      if (array.has("pattern")) pattern = array.choice("pattern", 0, kPatterns);
      if (array.has("config")) {
        load_array(array.text("config", std::nullopt), pattern, array);
      } else {
        for (JsonReader& mic : array.list("mics")) read_mic(mic, pattern.value_or(0));
        if (scene_.mics.empty()) array.fault("mics", "is missing or empty");
      }
      array.finish();
    }
    scene_.speed_of_sound = static_cast<float>(
        root.number("speed_of_sound", static_cast<double>(scene_.speed_of_sound), {100, 2000}));
  }

  void load_array(const std::string& file, std::optional<std::size_t> pattern, JsonReader& at) {
    try {
      const GeneralConfig general = load_configuration(folder_ / file).config.pipeline.general;
      scene_.speed_of_sound = general.speedofsound.mu;
      for (const MicConfig& mic : general.mics) {
        const bool omni = is_omni(mic);
        scene_.mics.push_back({vec3(mic.mu), normalized(vec3(mic.direction)),
                               kOmniShare[pattern.value_or(omni ? 0 : kCardioid)]});
      }
    } catch (const ConfigError& error) { at.fault("array", "cannot be used: " + std::string(error.what())); }
  }

  void read_mic(JsonReader& mic, std::size_t pattern) {
    SceneMic result;
    result.position = mic.vector("position", std::nullopt);
    const Vec3 axis = mic.vector("direction", Vec3{0, 0, 1});
    if (norm(axis) == 0) mic.fault("direction", "must not be zero");
    result.axis = normalized(axis);
    result.omni = kOmniShare[mic.choice("pattern", pattern, kPatterns)];
    result.gain = static_cast<float>(std::pow(10, mic.number("gain_db", 0, {-60, 60}) / 20));
    mic.finish();
    scene_.mics.push_back(result);
  }

  void read_room(JsonReader& root) {
    if (!root.has("room")) return;
    JsonReader room = root.object("room");
    scene_.room = room.vector("size", std::nullopt);
    if (std::min({scene_.room.x, scene_.room.y, scene_.room.z}) <= 0.5F) {
      room.fault("size", "is " + std::to_string(scene_.room.x) + " x " + std::to_string(scene_.room.y) +
                             " x " + std::to_string(scene_.room.z) + " m; each side has to be over 0.5 m");
    }
    scene_.rt60 = static_cast<float>(room.number("rt60", 0, {0, 5}));
    scene_.array_position = room.vector("array_position", 0.5F * scene_.room);
    room.finish();
  }

  void read_source(JsonReader& source) {
    SceneSource result;
    SoundRecipe recipe;
    result.name = source.text("name", "source " + std::to_string(scene_.sources.size()));
    const int kinds = int{source.has("speech")} + int{source.has("say")} + int{source.has("noise")};
    if (kinds != 1) source.fault("", "needs exactly one of speech, say, noise");
    if (source.has("speech")) {
      recipe.kind = SoundRecipe::Kind::file;
      recipe.file = folder_ / source.text("speech", std::nullopt);
    }
    if (source.has("say")) {
      recipe.kind = SoundRecipe::Kind::speech;
      if (source.is_text("say")) {
        recipe.utterances.push_back({0, source.text("say", std::nullopt)});
      } else {
        for (JsonReader& words : source.list("say")) {
          recipe.utterances.push_back(
              {words.number("start", 0, {0, 3600}), words.text("text", std::nullopt)});
          words.finish();
        }
      }
      recipe.voice = source.text("voice", recipe.voice);
      recipe.words_per_minute = static_cast<int>(source.number("words_per_minute", 160, {80, 450}));
      recipe.pitch = static_cast<int>(source.number("pitch", 50, {0, 99}));
    }
    if (source.has("noise")) recipe.colour = static_cast<NoiseColour>(source.choice("noise", 0, kColours));
    result.is_played = source.flag("played", false);
    result.is_target = source.flag("target", !source.has("noise") && !result.is_played);
    recipe.start = source.number("start", 0, {0, 3600});
    recipe.gain_db = static_cast<float>(source.number("gain_db", 0, {-80, 40}));
    read_path(source, result);
    source.finish();
    paths_.push_back(source.path_of("path"));
    scene_.sources.push_back(std::move(result));
    recipes_.push_back(std::move(recipe));
  }

  void read_path(JsonReader& source, SceneSource& result) {
    for (JsonReader& point : source.list("path")) {
      Waypoint w;
      w.time = point.number("time", result.path.empty() ? std::optional(0.0) : std::nullopt, {0, 3600});
      w.azimuth = static_cast<float>(point.number("azimuth", std::nullopt, {-3600, 3600}));
      w.elevation = static_cast<float>(point.number("elevation", 0, {-90, 90}));
      w.distance = static_cast<float>(point.number("distance", 1.5, {0.1, 100}));
      if (!result.path.empty() && w.time <= result.path.back().time) {
        point.fault("time", "has to be after the time of the waypoint before");
      }
      point.finish();
      result.path.push_back(w);
    }
    if (result.path.empty()) {
      source.fault("path", "needs at least one waypoint { time, azimuth, elevation, distance }");
      result.path.push_back({0, 0, 0, 1});
    }
  }

  void read_noise(JsonReader& root) {
    if (root.has("directional_snr_db")) {
      scene_.directional_snr_db =
          static_cast<float>(root.number("directional_snr_db", std::nullopt, {-60, 120}));
    }
    if (!root.has("noise")) return;
    JsonReader noise = root.object("noise");
    DiffuseNoise result;
    result.colour = static_cast<NoiseColour>(noise.choice("kind", 0, kDiffuse));
    result.snr_db = static_cast<float>(noise.number("snr_db", 20, {-60, 120}));
    scene_.noise_level_db = static_cast<float>(noise.number("level_db", -50, {-120, -10}));
    noise.finish();
    scene_.noise = result;
  }

  [[nodiscard]] bool is_inside(Vec3 from_array) const {
    const Vec3 p = scene_.array_position + from_array;
    return p.x > 0 && p.y > 0 && p.z > 0 && p.x < scene_.room.x && p.y < scene_.room.y && p.z < scene_.room.z;
  }

  /// Behind a wall there is nothing that the image sources would be right for.
  void check_places() {
    constexpr double kStep = 0.05;  // s
    if (scene_.rt60 <= 0) return;
    for (const SceneMic& mic : scene_.mics) {
      if (is_inside(mic.position)) continue;
      faults_.push_back(
          {Fault::Severity::error, "room.array_position", "puts a microphone outside of the room", {}, 0});
      return;
    }
    for (std::size_t s = 0; s < scene_.sources.size(); ++s) {
      for (double time = 0; time < scene_.seconds; time += kStep) {
        if (is_inside(position_at(scene_.sources[s].path, time))) continue;
        std::ostringstream what;
        what << "is outside of the room at " << std::round(time * 100) / 100 << " s";
        faults_.push_back({Fault::Severity::error, paths_[s], what.str(), {}, 0});
        break;
      }
    }
  }

  std::filesystem::path folder_;
  Scene scene_;
  std::vector<SoundRecipe> recipes_;  // [source]
  std::vector<std::string> paths_;    // [source], JSON path of its path
  std::vector<Fault> faults_;
};

}  // namespace

Scene read_scene_text(std::string_view text, const std::filesystem::path& folder, const std::string& name) {
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(text, nullptr, true, true);
  } catch (const nlohmann::json::exception& error) {
    throw ConfigError({{Fault::Severity::error, "", "is not JSON: " + std::string(error.what()), name, 0}});
  }
  return SceneFile(folder).read(json, name);
}

Scene read_scene(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf())) throw IoError("cannot read the scene " + file.string());
  return read_scene_text(text.str(), file.parent_path(), file.string());
}

}  // namespace odas
