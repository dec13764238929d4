// SPDX-License-Identifier: MIT
#include "odas/scene/bench_voice.hpp"

#include <array>

namespace odas {
namespace {

// Accents and speakers (variants) of espeak-ng, men and women; the first row of each is for training.
constexpr std::array<std::array<const char*, 8>, 2> kVoices{
    {{"en-us+m1", "en-gb+m3", "en-us+f1", "en-gb-scotland+f2", "en-us+m5", "en-gb+f4", "en-us+klatt",
      "en-029+f3"},
     {"en-gb+m2", "en-us+m4", "en-gb+f1", "en-us+f2", "en-gb-x-rp+m6", "en-us+f5", "en-gb-x-gbclan+m7",
      "en-us+f3"}}};

constexpr std::array<std::array<const char*, 14>, 2> kSentences{
    {{"The old clock in the kitchen stops every night.", "She put nine yellow apples into a paper bag.",
      "Nobody saw the small boat leave the harbour.", "A warm wind came down from the hills today.",
      "Please bring the tall chair back to my office.", "He reads the whole newspaper before breakfast.",
      "The children built a bridge from wet sand.", "Turn left behind the church and drive on slowly.",
      "My neighbour grows tomatoes on her balcony.", "The last train to the coast was late again.",
      "We painted both doors green and the fence blue.", "Give the brown dog some water and a blanket.",
      "Every second light along the road was broken.", "They sang an old song about the sea."},
     {"The baker opens his shop at five in the morning.", "Two grey birds sat on the roof of the barn.",
      "I lost my keys somewhere between here and town.", "Her brother repairs violins and clarinets.",
      "Snow covered the path, so we took the bus.", "Cut the bread thick and toast it on both sides.",
      "The lecture about volcanoes begins at noon.", "His new coat is lighter than it looks.",
      "Close the window before the rain gets in.", "A young doctor asked us to wait outside.",
      "They moved the piano into the smaller room.", "Most of the letters were never answered.",
      "The river is deep and cold under the old mill.", "Could you turn down the music a little?"}}};

}  // namespace

std::string draw_words(Random& random, bool test_half, int count) {
  const auto& sentences = kSentences[test_half ? 1 : 0];
  std::string words;
  std::size_t last = sentences.size();
  for (int i = 0; i < count; ++i) {
    std::size_t next = random.below(sentences.size());
    if (next == last) next = (next + 1) % sentences.size();
    last = next;
    words += (words.empty() ? "" : " ") + std::string(sentences[next]);
  }
  return words;
}

SoundRecipe draw_voice(Random& random, bool test_half) {
  const auto& voices = kVoices[test_half ? 1 : 0];
  SoundRecipe recipe;
  recipe.kind = SoundRecipe::Kind::speech;
  recipe.voice = voices[random.below(voices.size())];
  recipe.words_per_minute = static_cast<int>(random.between(140, 190));
  recipe.pitch = static_cast<int>(random.between(30, 70));
  recipe.gain_db = random.between(-2, 2);
  return recipe;
}

std::vector<std::vector<float>> crowd_voices(std::uint32_t seed, bool test_half, int sample_rate,
                                             double seconds) {
  constexpr std::uint32_t kTalkers = 6, kPart = 200;
  const auto samples = static_cast<std::size_t>(seconds * sample_rate);
  std::vector<std::vector<float>> voices;
  for (std::uint32_t v = 0; v < kTalkers; ++v) {
    Random random = Random::of(seed, kPart + v);
    SoundRecipe recipe = draw_voice(random, test_half);
    recipe.utterances.push_back({0, draw_words(random, test_half, 2 + static_cast<int>(seconds / 2))});
    voices.push_back(make_sound(recipe, sample_rate, samples, 0));
  }
  return voices;
}

}  // namespace odas
