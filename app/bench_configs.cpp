// SPDX-License-Identifier: MIT
#include "bench_configs.hpp"

#include <array>
#include <filesystem>
#include <optional>

#include "odas/base/error.hpp"
#include "odas/config/array_library.hpp"
#include "odas/config/edit.hpp"
#include "odas/config/reader.hpp"
#include "odas/config/source_text.hpp"

namespace odas {
namespace {

namespace fs = std::filesystem;

/// What ODAS's own file for the array says otherwise than its other files do.
struct OdasArray {
  const char* name;
  const char* file;
  float active, inactive, variance;  // of E
  int patience;                      // hops; 0: as the reader has it, rising with the number of tracks
  int interpolation;
  float spurious;  // probMin
};
constexpr std::array kOdasArrays{
    OdasArray{"respeaker_usb_4_mic", "respeaker_usb_4_mic_array.cfg", 0.4F, 0.25F, 0.0025F, 250, 4, 0.5F},
    OdasArray{"ps3_eye", "pseye.cfg", 0.4F, 0.25F, 0.0025F, 150, 4, 0.5F},
    OdasArray{"respeaker_6_mic", "respeaker_6_mic_array.cfg", 0.3F, 0.15F, 0.0025F, 0, 4, 0.5F},
    OdasArray{"minidsp_uma8", "minidsp.cfg", 0.4F, 0.25F, 0.0025F, 150, 4, 0.5F},
    OdasArray{"beam_8soundsusb", "beam.cfg", 0.25F, 0.05F, 0.002F, 0, 1, 0.5F},
    OdasArray{"minidsp_uma16", "azimut_oma.cfg", 0.3F, 0.15F, 0.0025F, 0, 1, 0.3F},
    OdasArray{"azimut3_closed_16", "azimut_cma.cfg", 0.15F, 0.05F, 0.0025F, 0, 1, 0.3F}};

Configuration as_odas(const std::string& name, const GeneralConfig& general) {
  Configuration config;
  config.pipeline.general = general;
  for (const OdasArray& array : kOdasArrays) {
    if (name != array.name) continue;
    SstConfig& sst = config.pipeline.sst;
    sst.active = {{1, array.active, array.variance}};
    sst.inactive = {{1, array.inactive, array.variance}};
    if (array.patience > 0) sst.n_inactive.assign(4, array.patience);
    config.pipeline.ssl.interp_rate = array.interpolation;
    config.pipeline.ssl.prob_min = array.spurious;
  }
  return config;
}

std::string with_settings(const fs::path& file, const std::vector<std::string>& settings) {
  std::vector<Fault> faults;
  std::string text = SourceText::from_file(file, faults).written();
  for (const std::string& setting : settings) {
    const auto dot = setting.find('.');
    const auto equal = setting.find('=');
    if (dot == std::string::npos || equal == std::string::npos || dot > equal) {
      throw ConfigError("--set", "'" + setting + "' is not of the form group.key=value");
    }
    text = with_setting(text, setting.substr(0, dot), setting.substr(dot + 1, equal - dot - 1),
                        setting.substr(equal + 1));
  }
  return text;
}

/// The file that is given in place of an array's own.
std::optional<fs::path> given(const std::string& array, const std::vector<std::string>& files) {
  for (const fs::path file : files) {
    const fs::path inside = file / (array + ".cfg");
    if (fs::is_directory(file) && fs::exists(inside)) return inside;
    if (file.stem() == array) return file;
  }
  return std::nullopt;
}

Configuration listener(const std::string& array, const BenchListening& listening) {
  const fs::path file = given(array, listening.files).value_or(find_configuration(array));
  if (listening.settings.empty()) return load_configuration(file).config;
  LoadedConfiguration loaded =
      read_configuration_text(with_settings(file, listening.settings), file.string());
  if (!loaded.ok()) throw ConfigError(loaded.faults);
  return loaded.config;
}

}  // namespace

std::map<std::string, BenchConfig> bench_configs(std::span<const BenchScene> scenes,
                                                 const BenchListening& listening) {
  std::map<std::string, BenchConfig> configs;
  for (const BenchScene& scene : scenes) {
    if (configs.contains(scene.array)) continue;
    BenchConfig config;
    config.array = load_configuration(find_configuration(scene.array)).config.pipeline.general;
    config.listener =
        listening.like_odas ? as_odas(scene.array, config.array) : listener(scene.array, listening);
    if (config.listener.pipeline.general.mics.size() != config.array.mics.size()) {
      throw ConfigError("--config", "the file for " + scene.array + " has " +
                                        std::to_string(config.listener.pipeline.general.mics.size()) +
                                        " microphones, the array " +
                                        std::to_string(config.array.mics.size()));
    }
    configs.emplace(scene.array, std::move(config));
  }
  return configs;
}

}  // namespace odas
