// SPDX-License-Identifier: MIT
#include "odas/config/locations.hpp"

#include <gtest/gtest.h>

namespace odas::locations_test {
namespace {

Locations some_lines() {
  Locations locations;
  locations.set_file("a.cfg");
  locations.add("general", {"a.cfg", 3});
  locations.add("general.mics", {"b.cfg", 1});
  locations.add("general.mics[2]", {"b.cfg", 9});
  return locations;
}

TEST(Locations, find_the_line_of_a_setting_or_of_what_holds_it) {
  const Locations locations = some_lines();
  EXPECT_EQ(locations.find("general.mics[2]").line, 9);
  EXPECT_EQ(locations.find("general.mics[2].mu[1]").line, 9);
  EXPECT_EQ(locations.find("general.mics[5].mu").line, 1);
  EXPECT_EQ(locations.find("general.size.hopSize").file, "a.cfg");
  EXPECT_EQ(locations.find("general.size.hopSize").line, 3);
}

TEST(Locations, know_at_least_the_file) {
  EXPECT_EQ(some_lines().find("sst.active").file, "a.cfg");
  EXPECT_EQ(some_lines().find("sst.active").line, 0);
  EXPECT_EQ(some_lines().find("").file, "a.cfg");
}

TEST(Locations, give_lines_to_the_faults_that_a_stage_throws) {
  const ConfigError error("general.mics[2].direction", "is zero");
  const ConfigError located = some_lines().locate(error);
  EXPECT_STREQ(located.what(), "b.cfg:9: error: general.mics[2].direction: is zero");
}

TEST(Locations, leave_alone_what_has_a_line_already) {
  const Fault fault = some_lines().locate({Fault::Severity::error, "general", "x", "other.cfg", 77});
  EXPECT_EQ(fault.file, "other.cfg");
  EXPECT_EQ(fault.line, 77);
}

}  // namespace
}  // namespace odas::locations_test
