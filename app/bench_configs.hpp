// SPDX-License-Identifier: MIT
// With which configurations a benchmark listens.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "odas/engine/config.hpp"
#include "odas/scene/bench_scene.hpp"

namespace odas {

struct BenchListening {
  std::vector<std::string> files;     // in place of the shipped ones of the same name; or folders of such
  std::vector<std::string> settings;  // "sst.mode=\"particle\"", in all of them
  bool like_odas = false;             // nothing but the array, and ODAS's mixtures for it
};

/// What the array is, and how it listens.
struct BenchConfig {
  GeneralConfig array;  // of the shipped file: the scenes are played to it
  Configuration listener;
};

/// By name, for all arrays of the scenes. Throws ConfigError.
[[nodiscard]] std::map<std::string, BenchConfig> bench_configs(std::span<const BenchScene> scenes,
                                                               const BenchListening& listening);

}  // namespace odas
