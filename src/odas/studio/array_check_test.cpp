// SPDX-License-Identifier: MIT
#include "odas/studio/array_check.hpp"

#include <cmath>

#include "support/studio_parts.hpp"
#include <gtest/gtest.h>

namespace odas::array_check_test {
namespace {

using nlohmann::json;

TEST(ArrayCheck, says_of_the_sample_array_what_its_geometry_comes_to) {
  const Document sample = test::sample_document();
  const json answer = check_array(read_configuration_text(sample.text, sample.source_name()));
  ASSERT_TRUE(answer.contains("aperture")) << answer.dump();
  EXPECT_EQ(answer.at("mics").size(), 4U);
  EXPECT_NEAR(answer.at("aperture").get<double>(), 0.064, 1e-6);
  EXPECT_NEAR(answer.at("aliasing_hz").get<double>(), 343.0 / (2 * 0.032 * std::sqrt(2.0)), 1);
  EXPECT_NEAR(answer.at("aliasing_hz_worst").get<double>(), 343.0 / 0.128, 1);
  EXPECT_EQ(answer.at("pairs"), 6);
  EXPECT_TRUE(answer.at("flat").get<bool>());
  const json& map = answer.at("error_map");
  ASSERT_EQ(map.at("directions").size(), 642U);
  EXPECT_EQ(map.at("degrees").size(), 642U);
  EXPECT_GT(map.at("degrees").at(0).get<double>(), 0);
}

TEST(ArrayCheck, of_what_is_wrong_says_the_faults) {
  const json answer = check_array(read_configuration_text("general: { mics = 5; };", "text"));
  EXPECT_FALSE(answer.at("faults").empty());
  EXPECT_FALSE(answer.contains("aperture"));
}

}  // namespace
}  // namespace odas::array_check_test
