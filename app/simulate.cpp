// SPDX-License-Identifier: MIT
#include "odas/scene/simulate.hpp"

#include <iostream>
#include <memory>

#include "commands.hpp"
#include "progress.hpp"
#include <CLI/CLI.hpp>

#include "odas/base/error.hpp"
#include "odas/scene/scene_file.hpp"
#include "odas/scene/scene_output.hpp"

namespace odas {

namespace {

void simulate_file(const std::string& file, const std::string& folder, bool flac) {
  const Scene scene = read_scene(file);
  if (flac && scene.mics.size() > 8) {
    throw ConfigError("--flac", "FLAC holds 8 channels, the array has " + std::to_string(scene.mics.size()));
  }
  Progress progress;
  const SimulatedScene result = simulate(scene, [&progress](double share) { progress.show(share); });
  write_scene(scene, result, flac ? RecordingFormat::flac : RecordingFormat::wav, folder);
  progress.clear();
  std::cerr << "odas: " << scene.seconds << " s of " << scene.mics.size() << " microphones and "
            << result.truth.size() << " talkers in " << folder << '\n';
  if (result.scale < 1) {
    std::cerr << "odas: all was scaled by " << result.scale << ", so that nothing clips\n";
  }
}

}  // namespace

void add_simulate(CLI::App& app) {
  CLI::App* command = app.add_subcommand("simulate", "Make a recording, and its truth, of a scene in a room");
  command->footer(
      "SCENE is JSON: an array, a room, talkers and their ways, noise (docs/scenes.md).\n"
      "Writes OUT/mics.wav, OUT/truth.json and, for each talker K, OUT/image_K.wav: it alone, as the first\n"
      "microphone hears it. The same scene gives the same files.\n\n"
      "Examples:\n"
      "  odas simulate samples/sample_scene.json -o out/sample\n"
      "  odas simulate samples/sample_scene.json -o out/sample --flac");
  auto file = std::make_shared<std::string>();
  auto folder = std::make_shared<std::string>();
  auto flac = std::make_shared<bool>(false);
  command->add_option("SCENE", *file, "Scene to play")->type_name("")->required();
  command->add_option("-o,--out", *folder, "Folder to write to; it is made where absent")
      ->type_name("FOLDER")
      ->required();
  command->add_flag("--flac", *flac, "Write mics.flac instead of mics.wav (up to 8 microphones)");
  command->callback([file, folder, flac] { simulate_file(*file, *folder, *flac); });
}

}  // namespace odas
