// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "odas/scene/bench_scene.hpp"

namespace odas {

/// The scenes of `odas bench accuracy`, the training half before the test half of each group:
///   mixed      256  all conditions, each level of each as often as the others, independently
///   crossing    24  two talkers change places; quiet, rt60 0.2 to 0.4 s
///   loud        30  one talker, 0 dB of diffuse noise; 4, 7, 16 microphones
///   ego         30  one talker, a fan and two motors close by at 0 dB; 4, 7, 16 microphones
///   silence     14  nobody speaks; a fan somewhere, or a crowd
/// `seed`: another one makes other scenes of the same kinds.
[[nodiscard]] std::vector<BenchScene> accuracy_suite(std::uint32_t seed = 1);

/// The scenes of `odas bench separation`:
///   two         48  two talkers, still
///   three       12
///   noise       24  a talker and diffuse, fan or babble noise at 0 to 5 dB
///   moving      16  two talkers, who walk or cross
///   ego         12  a talker beside a fan and two motors
///   alone        8  one talker in quiet: what a method must not harm
[[nodiscard]] std::vector<BenchScene> separation_suite(std::uint32_t seed = 1);

/// A part of a suite.
struct Selection {
  enum class Half { both, train, test };
  Half half = Half::both;
  std::string filter;    // words that the text of a scene must all hold; a word may be "rt60=0.4", "ego/"
  std::size_t most = 0;  // scenes, evenly from all that are left; 0: all
};
[[nodiscard]] std::vector<BenchScene> select(std::span<const BenchScene> suite, const Selection& selection);

/// Words of the filter that no scene of the suite holds: they were misspelt.
[[nodiscard]] std::vector<std::string> unknown_words(std::span<const BenchScene> suite,
                                                     const std::string& filter);

}  // namespace odas
