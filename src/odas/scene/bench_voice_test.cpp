// SPDX-License-Identifier: MIT
#include "odas/scene/bench_voice.hpp"

#include <set>

#include <gtest/gtest.h>

namespace odas::bench_voice_test {
namespace {

TEST(BenchVoice, The_halves_share_neither_voices_nor_sentences) {
  std::set<std::string> voices[2], sentences[2];
  for (std::uint32_t seed = 1; seed < 200; ++seed) {
    for (const std::size_t half : {0U, 1U}) {
      Random random(seed);
      voices[half].insert(draw_voice(random, half == 1).voice);
      sentences[half].insert(draw_words(random, half == 1, 1));
    }
  }
  for (const std::string& voice : voices[0]) EXPECT_FALSE(voices[1].contains(voice)) << voice;
  for (const std::string& sentence : sentences[0]) EXPECT_FALSE(sentences[1].contains(sentence)) << sentence;
  EXPECT_EQ(voices[1].size(), 8U);
}

}  // namespace
}  // namespace odas::bench_voice_test
