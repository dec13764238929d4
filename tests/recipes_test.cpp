// SPDX-License-Identifier: MIT
// The pieces of configuration that docs/recipes.md recommends are taken without a word.
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "odas/config/reader.hpp"

namespace odas::recipes_test {
namespace {

/// What stands in each block of "```cfg".
std::vector<std::string> recipes() {
  const std::ifstream file(std::filesystem::path(ODAS_SOURCE_DIR) / "docs" / "recipes.md");
  std::ostringstream all;
  all << file.rdbuf();
  const std::string text = all.str();
  const std::string begin = "```cfg\n";
  std::vector<std::string> blocks;
  for (std::size_t at = 0; (at = text.find(begin, at)) != std::string::npos;) {
    at += begin.size();
    const std::size_t end = text.find("```", at);
    blocks.push_back(text.substr(at, end - at));
    at = end;
  }
  return blocks;
}

/// Puts `lines` into the group, which is made if it is not there.
void put_into(std::string& text, const std::string& group, const std::string& lines) {
  const std::string head = group + ": {";
  if (const std::size_t at = text.find(head); at != std::string::npos) {
    text.insert(at + head.size(), lines);
  } else {
    text += head + lines + "};\n";
  }
}

TEST(Recipes, are_taken_without_a_word) {
  const std::vector<std::string> blocks = recipes();
  ASSERT_GT(blocks.size(), 10U);
  for (std::string text : blocks) {
    const std::string recipe = text;
    put_into(text, "raw", " fS = 16000; nChannels = 4; ");
    put_into(text, "general",
             " mics = ( { mu = (-0.03, 0, 0); }, { mu = (0, -0.03, 0); }, { mu = (0.03, 0, 0); },"
             " { mu = (0, 0.03, 0); } ); ");
    const LoadedConfiguration loaded = read_configuration_text(text, "recipe.cfg");
    for (const Fault& fault : loaded.faults) ADD_FAILURE() << to_string(fault) << " in\n" << recipe;
  }
}

}  // namespace
}  // namespace odas::recipes_test
