// SPDX-License-Identifier: MIT
// Separation against what ODAS itself made of the same recordings, with its own tracks fed in.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "support/goldens.hpp"
#include "support/odas_ms.hpp"
#include "support/read_sound.hpp"
#include "support/wave_field.hpp"
#include <gtest/gtest.h>

#include "odas/config/reader.hpp"
#include "odas/dsp/mcra.hpp"
#include "odas/dsp/stft.hpp"
#include "odas/dsp/window.hpp"
#include "odas/separation/registry.hpp"

namespace odas::separation_conformance_test {
namespace {

namespace fs = std::filesystem;

/// ODAS's tracks, hop by hop.
std::vector<std::vector<Track>> read_tracks(const fs::path& file) {
  std::vector<std::vector<Track>> hops;
  for (const test::GoldenHop& hop : test::read_goldens(file)) {
    std::vector<Track>& tracks = hops.emplace_back();
    for (const test::GoldenRow& row : hop.rows) tracks.push_back(test::track(row.id, {row.x, row.y, row.z}));
  }
  return hops;
}

struct Streams {
  Grid<float> separated;     // [slot][sample]
  Grid<float> postfiltered;  // [slot][sample]
};

struct Scene {
  fs::path folder;
  PipelineConfig config;
  Grid<float> mics;
  std::vector<std::vector<Track>> tracks;

  Scene(const fs::path& of, const std::string& cfg)
      : folder(of),
        config(load_configuration(folder / "odas" / cfg).config.pipeline),
        mics(test::read_sound(folder / "mics.wav")),
        tracks(read_tracks(folder / "odas" / "tracks.json.gz")) {}

  [[nodiscard]] std::size_t hop() const { return static_cast<std::size_t>(config.general.size.hop_size); }

  /// ODAS's stream with its window's ripple taken out: ODAS multiplies by the window sum, ours is flat.
  [[nodiscard]] Grid<float> golden(const std::string& flac) const {
    Grid<float> sound = test::read_sound(folder / "odas" / flac);
    const auto window = root_hann(static_cast<std::size_t>(config.general.size.frame_size));
    for (std::size_t n = 0; n < hop(); ++n) {
      float sum = 0;
      for (std::size_t i = n; i < window.size(); i += hop()) sum += window[i] * window[i];
      for (std::size_t c = 0; c < sound.rows(); ++c) {
        for (std::size_t t = n; t < sound.cols(); t += hop()) sound[c][t] /= sum;
      }
    }
    return sound;
  }

  /// What ours makes of the scene. ODAS is one block late: its first hop is silence (spec 4.2).
  /// `as_odas`: with the faults of its noise estimate and of its rounding.
  [[nodiscard]] Streams run(const std::vector<std::vector<Track>>& directions, bool as_odas = false) const {
    const std::size_t slots = directions.front().size();
    const auto frame = static_cast<std::size_t>(config.general.size.frame_size);
    const std::size_t bins = frame / 2 + 1;
    const auto beamformer = make_beamformer(config.sss, config.general, slots);
    std::unique_ptr<PostFilter> filter = make_post_filter(config.sss, config.sne, config.general, slots);
    if (as_odas) {
      auto of_beams = std::make_unique<test::OdasMcra>(config.sne, slots, bins);
      filter = std::make_unique<test::OdasMultiSourceFilter>(config.sss.ms, std::move(of_beams),
                                                             config.general, slots);
    }
    const auto noise = make_noise(as_odas, bins);
    Stft stft(mics.rows(), hop(), frame);
    Istft separated(slots, hop(), frame);
    Istft postfiltered(slots, hop(), frame);
    Grid<float> in(mics.rows(), hop());
    Grid<float> out(slots, hop());
    Grid<cfloat> spectra(mics.rows(), bins);
    Grid<cfloat> beams(slots, bins);
    Grid<cfloat> filtered(slots, bins);
    std::vector<float> power(bins);
    Streams streams{Grid<float>(slots, directions.size() * hop()),
                    Grid<float>(slots, directions.size() * hop())};
    for (std::size_t h = 0; h < directions.size(); ++h) {
      if (h > 0 && h * hop() <= mics.cols()) copy_block(mics, h - 1, in, 0);
      stft.analyse(in, spectra);
      for (std::size_t m = 0; m < mics.rows(); ++m) {
        for (std::size_t k = 0; k < bins; ++k) power[k] = std::norm(spectra[m][k]);
        noise->update(m, power);
      }
      beamformer->separate(spectra, directions[h], beams);
      filter->apply(spectra, noise->psd(), directions[h], *beamformer, beams, filtered);
      separated.synthesise(beams, out);
      copy_block(out, 0, streams.separated, h);
      postfiltered.synthesise(filtered, out);
      copy_block(out, 0, streams.postfiltered, h);
    }
    return streams;
  }

  [[nodiscard]] std::unique_ptr<NoiseEstimator> make_noise(bool as_odas, std::size_t bins) const {
    if (as_odas) return std::make_unique<test::OdasMcra>(config.sne, mics.rows(), bins);
    return std::make_unique<Mcra>(config.sne, mics.rows(), bins);
  }

