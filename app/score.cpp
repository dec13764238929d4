// SPDX-License-Identifier: MIT
// odas score: how well a system heard a scene whose truth is known.
#include <cstdio>
#include <memory>

#include "commands.hpp"
#include <CLI/CLI.hpp>

#include "odas/base/error.hpp"
#include "odas/scene/audition.hpp"
#include "odas/scene/score_text.hpp"
#include "odas/scene/truth_file.hpp"

namespace odas {

namespace {

void score_folder(const std::string& out, const std::string& truth, bool json) {
  const KnownScene scene = read_truth(truth);
  const Audition audition = read_audition(out, scene);
  const Score result = score(scene, read_known_sound(truth, scene), audition);
  const std::string text = json ? score_json(result) : score_table(result);
  std::fputs(text.c_str(), stdout);
  if (std::fflush(stdout) != 0) throw IoError("cannot write to standard output");
}

}  // namespace

void add_score(CLI::App& app) {
  CLI::App* command = app.add_subcommand("score", "Compare what was heard with the truth of a scene");
  command->footer(
      "OUT is what `odas run` wrote, or a folder with ODAS's tracks.json, pots.json, separated.raw and\n"
      "postfiltered.raw. TRUTH is what `odas simulate` wrote, or a truth.json alone: then the voices are "
      "not\n"
      "scored. docs/scenes.md says what the figures mean.\n\n"
      "Examples:\n"
      "  odas simulate samples/sample_scene.json -o scene\n"
      "  odas run scene/mics.wav -c configs/sample.cfg -o out\n"
      "  odas score out scene\n"
      "  odas score out samples/sample_truth.json --json");
  auto out = std::make_shared<std::string>();
  auto truth = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  command->add_option("OUT", *out, "Folder with what was heard")->type_name("")->required();
  command->add_option("TRUTH", *truth, "Folder of the scene, or its truth.json")->type_name("")->required();
  command->add_flag("--json", *json, "Print one JSON object");
  command->callback([out, truth, json] { score_folder(*out, *truth, *json); });
}

}  // namespace odas
