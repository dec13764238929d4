// SPDX-License-Identifier: MIT
// The sample recording: what is heard in it, against its truth, and that its scene makes it again.
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "support/program.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <sndfile.hh>

#include "odas/scene/score.hpp"
#include "odas/scene/truth_file.hpp"

namespace odas::sample_test {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = ODAS_SOURCE_DIR;
const fs::path kSamples = kSource / "samples";

class Sample : public ::testing::Test {
 protected:
  [[nodiscard]] std::string out() const { return out_.string(); }

  test::Scratch scratch_;
  fs::path out_ = scratch_ / "out";
};

/// 16 bit, the channels interleaved.
std::vector<short> samples_of(const fs::path& file) {
  SndfileHandle sound(file.string());
  std::vector<short> samples(static_cast<std::size_t>(sound.frames() * sound.channels()));
  sound.readf(samples.data(), sound.frames());
  return samples;
}

TEST_F(Sample, is_heard_both_talkers_one_track_each) {
  const auto run =
      test::run_program({test::program_path("odas"), "run", (kSamples / "sample_4mic.flac").string(), "-c",
                         (kSource / "configs" / "sample.cfg").string(), "-o", out()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const KnownScene scene = read_truth(kSamples / "sample_truth.json");
  const TrackScore tracks = score_tracks(scene, read_audition(out_, scene).tracks, Measure::azimuth);
  // Measured: recall 0.992, error 1.4 degrees, 2.6 s of false tracks a minute, no change of id, 0.08 s.
  EXPECT_GT(*tracks.recall, 0.92);
  EXPECT_LT(*tracks.error_deg, 6.5);
  EXPECT_LT(tracks.false_s_per_min, 4);
  EXPECT_EQ(*tracks.switches_per_min, 0);
  EXPECT_LT(*tracks.onset_s, 0.5);
}

TEST_F(Sample, is_small) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::directory_iterator(kSamples)) bytes += entry.file_size();
  EXPECT_LT(bytes, 1'400'000U);
}

TEST_F(Sample, comes_out_of_its_scene_again) {
  const auto version = test::run_program({"/usr/bin/env", "espeak-ng", "--version"});
  if (version.out.find("1.51") == std::string::npos) GTEST_SKIP() << "the voices are those of espeak-ng 1.51";
  const auto run = test::run_program(
      {test::program_path("odas"), "simulate", (kSamples / "sample_scene.json").string(), "-o", out()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  // Other machines round the last bit of an FFT in another way.
  const auto made = samples_of(out_ / "mics.wav");
  const auto kept = samples_of(kSamples / "sample_4mic.flac");
  ASSERT_EQ(made.size(), kept.size());
  int farthest = 0;
  for (std::size_t n = 0; n < made.size(); ++n) farthest = std::max(farthest, std::abs(made[n] - kept[n]));
  EXPECT_LE(farthest, 2);

  const KnownScene scene = read_truth(out_);
  const KnownScene known = read_truth(kSamples / "sample_truth.json");
  ASSERT_EQ(scene.sources.size(), known.sources.size());
  for (std::size_t k = 0; k < known.sources.size(); ++k) {
    std::size_t other = 0;
    for (std::size_t h = 0; h < known.hops; ++h) {
      const Direction a = scene.sources[k].direction[h];
      const Direction b = known.sources[k].direction[h];
      EXPECT_NEAR(a.x * b.x + a.y * b.y + a.z * b.z, 1, 1e-4);
      other += scene.sources[k].active[h] != known.sources[k].active[h] ? 1 : 0;
    }
    EXPECT_LE(other, 2U);
  }
}

}  // namespace
}  // namespace odas::sample_test
