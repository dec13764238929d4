// SPDX-License-Identifier: MIT
// How well voices part in rooms, along true directions: what separation itself can do, whoever finds the
// tracks.
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "support/goldens.hpp"
#include "support/read_sound.hpp"
#include "support/wave_field.hpp"
#include <gtest/gtest.h>

#include "odas/config/reader.hpp"
#include "odas/dsp/stft.hpp"
#include "odas/scene/projection.hpp"
#include "odas/scene/truth_file.hpp"
#include "odas/separation/registry.hpp"

namespace odas::separation_scenes_test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFrame = 512;

/// What came out of a scene: microphone 1, the images of the talkers there, and the two voices of each.
struct Heard {
  std::vector<float> mic;
  std::vector<std::vector<float>> images, separated, postfiltered;
  std::vector<std::size_t> begins;  // [talker]: sample of the first word
};

struct Sdr {
  double in = 0, separated = 0, postfiltered = 0;
};

Heard separate(const fs::path& folder, const std::string& mode_sep) {
  PipelineConfig config = load_configuration(folder / "odas" / "odas.cfg").config.pipeline;
  config.sss.mode_sep = mode_sep;
  config.sss.mode_pf = "mask";
  config.general.size.frame_size = kFrame;
  if (folder.filename().string().starts_with(
          "cma16")) {  // its file leaves the angles of the closed array open
    for (MicConfig& mic : config.general.mics) mic.angle = {80, 90};
  }
  const KnownScene scene = read_truth(folder);
  const Grid<float> mics = test::read_sound(folder / "mics.wav");
  const std::size_t slots = scene.sources.size();
  const std::size_t hop = scene.hop_size;
  const std::size_t hops = std::min(scene.hops, mics.cols() / hop);
  const std::size_t bins = kFrame / 2 + 1;
  const auto beamformer = make_beamformer(config.sss, config.general, slots);
  const auto filter = make_post_filter(config.sss, config.sne, config.general, slots);
  Stft stft(mics.rows(), hop, kFrame);
  std::array<Istft, 2> back{Istft(slots, hop, kFrame), Istft(slots, hop, kFrame)};
  Grid<cfloat> spectra(mics.rows(), bins);
  Grid<cfloat> beams(slots, bins);
  Grid<cfloat> filtered(slots, bins);
  Grid<float> in(mics.rows(), hop);
  Grid<float> out(slots, hop);
  Grid<float> voices(2 * slots, hops * hop);
  std::vector<Track> tracks(slots);
  for (std::size_t h = 0; h < hops; ++h) {
    for (std::size_t m = 0; m < mics.rows(); ++m) std::copy_n(mics[m].data() + h * hop, hop, in[m].data());
    for (std::size_t s = 0; s < slots; ++s) {
      const Direction& u = scene.sources[s].direction[h];
      tracks[s] =
          test::track(s + 1, {static_cast<float>(u.x), static_cast<float>(u.y), static_cast<float>(u.z)});
    }
    stft.analyse(in, spectra);
    beamformer->separate(spectra, tracks, beams);
    filter->apply(spectra, {}, tracks, *beamformer, beams, filtered);
    for (std::size_t stage = 0; stage < 2; ++stage) {
      back[stage].synthesise(stage == 0 ? beams : filtered, out);
      for (std::size_t s = 0; s < slots; ++s) {
        std::copy_n(out[s].data(), hop, voices[stage * slots + s].data() + h * hop);
      }
    }
  }
  const std::size_t delay = kFrame - hop;
  const std::size_t length = voices.cols() - delay;
  const auto copy = [length](std::span<const float> sound) {
    return std::vector<float>(sound.begin(), sound.begin() + static_cast<std::ptrdiff_t>(length));
  };
  Heard heard{copy(mics[0]), {}, {}, {}, {}};
  for (std::size_t s = 0; s < slots; ++s) {
    heard.images.push_back(copy(test::read_sound(folder / ("image_" + std::to_string(s) + ".wav"))[0]));
    heard.separated.push_back(copy(voices[s].subspan(delay)));
    heard.postfiltered.push_back(copy(voices[slots + s].subspan(delay)));
    const auto& active = scene.sources[s].active;
    heard.begins.push_back(static_cast<std::size_t>(std::ranges::find(active, 1) - active.begin()) * hop);
  }
  return heard;
}

