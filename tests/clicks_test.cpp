// SPDX-License-Identifier: MIT
// Births, deaths, changes of a slot's talker and talkers who move make no click.
#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>

#include "support/wave_field.hpp"
#include <gtest/gtest.h>

#include "odas/dsp/mcra.hpp"
#include "odas/dsp/stft.hpp"
#include "odas/separation/registry.hpp"

namespace odas::clicks_test {
namespace {

constexpr std::size_t kFrame = 256;
constexpr double kRate = 16000;

/// Low tones from `u`, as the microphones hear them: from sample to sample they go by small steps alone, and
/// so a click stands out.
Grid<float> tones(const GeneralConfig& general, Vec3 u, std::size_t samples) {
  Grid<float> mics(general.mics.size(), samples);
  for (std::size_t m = 0; m < mics.rows(); ++m) {
    const auto& p = general.mics[m].mu;
    const double ahead = static_cast<double>(dot({p[0], p[1], p[2]}, u) / general.speedofsound.mu);
    for (std::size_t n = 0; n < samples; ++n) {
      const double t = static_cast<double>(n) / kRate + ahead;
      for (const double hertz : {190.0, 310.0, 470.0, 620.0}) {
        mics[m][n] += static_cast<float>(0.1 * std::sin(2 * M_PI * hertz * t + hertz));
      }
    }
  }
  return mics;
}

float largest_step(std::span<const float> x) {
  float step = 0;
  for (std::size_t n = 1; n < x.size(); ++n) step = std::max(step, std::abs(x[n] - x[n - 1]));
  return step;
}

/// Who is in the two slots in a hop.
using Script = std::function<void(double seconds, std::span<Track>)>;

struct Case {
  const char* name;
  Script script;
};

const std::vector<Case>& cases() {
  static const auto front = [](std::uint64_t id, float azimuth) {
    return test::track(id, direction_of(azimuth, 20));
  };
  static const std::vector<Case> all{
      {"steady", [](double, std::span<Track> t) { t[0] = front(1, 30); }},
      {"births_and_deaths",
       [](double s, std::span<Track> t) {
         const auto turn = static_cast<std::uint64_t>(s / 0.137);  // no multiple of any hop
         t[0] = turn % 2 == 0 ? front(turn + 1, 30) : Track{};
       }},
      {"others_come_and_go",
       [](double s, std::span<Track> t) {
         const auto turn = static_cast<std::uint64_t>(s / 0.137);
         t[0] = front(1, 30);
         t[1] = turn % 2 == 0 ? front(turn + 2, 110) : Track{};
       }},
      {"slot_changes_hands",
       [](double s, std::span<Track> t) {
         const auto turn = static_cast<std::uint64_t>(s / 0.137);
         t[0] = front(turn + 1, turn % 2 == 0 ? 30 : 150);
       }},
      {"walks", [](double s, std::span<Track> t) { t[0] = front(1, static_cast<float>(90 * s)); }},
      {"jumps", [](double s, std::span<Track> t) { t[0] = front(1, std::fmod(s, 0.4) < 0.2 ? 30 : 170); }},
  };
  return all;
}

class Clicks : public testing::TestWithParam<std::tuple<std::string_view, std::size_t>> {
 protected:
  struct Sound {
    std::vector<float> separated, postfiltered;  // of the first slot
  };

  [[nodiscard]] Sound play(const Script& script, const std::string& mode_pf) const {
    const auto& [mode_sep, hop] = GetParam();
    SssConfig config;
    config.mode_sep = std::string(mode_sep);
    config.mode_pf = mode_pf;
    const auto beamformer = make_beamformer(config, general_, 2);
    const auto filter = make_post_filter(config, {}, general_, 2);
    constexpr std::size_t kBins = kFrame / 2 + 1;
    Stft stft(general_.mics.size(), hop, kFrame);
    Mcra noise({}, general_.mics.size(), kBins);
    Istft separated(2, hop, kFrame);
    Istft filtered(2, hop, kFrame);
    Grid<cfloat> spectra(general_.mics.size(), kBins), beams(2, kBins), clean(2, kBins);
    Grid<float> out(2, hop);
    std::vector<Track> tracks(2);
    Sound sound;
    for (std::size_t begin = 0; begin + hop <= mics_.cols(); begin += hop) {
      stft.analyse({mics_.data() + begin, mics_.rows(), hop, mics_.cols()}, spectra);
      noise.update(spectra);
      script(static_cast<double>(begin) / kRate, tracks);
      beamformer->separate(spectra, tracks, beams);
      filter->apply(spectra, noise.psd(), tracks, *beamformer, beams, clean);
      separated.synthesise(beams, out);
      sound.separated.insert(sound.separated.end(), out[0].begin(), out[0].end());
      filtered.synthesise(clean, out);
      sound.postfiltered.insert(sound.postfiltered.end(), out[0].begin(), out[0].end());
    }
    return sound;
  }

  GeneralConfig general_ = test::ring(8, 0.05F);
  Grid<float> mics_ = tones(general_, direction_of(30, 20), 32000);
};

TEST_P(Clicks, no_step_is_6_dB_over_those_of_the_sound_itself) {
  const float own = largest_step(mics_[0]);
  float largest = 0;
  for (const Case& c : cases()) {
    for (const char* pf : {"ms", "ss"}) {
      const Sound sound = play(c.script, pf);
      for (const auto* voice : {&sound.separated, &sound.postfiltered}) {
        EXPECT_LT(largest_step(*voice), 2 * own) << c.name << ' ' << pf;
        largest = std::max(largest, largest_step(*voice));
        // Steady tones are noise to beamformers that learn; what ms and ss leave of it is up to them.
        const bool learns = std::get<0>(GetParam()).starts_with("dm") || std::get<0>(GetParam()) == "dgev";
        if (learns && voice == &sound.postfiltered) continue;
        EXPECT_GT(largest_step(*voice), 0.1 * own) << "or nothing is heard; " << c.name << ' ' << pf;
      }
    }
  }
  std::cout << "  largest step: " << 20 * std::log10(largest / own) << " dB over that of the sound\n";
}

INSTANTIATE_TEST_SUITE_P(All, Clicks,
                         testing::Combine(testing::ValuesIn(beamformer_names()),
                                          testing::Values(kFrame / 4, kFrame / 2, kFrame)),
                         [](const auto& test) {
                           return std::string(std::get<0>(test.param)) + "_hop_" +
                                  std::to_string(std::get<1>(test.param));
                         });

}  // namespace
}  // namespace odas::clicks_test
