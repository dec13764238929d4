// SPDX-License-Identifier: MIT
#include "odas/scene/bench_suite.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

namespace odas::bench_suite_test {
namespace {

TEST(BenchSuite, Has_at_least_300_scenes_of_hearing_and_100_of_separation_half_of_them_to_report_on) {
  for (const auto& [suite, least] :
       {std::pair{accuracy_suite(), 300U}, std::pair{separation_suite(), 100U}}) {
    EXPECT_GE(suite.size(), least);
    EXPECT_EQ(std::ranges::count(suite, true, &BenchScene::test) * 2, static_cast<long>(suite.size()));
    std::set<std::string> names;
    for (const BenchScene& scene : suite) names.insert(scene.name());
    EXPECT_EQ(names.size(), suite.size());
  }
}

TEST(BenchSuite, Every_level_of_every_condition_is_in_both_halves_about_equally_often) {
  for (const bool test : {false, true}) {
    std::map<std::string, int> arrays;
    std::map<float, int> rooms, snrs, distances;
    for (const BenchScene& scene : accuracy_suite()) {
      if (scene.group != "mixed" || scene.test != test) continue;
      ++arrays[scene.array];
      ++rooms[scene.rt60];
      ++snrs[scene.snr_db];
      ++distances[scene.distance];
    }
    EXPECT_EQ(arrays.size(), 7U);
    EXPECT_EQ(rooms.size(), 5U);
    EXPECT_EQ(snrs.size(), 5U);
    EXPECT_EQ(distances.size(), 6U);
    const auto even = [](const auto& counts) {
      const auto fewer = [](const auto& a, const auto& b) { return a.second < b.second; };
      const auto ends = std::minmax_element(counts.begin(), counts.end(), fewer);
      return ends.second->second - ends.first->second <= 1;
    };
    EXPECT_TRUE(even(arrays) && even(rooms) && even(snrs) && even(distances));
  }
}

TEST(BenchSuite, Same_seed_same_scenes_and_another_seed_others) {
  const auto a = accuracy_suite(1), b = accuracy_suite(1), c = accuracy_suite(2);
  std::size_t same = 0;
  ASSERT_EQ(a.size(), c.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].text(), b[i].text());
    same += a[i].seed == c[i].seed ? 1 : 0;
  }
  EXPECT_EQ(same, 0U);
}

TEST(BenchSuite, No_scene_of_one_half_has_a_seed_of_the_other) {
  std::set<std::uint32_t> seeds;
  const auto suite = accuracy_suite();
  for (const BenchScene& scene : suite) seeds.insert(scene.seed);
  EXPECT_EQ(seeds.size(), suite.size());
}

TEST(BenchSuite, Selection_takes_whole_words_of_one_half_evenly) {
  const auto suite = accuracy_suite();
  for (const BenchScene& scene : select(suite, {Selection::Half::test, "mixed/ snr=0 ps3_eye", 0})) {
    EXPECT_TRUE(scene.test);
    EXPECT_EQ(scene.snr_db, 0);
    EXPECT_EQ(scene.array, "ps3_eye");
    EXPECT_EQ(scene.group, "mixed");
  }
  EXPECT_TRUE(select(suite, {Selection::Half::both, "rt60=0.", 0}).empty());
  const auto few = select(suite, {Selection::Half::train, "", 20});
  EXPECT_EQ(few.size(), 20U);
  EXPECT_EQ(few.front().group, "mixed");
  EXPECT_EQ(few.back().group, "silence");
}

TEST(BenchSuite, Says_which_words_no_scene_has) {
  const auto suite = accuracy_suite();
  EXPECT_TRUE(unknown_words(suite, "mixed/ rt60=0.4").empty());
  EXPECT_EQ(unknown_words(suite, "mixed/ rt60=0.41"), std::vector<std::string>{"rt60=0.41"});
}

}  // namespace
}  // namespace odas::bench_suite_test
