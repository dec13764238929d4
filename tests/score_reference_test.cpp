// SPDX-License-Identifier: MIT
// Our figures for ODAS's own output on the shared scenes, against those that the reference scorer printed for
// it (score/odas.md, which keeps two decimals).
#include <algorithm>
#include <cmath>

#include "support/goldens.hpp"
#include <gtest/gtest.h>

#include "odas/scene/score.hpp"
#include "odas/scene/truth_file.hpp"

namespace odas::score_reference_test {
namespace {

struct Row {
  const char* scene;
  double recall, error, false_s, switches, onset, potentials;  // by azimuth
  double recall_3d, error_3d, false_s_3d;                      // error -1: none
};

constexpr std::array kReference{
    Row{"cma16_static2", 0.97, 2.02, 0.00, 0.00, 0.25, 0.87, 0.97, 2.31, 0.00},
    Row{"oma16_static2", 0.98, 0.73, 0.00, 0.00, 0.20, 0.82, 0.98, 1.70, 0.00},
    Row{"rsp4_cross2", 0.78, 5.81, 20.61, 11.25, 0.89, 0.79, 0.21, 10.55, 84.75},
    Row{"rsp4_moving1", 0.90, 4.26, 4.77, 0.00, 0.15, 0.71, 0.43, 12.84, 31.65},
    Row{"rsp4_noisy1", 0.16, 6.39, 42.72, 0.00, 1.72, 0.16, 0.00, -1, 50.73},
    Row{"rsp4_static1", 0.93, 8.33, 5.46, 0.00, 0.08, 0.68, 0.14, 14.55, 51.36},
    Row{"rsp4_static2", 0.93, 3.42, 0.00, 0.00, 0.93, 0.83, 0.23, 13.33, 79.29},
    Row{"uma7_static2", 0.94, 1.83, 0.00, 1.88, 0.69, 0.84, 0.49, 8.79, 54.18},
    Row{"uma7_static4", 0.78, 1.86, 0.00, 6.75, 0.46, 0.83, 0.57, 10.68, 49.58},
};

Direction direction_of(const test::GoldenRow& row) { return {row.x, row.y, row.z}; }

Audition golden_audition(const std::filesystem::path& folder) {
  Audition audition;
  for (const test::GoldenHop& hop : test::read_goldens(folder / "tracks.json.gz")) {
    HeardHop heard{hop.time - 1, {}};
    for (std::size_t slot = 0; slot < hop.rows.size(); ++slot) {
      const test::GoldenRow& row = hop.rows[slot];
      if (row.id != 0) heard.tracks.push_back({slot, row.id, direction_of(row)});
    }
    audition.tracks.push_back(std::move(heard));
  }
  audition.potentials.emplace();
  for (const test::GoldenHop& hop : test::read_goldens(folder / "pots.json.gz")) {
    if (hop.rows.empty()) continue;
    const auto strongest = std::ranges::max_element(hop.rows, {}, &test::GoldenRow::value);
    audition.potentials->push_back({hop.time - 1, direction_of(*strongest)});
  }
  return audition;
}

Score score_of(const std::filesystem::path& scene) {
  return score(read_truth(scene), std::nullopt, golden_audition(scene / "odas"));
}

/// The table was rounded to three decimals first, and from there to two.
constexpr double kPrinted = 0.00551;

TEST(Score, of_odas_on_the_shared_scenes_is_the_reference_scorers) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no shared scenes here: set ODAS_SHARED";
  for (const Row& row : kReference) {
    SCOPED_TRACE(row.scene);
    const Score result = score_of(*shared / "scenes" / row.scene);
    EXPECT_NEAR(*result.azimuth.tracks.recall, row.recall, kPrinted);
    EXPECT_NEAR(*result.azimuth.tracks.error_deg, row.error, kPrinted);
    EXPECT_NEAR(result.azimuth.tracks.false_s_per_min, row.false_s, kPrinted);
    EXPECT_NEAR(*result.azimuth.tracks.switches_per_min, row.switches, kPrinted);
    EXPECT_NEAR(*result.azimuth.tracks.onset_s, row.onset, kPrinted);
    EXPECT_NEAR(*result.azimuth.potentials.hits, row.potentials, kPrinted);
    EXPECT_NEAR(*result.angle.tracks.recall, row.recall_3d, kPrinted);
    EXPECT_NEAR(result.angle.tracks.error_deg.value_or(-1), row.error_3d, kPrinted);
    EXPECT_NEAR(result.angle.tracks.false_s_per_min, row.false_s_3d, kPrinted);
  }
}

TEST(Score, of_odas_on_noise_alone_is_the_reference_scorers) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no shared scenes here: set ODAS_SHARED";
  const Score result = score_of(*shared / "scenes" / "rsp4_noise_only");
  EXPECT_NEAR(result.azimuth.tracks.false_s_per_min, 21.66, kPrinted);
  EXPECT_FALSE(result.azimuth.tracks.recall.has_value());
}

}  // namespace
}  // namespace odas::score_reference_test
