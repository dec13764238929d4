// SPDX-License-Identifier: MIT
// Runs ODAS's own configurations on scenes of which ODAS's output is known.
#include <gtest/gtest.h>
#include <sndfile.h>

#include <iostream>
#include <map>
#include <set>

#include "odas/config/reader.hpp"
#include "odas/pipeline/pipeline.hpp"
#include "support/goldens.hpp"

namespace odas {
namespace {

using test::GoldenHop;
using test::thousandths;

constexpr float kOneDegree = 1;

float angle_deg(Vec3 a, Vec3 b) { return degrees(std::acos(std::clamp(dot(normalized(a), normalized(b)), -1.F, 1.F))); }

/// The recording as [mic][frame], with the hop of silence that ODAS puts first.
Grid<float> read_recording(const std::filesystem::path& file, std::size_t hop) {
  SF_INFO info{};
  SNDFILE* sound = sf_open(file.c_str(), SFM_READ, &info);
  if (sound == nullptr) throw std::runtime_error("cannot read " + file.string());
  const auto channels = static_cast<std::size_t>(info.channels);
  const std::size_t frames = static_cast<std::size_t>(info.frames) / hop * hop;
  std::vector<float> interleaved(frames * channels);
  sf_readf_float(sound, interleaved.data(), static_cast<sf_count_t>(frames));
  sf_close(sound);
  Grid<float> mics(channels, frames + hop);
  for (std::size_t n = 0; n < frames; ++n) {
    for (std::size_t m = 0; m < channels; ++m) mics[m][hop + n] = interleaved[n * channels + m];
  }
  return mics;
}

struct Ours {
  std::vector<std::vector<Potential>> potentials;  // [hop]
  std::vector<std::vector<Track>> tracks;          // [hop]
};

Ours run(const std::filesystem::path& scene) {
  PipelineConfig config = load_configuration(scene / "odas/odas.cfg").config.pipeline;
  config.wanted = {.potentials = true, .tracks = true, .separated = false, .postfiltered = false};
  Pipeline pipeline(config);
  const std::size_t hop = pipeline.hop_size();
  const Grid<float> mics = read_recording(scene / "mics.wav", hop);
  Ours ours;
  for (std::size_t n = 0; n + hop <= mics.cols(); n += hop) {
    const HopResult result = pipeline.process_hop({mics.data() + n, mics.rows(), hop, mics.cols()});
    ours.potentials.emplace_back(result.potentials.begin(), result.potentials.end());
    ours.tracks.emplace_back(result.tracks.begin(), result.tracks.end());
  }
  return ours;
}

class Conformance : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const auto shared = test::shared_folder();
    if (!shared) GTEST_SKIP() << "no shared/scenes on this machine";
    scene_ = *shared / "scenes" / GetParam();
  }
  std::filesystem::path scene_;
};

TEST_P(Conformance, Potentials_are_those_that_ODAS_prints) {
  const Ours ours = run(scene_);
  const std::vector<GoldenHop> golden = test::read_goldens(scene_ / "odas/pots.json.gz");
  ASSERT_EQ(ours.potentials.size(), golden.size());
  std::size_t same = 0;
  std::size_t all = 0;
  std::size_t strongest_near = 0;
  std::map<std::size_t, std::size_t> different;  // [place among the hop's potentials]
  for (std::size_t h = 0; h < golden.size(); ++h) {
    for (std::size_t s = 0; s < golden[h].rows.size(); ++s, ++all) {
      const auto& theirs = golden[h].rows[s];
      const Potential& own = ours.potentials[h][s];
      const bool equal = thousandths(own.direction.x) == thousandths(theirs.x) &&
                         thousandths(own.direction.y) == thousandths(theirs.y) &&
                         thousandths(own.direction.z) == thousandths(theirs.z) &&
                         thousandths(own.energy) == thousandths(theirs.value);
      same += equal ? 1 : 0;
      if (!equal) ++different[s];
    }
    const auto strongest = [](const auto& list, auto energy) {
      return *std::max_element(list.begin(), list.end(), [&](auto& a, auto& b) { return energy(a) < energy(b); });
    };
    const auto theirs = strongest(golden[h].rows, [](const test::GoldenRow& r) { return r.value; });
    const Potential own = strongest(ours.potentials[h], [](const Potential& p) { return p.energy; });
    strongest_near += angle_deg({theirs.x, theirs.y, theirs.z}, own.direction) <= kOneDegree ? 1 : 0;
  }
  const double share = static_cast<double>(same) / static_cast<double>(all);
  const double near = static_cast<double>(strongest_near) / static_cast<double>(golden.size());
  std::cout << "  " << GetParam() << ": potentials equal " << 100 * share << " %, strongest within 1 degree "
            << 100 * near << " % of hops; different by place:";
  for (const auto& [place, count] : different) std::cout << " " << place << ":" << count;
  std::cout << "\n";
  EXPECT_GE(share, 0.99);
  EXPECT_GE(near, 0.999);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Conformance,
                         ::testing::Values("rsp4_static1", "rsp4_static2", "rsp4_moving1", "rsp4_cross2",
                                           "rsp4_noisy1", "rsp4_noise_only", "uma7_static2", "uma7_static4",
                                           "oma16_static2", "cma16_static2"),
                         [](const auto& scene) { return std::string(scene.param); });

}  // namespace
}  // namespace odas
