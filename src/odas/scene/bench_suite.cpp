// SPDX-License-Identifier: MIT
#include "odas/scene/bench_suite.hpp"

#include <algorithm>
#include <array>
#include <sstream>

#include "odas/scene/random.hpp"

namespace odas {
namespace {

struct Array {
  const char* name;
  int mics;
};
constexpr Array kSquare4{"respeaker_usb_4_mic", 4}, kLine4{"ps3_eye", 4}, kRing6{"respeaker_6_mic", 6},
    kRing7{"minidsp_uma8", 7}, kRing8{"beam_8soundsusb", 8}, kGrid16{"minidsp_uma16", 16},
    kClosed16{"azimut3_closed_16", 16};
constexpr std::array kArrays{kSquare4, kLine4, kRing6, kRing7, kRing8, kGrid16, kClosed16};
constexpr std::array kThree{kSquare4, kRing7, kGrid16};
constexpr std::array kRooms{0.F, 0.2F, 0.4F, 0.6F, 0.8F};
constexpr std::array kDistances{0.5F, 1.F, 1.5F, 2.F, 3.F, 4.F};
constexpr std::array kSnrs{20.F, 10.F, 5.F, 0.F, -5.F};
constexpr std::array kNoises{BenchNoise::diffuse, BenchNoise::fan, BenchNoise::babble};
constexpr std::array kTalkers{1, 2, 1, 3, 2, 4};
constexpr std::array kMotions{BenchMotion::still, BenchMotion::walking, BenchMotion::crossing,
                              BenchMotion::pausing};

/// Deals the levels of conditions: each as often as the others, in an order that the seed shuffles.
class Dealer {
 public:
  Dealer(std::uint32_t seed, std::size_t scenes) : seed_(seed), scenes_(scenes) {}

  template <class Levels>
  [[nodiscard]] auto deal(const Levels& levels) {
    std::vector<typename Levels::value_type> dealt(scenes_);
    for (std::size_t i = 0; i < scenes_; ++i) dealt[i] = levels[i % levels.size()];
    Random random = Random::of(seed_, ++condition_);
    for (std::size_t i = scenes_; i > 1; --i) std::swap(dealt[i - 1], dealt[random.below(i)]);
    return dealt;
  }

 private:
  std::uint32_t seed_;
  std::size_t scenes_;
  std::uint32_t condition_ = 0;
};

class Suite {
 public:
  explicit Suite(std::uint32_t seed) : seed_(seed) {}

  /// Adds `scenes` scenes of a group, half of them of each half. `deal(dealer, scenes)` sets the conditions.
  template <class Deal>
  void add(const std::string& group, std::size_t scenes, Deal&& deal) {
    ++group_;
    for (const bool test : {false, true}) {
      const std::uint32_t seed = seed_ * 7919 + group_ * 104729 + (test ? 15485863U : 0U);
      std::vector<BenchScene> part(scenes / 2);
      Dealer dealer(seed, part.size());
      deal(dealer, part);
      for (std::size_t i = 0; i < part.size(); ++i) {
        part[i].group = group;
        part[i].number = static_cast<int>(i);
        part[i].test = test;
        part[i].seed = seed + static_cast<std::uint32_t>(i) * 2654435761U;
        if (part[i].motion == BenchMotion::crossing) part[i].talkers = std::max(part[i].talkers, 2);
        scenes_.push_back(part[i]);
      }
    }
  }

  [[nodiscard]] std::vector<BenchScene> take() { return std::move(scenes_); }

