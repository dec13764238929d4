// SPDX-License-Identifier: MIT
#include "odas/io/report_history.hpp"

#include <array>

#include <gtest/gtest.h>

namespace odas::report_history_test {
namespace {

constexpr std::size_t kHop = 128;
constexpr int kRate = 16000;  // 125 hops a second

Track track(std::uint64_t id, float azimuth, float elevation, float activity) {
  Track t;
  t.id = id;
  t.tag = "dynamic";
  t.direction = direction_of(azimuth, elevation);
  t.activity = activity;
  return t;
}

TEST(ThinnedSeries, keeps_the_whole_span_under_its_limit) {
  ThinnedSeries<int> series(1, 100);
  for (HopIndex t = 1; t <= 10'000; ++t) series.add(t, static_cast<int>(t));
  const auto& entries = series.entries();
  EXPECT_LE(entries.size(), 100U);
  EXPECT_GE(entries.size(), 50U);
  EXPECT_LE(entries.front().time, 200U);
  EXPECT_GE(entries.back().time, 9'800U);
  for (std::size_t i = 2; i < entries.size(); ++i) {
    EXPECT_EQ(entries[i].time - entries[i - 1].time, entries[1].time - entries[0].time);
  }
}

TEST(ReportHistory, knows_when_a_source_was_born_and_when_it_died) {
  ReportHistory history(kHop, kRate);
  for (HopIndex t = 1; t <= 1000; ++t) {
    const std::array tracks{t > 125 && t <= 375 ? track(7, 30, 0, 1) : Track{}};
    history.add(t, {}, tracks);
  }
  const auto sources = history.sources();
  ASSERT_EQ(sources.size(), 1U);
  EXPECT_EQ(sources[0].id, 7U);
  EXPECT_EQ(sources[0].tag, "dynamic");
  EXPECT_DOUBLE_EQ(sources[0].from_s, 1.0);
  EXPECT_DOUBLE_EQ(sources[0].to_s, 3.0);
  EXPECT_DOUBLE_EQ(sources[0].trail.front().seconds, 1.0);
  EXPECT_NEAR(sources[0].trail.back().seconds, 3.0, 0.01);
}

TEST(ReportHistory, averages_directions_across_the_wrap_of_azimuth) {
  ReportHistory history(kHop, kRate);
  for (HopIndex t = 1; t <= 250; ++t) {
    history.add(t, {}, std::array{track(1, t % 2 == 0 ? 178.F : -178.F, 0, 1)});
  }
  const auto sources = history.sources();
  EXPECT_NEAR(std::abs(azimuth_deg(sources[0].mean)), 180, 0.5);
}

TEST(ReportHistory, says_from_where_to_where_a_source_went) {
  ReportHistory history(kHop, kRate);
  for (HopIndex t = 1; t <= 1250; ++t) {
    history.add(t, {}, std::array{track(1, static_cast<float>(t) * 0.08F, 10, 1)});
  }
  const auto sources = history.sources();
  EXPECT_NEAR(azimuth_deg(sources[0].first), 2.5, 1);
  EXPECT_NEAR(azimuth_deg(sources[0].last), 97.5, 1);
  EXPECT_NEAR(elevation_deg(sources[0].mean), 10, 0.1);
}

TEST(ReportHistory, places_a_source_by_the_hops_in_which_it_sounds) {
  ReportHistory history(kHop, kRate);
  for (HopIndex t = 1; t <= 400; ++t) {
    history.add(t, {}, std::array{t <= 100 ? track(1, 20, 0, 0.9F) : track(1, 80, 0, 0.1F)});
  }
  const auto sources = history.sources();
  EXPECT_NEAR(azimuth_deg(sources[0].mean), 20, 0.1);
  EXPECT_DOUBLE_EQ(sources[0].active_share, 0.25);
}

TEST(ReportHistory, leaves_out_potentials_without_energy) {
  ReportHistory history(kHop, kRate);
  for (HopIndex t = 1; t <= 100; ++t) history.add(t, std::array{Potential{{1, 0, 0}, 0.4F}, Potential{}}, {});
  const auto potentials = history.potentials();
  ASSERT_EQ(potentials.size(), 25U);
  for (const auto& p : potentials) EXPECT_FLOAT_EQ(p.energy, 0.4F);
}

TEST(ReportTable, has_a_line_for_each_source) {
  SourceHistory still;
  still.id = 3;
  still.to_s = 4.25;
  still.active_share = 0.5;
  still.mean = direction_of(45, 10);
  still.first = direction_of(44, 9);
  still.last = direction_of(46, 11);
  SourceHistory walker = still;
  walker.id = 12;
  walker.first = direction_of(-90, 0);
  walker.last = direction_of(-30, 5);
  const std::array sources{still, walker};
  const std::string text = table_of(sources, [](std::uint64_t id) { return "v" + std::to_string(id); });
  EXPECT_NE(text.find("     3       0.0       4.2             45             10     50%  v3\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("     -90 -> -30"), std::string::npos) << text;
  EXPECT_NE(text.find("     10     50%  v12\n"), std::string::npos) << text;
  EXPECT_EQ(table_of({}, nullptr), "No source was followed.\n");
}

}  // namespace
}  // namespace odas::report_history_test