/// Means over the talkers, dB, by the projection on each talker's image at microphone 1.
Sdr sdr_of(const Heard& heard) {
  Sdr sdr;
  const double share = 1 / static_cast<double>(heard.images.size());
  for (std::size_t s = 0; s < heard.images.size(); ++s) {
    sdr.in += share * sdr_db(heard.mic, heard.images[s]);
    sdr.separated += share * sdr_db(heard.separated[s], heard.images[s]);
    sdr.postfiltered += share * sdr_db(heard.postfiltered[s], heard.images[s]);
  }
  return sdr;
}

/// What separation brings to a talker in the second that begins with sample `begin`, dB.
double gain_in_second(const Heard& heard, std::size_t talker, std::size_t begin) {
  const auto part = [begin](const std::vector<float>& sound) {
    return std::span(sound).subspan(begin, std::min<std::size_t>(16000, sound.size() - begin));
  };
  const auto image = part(heard.images[talker]);
  return sdr_db(part(heard.separated[talker]), image) - sdr_db(part(heard.mic), image);
}

struct Bar {
  const char* scene;
  double separated, postfiltered;  // dB: half a dB under what was measured
};

class SeparationOfRooms : public testing::TestWithParam<Bar> {};

TEST_P(SeparationOfRooms, by_mvdr_and_masks_is_as_good_as_measured) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no shared test material (ODAS_SHARED)";
  const Bar& bar = GetParam();
  const fs::path folder = *shared / "scenes" / bar.scene;
  const Sdr mvdr = sdr_of(separate(folder, "dmvdr"));
  std::printf("%s: in %.2f dB, dmvdr %.2f dB, then mask %.2f dB\n", bar.scene, mvdr.in, mvdr.separated,
              mvdr.postfiltered);
  EXPECT_GT(mvdr.separated, bar.separated);
  EXPECT_GT(mvdr.postfiltered, bar.postfiltered);
}

/// Twelve talkers who stand still: the gain of the second that ends 1.5 s after a voice's first word, to that
/// of all seconds from the third on.
TEST(SeparationOfTalkers, has_nine_tenths_of_its_gain_within_a_second_and_a_half) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no shared test material (ODAS_SHARED)";
  double soon = 0, late = 0, talkers = 0;
  for (const char* scene :
       {"rsp4_static2", "uma7_static2", "uma7_static4", "oma16_static2", "cma16_static2"}) {
    const Heard heard = separate(*shared / "scenes" / scene, "dmvdr");
    for (std::size_t s = 0; s < heard.images.size(); ++s) {
      double sum = 0, seconds = 0;
      for (std::size_t n = heard.begins[s] + 48000; n + 16000 < heard.mic.size(); n += 8000) {
        sum += gain_in_second(heard, s, n);
        seconds += 1;
      }
      soon += gain_in_second(heard, s, heard.begins[s] + 8000);
      late += sum / seconds;
      talkers += 1;
    }
  }
  std::printf("gain within 1.5 s: %.2f dB, later: %.2f dB, %.0f talkers\n", soon / talkers, late / talkers,
              talkers);
  EXPECT_EQ(talkers, 12);
  EXPECT_GE(soon, 0.9 * late);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SeparationOfRooms,
                         testing::Values(Bar{"rsp4_static1", 19.8, 20.7}, Bar{"rsp4_static2", 7.6, 9.9},
                                         Bar{"rsp4_noisy1", 3.9, 7.6}, Bar{"uma7_static2", 5.9, 7.4},
                                         Bar{"rsp4_moving1", 20.1, 20.0}, Bar{"rsp4_cross2", 4.5, 5.4},
                                         Bar{"uma7_static4", 1.6, 5.2}, Bar{"oma16_static2", 7, 8},
                                         Bar{"cma16_static2", 7.6, 7.4}),
                         [](const testing::TestParamInfo<Bar>& bar) { return std::string(bar.param.scene); });

}  // namespace
}  // namespace odas::separation_scenes_test
