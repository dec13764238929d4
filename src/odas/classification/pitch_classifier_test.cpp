// SPDX-License-Identifier: MIT
#include "odas/classification/pitch_classifier.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::pitch_classifier_test {
namespace {

constexpr std::size_t kHop = 128;
constexpr double kRate = 16000;

/// The sound of one slot, sample by sample.
using Sound = std::function<float()>;

/// Ten harmonics of a pitch that follows `hertz(seconds)`.
Sound voice(std::function<double(double)> hertz) {
  return [hertz = std::move(hertz), time = 0.0, phase = 0.0]() mutable {
    phase += 2 * M_PI * hertz(time) / kRate;
    time += 1 / kRate;
    double x = 0;
    for (int h = 1; h <= 10; ++h) x += std::cos(h * phase) / h;
    return static_cast<float>(0.1 * x);
  };
}

/// A pitch that swings as that of speech does.
Sound talker() {
  return voice([](double t) { return 140 + 30 * std::sin(2 * M_PI * 1.5 * t); });
}
Sound hum() {
  return voice([](double) { return 120; });
}
Sound silence() {
  return [] { return 0.F; };
}
Sound white_noise() {
  return [random = std::mt19937(1), normal = std::normal_distribution<float>(0, 0.1F)]() mutable {
    return normal(random);
  };
}
Sound rumble() {
  return [noise = white_noise(), y = 0.F]() mutable { return y = 0.9F * y + noise(); };
}

/// What the files in configs/ say: any peak is a pitch to ODAS, and noise has peaks too.
ClassifyConfig strict() {
  ClassifyConfig config;
  config.voicing_min = 0.35F;
  return config;
}

Track track(std::uint64_t id) {
  Track out;
  out.id = id;
  return out;
}

/// Share of the hops of which a classifier with one slot says `category`.
double share(PitchClassifier& classifier, Sound& sound, int hops, Category category = Category::speech,
             std::uint64_t id = 1) {
  Grid<float> hop(1, kHop);
  std::array tracks{track(id)};
  int count = 0;
  for (int h = 0; h < hops; ++h) {
    for (float& x : hop[0]) x = sound();
    classifier.classify(hop, tracks);
    count += tracks[0].category == category ? 1 : 0;
  }
  return static_cast<double>(count) / hops;
}

double share(PitchClassifier& classifier, Sound&& sound, int hops, Category category = Category::speech,
             std::uint64_t id = 1) {
  return share(classifier, sound, hops, category, id);
}

TEST(PitchClassifier, calls_a_voice_with_a_moving_pitch_speech) {
  PitchClassifier classifier(strict(), kHop, 1);
  Sound sound = talker();
  share(classifier, sound, 60);
  EXPECT_GT(share(classifier, sound, 250), 0.9);
}

TEST(PitchClassifier, does_not_call_a_hum_noise_or_silence_speech) {
  for (const auto& make : {hum, white_noise, rumble, silence}) {
    PitchClassifier classifier(strict(), kHop, 1);
    EXPECT_EQ(share(classifier, make(), 1000), 0);
  }
}

// ODAS's answer is latched: once speech, always speech (fault B18).
TEST(PitchClassifier, says_nonspeech_again_when_the_voice_has_stopped) {
  PitchClassifier classifier(strict(), kHop, 1);
  share(classifier, talker(), 200);
  Sound after = hum();
  share(classifier, after, 80);
  EXPECT_EQ(share(classifier, after, 100), 0);
}

// ODAS leaves what the one before was (fault B18).
TEST(PitchClassifier, says_undefined_of_an_empty_slot) {
  PitchClassifier classifier(strict(), kHop, 1);
  share(classifier, talker(), 200);
  EXPECT_EQ(share(classifier, talker(), 10, Category::undefined, 0), 1);
}

TEST(PitchClassifier, forgets_a_source_when_the_id_of_its_slot_changes) {
  PitchClassifier classifier(strict(), kHop, 1);
  share(classifier, talker(), 200);
  EXPECT_EQ(share(classifier, talker(), 1, Category::nonspeech, 2), 1);
}

TEST(PitchClassifier, judges_each_slot_by_itself) {
  PitchClassifier classifier(strict(), kHop, 3);
  std::array<Sound, 3> sounds{hum(), talker(), white_noise()};
  Grid<float> hops(3, kHop);
  std::array tracks{track(1), track(2), track(0)};
  for (int h = 0; h < 150; ++h) {
    for (std::size_t s = 0; s < 3; ++s) {
      for (float& x : hops[s]) x = sounds[s]();
    }
    classifier.classify(hops, tracks);
  }
  EXPECT_EQ(tracks[0].category, Category::nonspeech);
  EXPECT_EQ(tracks[1].category, Category::speech);
  EXPECT_EQ(tracks[2].category, Category::undefined);
}

TEST(PitchClassifier, after_reset_is_as_new) {
  PitchClassifier used(strict(), kHop, 1);
  share(used, talker(), 200);
  used.reset();
  PitchClassifier fresh(strict(), kHop, 1);
  Sound a = talker();
  Sound b = talker();
  for (int h = 0; h < 100; ++h) { EXPECT_EQ(share(used, a, 1), share(fresh, b, 1)) << h; }
}

TEST(PitchClassifier, takes_what_is_not_finite_for_silence) {
  PitchClassifier classifier(strict(), kHop, 1);
  Sound sound = talker();
  share(classifier, sound, 100);
  share(
      classifier, [] { return std::numeric_limits<float>::quiet_NaN(); }, 2);
  share(classifier, sound, 30);
  EXPECT_GT(share(classifier, sound, 100), 0.9);
}

TEST(PitchClassifier, refuses_a_frame_that_it_cannot_use) {
  ClassifyConfig config;
  config.frame_size = 1023;
  EXPECT_THROW(PitchClassifier(config, kHop, 1), ConfigError);
  config.frame_size = 64;
  EXPECT_THROW(PitchClassifier(config, kHop, 1), ConfigError);
  config.frame_size = 128;
  EXPECT_NO_THROW(PitchClassifier(config, kHop, 1));
}

}  // namespace
}  // namespace odas::pitch_classifier_test