 private:
  std::uint32_t seed_;
  std::uint32_t group_ = 0;
  std::vector<BenchScene> scenes_;
};

template <class Values, class Member>
void set(std::vector<BenchScene>& scenes, Member member, const Values& values) {
  for (std::size_t i = 0; i < scenes.size(); ++i)
    scenes[i].*member = static_cast<std::remove_reference_t<decltype(scenes[i].*member)>>(values[i]);
}

void set_arrays(std::vector<BenchScene>& scenes, const std::vector<Array>& arrays) {
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    scenes[i].array = arrays[i].name;
    scenes[i].mics = arrays[i].mics;
  }
}

std::vector<std::string> words_of(const std::string& filter) {
  std::istringstream in(filter);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

/// With a blank behind, "snr=0" is not found in "snr=0.5".
bool holds(const BenchScene& scene, const std::string& word) {
  const std::string text = " " + scene.text() + " ";
  return text.find(word.back() == '/' ? " " + word : " " + word + " ") != std::string::npos;
}

}  // namespace

std::vector<BenchScene> accuracy_suite(std::uint32_t seed) {
  Suite suite(seed);
  using B = BenchScene;
  suite.add("mixed", 256, [](Dealer& dealer, std::vector<B>& scenes) {
    set_arrays(scenes, dealer.deal(kArrays));
    set(scenes, &B::rt60, dealer.deal(kRooms));
    set(scenes, &B::distance, dealer.deal(kDistances));
    set(scenes, &B::noise, dealer.deal(kNoises));
    set(scenes, &B::snr_db, dealer.deal(kSnrs));
    set(scenes, &B::talkers, dealer.deal(kTalkers));
    set(scenes, &B::motion, dealer.deal(kMotions));
    set(scenes, &B::inexact, dealer.deal(std::array{0, 0, 1}));
  });
  suite.add("crossing", 24, [](Dealer& dealer, std::vector<B>& scenes) {
    set_arrays(scenes, dealer.deal(kThree));
    set(scenes, &B::rt60, dealer.deal(std::array{0.2F, 0.4F}));
    for (B& scene : scenes) scene.motion = BenchMotion::crossing;
  });
  const auto one_in = [](BenchNoise noise) {
    return [noise](Dealer& dealer, std::vector<B>& scenes) {
      std::vector<Array> arrays;
      for (std::size_t i = 0; i < scenes.size(); ++i) arrays.push_back(kThree[i % kThree.size()]);
      set_arrays(scenes, arrays);
      set(scenes, &B::rt60, dealer.deal(std::array{0.2F, 0.3F, 0.4F}));
      for (B& scene : scenes) {
        scene.noise = noise;
        scene.snr_db = 0;
      }
    };
  };
  suite.add("loud", 30, one_in(BenchNoise::diffuse));
  suite.add("ego", 30, one_in(BenchNoise::ego));
  suite.add("silence", 14, [](Dealer& dealer, std::vector<B>& scenes) {
    set_arrays(scenes, dealer.deal(kArrays));
    set(scenes, &B::rt60, dealer.deal(kRooms));
    set(scenes, &B::noise, dealer.deal(std::array{BenchNoise::diffuse, BenchNoise::babble}));
    for (B& scene : scenes) scene.talkers = 0;
  });
  return suite.take();
}

std::vector<BenchScene> separation_suite(std::uint32_t seed) {
  Suite suite(seed ^ 0x5e9a5e9aU);
  using B = BenchScene;
  constexpr std::array kSmallRooms{0.2F, 0.3F, 0.4F, 0.6F};
  constexpr std::array kNear{1.F, 1.5F, 1.8F, 2.5F};
  const auto with = [&](auto&& more) {
    return [&, more](Dealer& dealer, std::vector<B>& scenes) {
      set_arrays(scenes, dealer.deal(kArrays));
      set(scenes, &B::rt60, dealer.deal(kSmallRooms));
      set(scenes, &B::distance, dealer.deal(kNear));
      more(dealer, scenes);
    };
  };
  const auto talkers = [](int count) {
    return [count](Dealer&, std::vector<B>& scenes) {
      for (B& scene : scenes) scene.talkers = count;
    };
  };
  suite.add("two", 48, with(talkers(2)));
  suite.add("three", 12, with(talkers(3)));
  suite.add("noise", 24, with([](Dealer& dealer, std::vector<B>& scenes) {
              set(scenes, &B::noise, dealer.deal(kNoises));
              set(scenes, &B::snr_db, dealer.deal(std::array{0.F, 5.F}));
            }));
  suite.add("moving", 16, with([](Dealer& dealer, std::vector<B>& scenes) {
              set(scenes, &B::motion, dealer.deal(std::array{BenchMotion::walking, BenchMotion::crossing}));
              for (B& scene : scenes) scene.talkers = 2;
            }));
  suite.add("ego", 12, with([](Dealer&, std::vector<B>& scenes) {
              for (B& scene : scenes) {
                scene.noise = BenchNoise::ego;
                scene.snr_db = 0;
              }
            }));
  suite.add("alone", 8, with(talkers(1)));
  return suite.take();
}

std::vector<BenchScene> select(std::span<const BenchScene> suite, const Selection& selection) {
  const auto words = words_of(selection.filter);
  std::vector<BenchScene> left;
  for (const BenchScene& scene : suite) {
    if (selection.half == Selection::Half::train && scene.test) continue;
    if (selection.half == Selection::Half::test && !scene.test) continue;
    if (std::ranges::all_of(words, [&](const std::string& word) { return holds(scene, word); })) {
      left.push_back(scene);
    }
  }
  if (selection.most == 0 || selection.most >= left.size()) return left;
  std::vector<BenchScene> picked;
  for (std::size_t i = 0; i < selection.most; ++i) {
    picked.push_back(left[(2 * i + 1) * left.size() / (2 * selection.most)]);
  }
  return picked;
}

std::vector<std::string> unknown_words(std::span<const BenchScene> suite, const std::string& filter) {
  std::vector<std::string> unknown = words_of(filter);
  std::erase_if(unknown, [&](const std::string& word) {
    return std::ranges::any_of(suite, [&](const BenchScene& scene) { return holds(scene, word); });
  });
  return unknown;
}

}  // namespace odas
