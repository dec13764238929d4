// SPDX-License-Identifier: MIT
// A machine with two fans, of which one runs at a time, for tests of what learns its noise.
#pragma once

#include <cmath>

#include "support/wave_field.hpp"

#include "odas/dsp/noise_learner.hpp"

namespace odas::test {

class Machine {
 public:
  static constexpr std::size_t kMics = 4;
  static constexpr std::size_t kBins = 129;
  static constexpr int kRate = 16000;
  static constexpr std::size_t kHop = 128;

  explicit Machine(unsigned seed = 1) : noise_(seed) {}

  /// Spectra of a hop: fan 0 or 1 as loud as `level`, weak white noise in each microphone, and a talker as
  /// loud as `talk`.
  Grid<cfloat> hop(int fan, float level = 1, float talk = 0) {
    Grid<cfloat> spectra = noise_(kMics, kBins);
    for (std::size_t m = 0; m < kMics; ++m) {
      for (cfloat& x : spectra[m]) x *= 0.05F * level;
    }
    std::vector<cfloat> source = noise_(kBins);
    for (cfloat& x : source) x *= level;
    add_plane_wave(array(), direction_of(fan == 0 ? 40 : 200, 0), source, spectra);
    source = noise_(kBins);
    for (cfloat& x : source) x *= talk;
    add_plane_wave(array(), talker(), source, spectra);
    return spectra;
  }

  static Vec3 talker() { return direction_of(120, 0); }
  static const GeneralConfig& array() {
    static const GeneralConfig general = ring(kMics, 0.05F);
    return general;
  }
  static std::vector<Vec3> places() {
    std::vector<Vec3> places;
    for (const MicConfig& mic : array().mics) places.push_back({mic.mu[0], mic.mu[1], mic.mu[2]});
    return places;
  }
  static NoiseLearner learner() { return {kRate, kHop, 2 * (kBins - 1), places()}; }

  /// Two seconds of each fan.
  static NoiseDictionary dictionary() {
    Machine machine(7);
    NoiseLearner learner = Machine::learner();
    for (const int fan : {0, 1}) {
      for (int h = 0; h < 250; ++h) learner.hear(machine.hop(fan));
    }
    return learner.learn(NoiseDictionary::kMostEntries);
  }

 private:
  Noise noise_;
};

}  // namespace odas::test