  void copy_block(const Grid<float>& from, std::size_t source, Grid<float>& to, std::size_t target) const {
    for (std::size_t c = 0; c < from.rows(); ++c) {
      std::copy_n(from[c].data() + source * hop(), hop(), to[c].data() + target * hop());
    }
  }
};

/// Root of the power of a - b over that of b, all channels together.
double relative_difference(const Grid<float>& a, const Grid<float>& b) {
  double error = 0;
  double power = 0;
  for (std::size_t c = 0; c < b.rows(); ++c) {
    for (std::size_t n = 0; n < std::min(a.cols(), b.cols()); ++n) {
      error += std::pow(static_cast<double>(a[c][n] - b[c][n]), 2);
      power += std::pow(static_cast<double>(b[c][n]), 2);
    }
  }
  return std::sqrt(error / power);
}

/// What rounding to 16 bits alone makes: the error is evenly spread over one step.
double rounding_floor(const Grid<float>& golden) {
  double power = 0;
  std::size_t sounding = 0;
  for (std::size_t c = 0; c < golden.rows(); ++c) {
    for (const float x : golden[c]) {
      power += static_cast<double>(x) * static_cast<double>(x);
      sounding += x != 0 ? 1 : 0;
    }
  }
  return std::sqrt(static_cast<double>(sounding) / 12 / power) / 32768;
}

/// The same tracks as if other digits had been cut: each coordinate moved by up to half a printed unit.
std::vector<std::vector<Track>> jittered(std::vector<std::vector<Track>> tracks) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-0.0005F, 0.0005F);
  for (auto& hop : tracks) {
    for (Track& track : hop) {
      track.direction = track.direction + Vec3{uniform(random), uniform(random), uniform(random)};
    }
  }
  return tracks;
}

class SeparationOfScene : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const auto shared = test::shared_folder();
    if (!shared) GTEST_SKIP() << "no shared test material (ODAS_SHARED)";
    folder_ = *shared / "scenes" / GetParam();
  }
  fs::path folder_;
};

TEST_P(SeparationOfScene, by_delay_and_sum_equals_that_of_ODAS) {
  const Scene scene(folder_, "dds_ms.cfg");
  const Grid<float> golden = scene.golden("dds.flac");
  const Streams ours = scene.run(scene.tracks);
  ASSERT_EQ(ours.separated.cols(), golden.cols());
  const double difference = relative_difference(ours.separated, golden);
  const Streams moved = scene.run(jittered(scene.tracks));
  std::printf("%s dds: relative difference %.2e; floors: of 16 bits %.2e, of three printed decimals %.2e\n",
              GetParam(), difference, rounding_floor(golden),
              relative_difference(moved.separated, ours.separated));
  EXPECT_LT(difference, 1e-3);
}

// ODAS's own noise estimate is zero for the first 303 hops of the microphones and of each beam, and so it
// lets pass more than ours, which starts with the first sound.
TEST_P(SeparationOfScene, then_by_ms_is_that_of_ODAS_but_for_the_mended_noise_estimate) {
  const Scene scene(folder_, "dds_ms.cfg");
  const double difference =
      relative_difference(scene.run(scene.tracks).postfiltered, scene.golden("dds_ms.flac"));
  std::printf("%s ms: relative difference %.2e\n", GetParam(), difference);
  EXPECT_LT(difference, 0.25);
}

TEST_P(SeparationOfScene, then_by_ms_equals_that_of_ODAS_with_its_faults_put_back) {
  const Scene scene(folder_, "dds_ms.cfg");
  const Grid<float> golden = scene.golden("dds_ms.flac");
  const Streams ours = scene.run(scene.tracks, true);
  const double difference = relative_difference(ours.postfiltered, golden);
  std::printf("%s ms with ODAS's faults: relative difference %.2e\n", GetParam(), difference);
  EXPECT_LT(difference, 2e-2);
}

TEST_P(SeparationOfScene, by_gss_and_then_by_ss_equals_that_of_ODAS) {
  const Scene scene(folder_, "dgss_ss.cfg");
  const Streams ours = scene.run(scene.tracks);
  const Grid<float> golden = scene.golden("dgss.flac");
  const Grid<float> golden_ss = scene.golden("dgss_ss.flac");
  const double gss = relative_difference(ours.separated, golden);
  const double ss = relative_difference(ours.postfiltered, golden_ss);
  std::printf("%s dgss: relative difference %.2e, floor of 16 bits %.2e; then ss: %.2e, %.2e\n", GetParam(),
              gss, rounding_floor(golden), ss, rounding_floor(golden_ss));
  EXPECT_LT(gss, 2e-3);
  EXPECT_LT(ss, 5e-3);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SeparationOfScene, testing::Values("rsp4_static2", "uma7_static2"));

}  // namespace
}  // namespace odas::separation_conformance_test
