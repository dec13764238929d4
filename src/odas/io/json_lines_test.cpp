// SPDX-License-Identifier: MIT
#include <string>

#include "support/allocation_counter.hpp"
#include "support/fake_io.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "odas/io/hop_encoder.hpp"

namespace odas::json_lines_test {
namespace {

using namespace std::chrono_literals;

StreamClock clock_of(std::chrono::system_clock::duration since_epoch) {
  return {0.008, std::chrono::system_clock::time_point(since_epoch)};
}

std::string encoded(HopEncoder& encoder, const test::HopOfHand& hop, HopIndex time) {
  const auto bytes = encoder.encode(hop.result(time));
  return {bytes.begin(), bytes.end()};
}

TEST(JsonLines, of_tracks_is_one_line_with_angles_and_times_and_without_empty_slots) {
  test::HopOfHand hop;
  hop.tracks.resize(3);
  hop.tracks[1] = {7, "dynamic", {0, 1, 0}, 0.5F};
  hop.potentials = {{{1, 0, 0}, 0.9F}, {direction_of(80, 0), 0.25F}, {direction_of(90, 10), 0.125F}};
  EXPECT_EQ(encoded(*make_json_lines_tracks(clock_of(1735689600s)), hop, 126),
            "{\"timeStamp\":126,\"time\":1.000000,\"utc\":\"2025-01-01T00:00:01.000Z\",\"src\":["
            "{\"slot\":1,\"id\":7,\"tag\":\"dynamic\",\"x\":0.000,\"y\":1.000,\"z\":0.000,"
            "\"azimuth\":90.000,\"elevation\":0.000,\"activity\":0.500,\"E\":0.250}]}\n");
}

TEST(JsonLines, of_tracks_has_the_doubt_along_azimuth_and_elevation_where_it_is_known) {
  test::HopOfHand hop;
  hop.tracks.resize(2);
  hop.tracks[0].id = 1;
  hop.tracks[1].id = 2;
  hop.tracks[1].covariance = {radians(2) * radians(2), radians(9.5F) * radians(9.5F), 0};
  const auto json = nlohmann::json::parse(encoded(*make_json_lines_tracks(clock_of(0s)), hop, 1));
  EXPECT_FALSE(json["src"][0].contains("sigma_deg"));
  ASSERT_EQ(json["src"][1]["sigma_deg"].size(), 2U);
  EXPECT_NEAR(json["src"][1]["sigma_deg"][0].get<double>(), 2, 1e-3);
  EXPECT_NEAR(json["src"][1]["sigma_deg"][1].get<double>(), 9.5, 1e-3);
}

TEST(JsonLines, of_tracks_has_the_class_where_it_is_known) {
  test::HopOfHand hop;
  hop.tracks.resize(2);
  hop.tracks[0].id = 1;
  hop.tracks[1].id = 2;
  hop.tracks[1].category = Category::speech;
  const auto json = nlohmann::json::parse(encoded(*make_json_lines_tracks(clock_of(0s)), hop, 1));
  EXPECT_FALSE(json["src"][0].contains("class"));
  EXPECT_EQ(json["src"][1]["class"], "speech");
}

TEST(JsonLines, of_a_track_with_no_potential_near_it_has_no_energy) {
  test::HopOfHand hop;
  hop.tracks = {{7, "dynamic", {0, 1, 0}, 0.5F}};
  hop.potentials = {{{1, 0, 0}, 0.9F}, {{0, 1, 0}, -0.25F}};
  const auto encoder = make_json_lines_tracks(clock_of(0s));
  EXPECT_TRUE(encoder->wanted().potentials);
  EXPECT_EQ(nlohmann::json::parse(encoded(*encoder, hop, 1))["src"][0]["E"], 0.0);
}

TEST(JsonLines, of_categories_has_slot_id_and_class_of_those_who_live) {
  test::HopOfHand hop;
  hop.tracks.resize(2);
  hop.tracks[1].id = 7;
  hop.tracks[1].category = Category::nonspeech;
  EXPECT_EQ(encoded(*make_json_lines_categories(clock_of(0s)), hop, 1),
            "{\"timeStamp\":1,\"time\":0.000000,\"utc\":\"1970-01-01T00:00:00.000Z\",\"src\":["
            "{\"slot\":1,\"id\":7,\"class\":\"nonspeech\"}]}\n");
}

TEST(JsonLines, of_potentials_has_all_of_them_with_E) {
  test::HopOfHand hop;
  hop.potentials.resize(2);
  hop.potentials[0] = {{-1, 0, 0}, 0.25F};
  const std::string line = encoded(*make_json_lines_potentials(clock_of(0s)), hop, 1);
  EXPECT_EQ(line.find('\n'), line.size() - 1);
  const auto json = nlohmann::json::parse(line);
  EXPECT_EQ(json["utc"], "1970-01-01T00:00:00.000Z");
  ASSERT_EQ(json["src"].size(), 2U);
  EXPECT_EQ(json["src"][0]["E"], 0.25);
  EXPECT_EQ(json["src"][0]["azimuth"], 180.0);
  EXPECT_EQ(json["src"][1]["elevation"], 90.0);
}

TEST(JsonLines, of_a_hop_with_nobody_is_an_empty_list) {
  test::HopOfHand hop;
  hop.tracks.resize(4);
  const auto json = nlohmann::json::parse(encoded(*make_json_lines_tracks(clock_of(0s)), hop, 1));
  EXPECT_TRUE(json["src"].is_array());
  EXPECT_TRUE(json["src"].empty());
}

TEST(JsonLines, numbers_that_are_not_counts_have_a_decimal_point) {
  test::HopOfHand hop;
  hop.tracks = {{7, "", {1, 0, 0}, 1}};
  const auto json = nlohmann::json::parse(encoded(*make_json_lines_tracks(clock_of(0s)), hop, 1));
  EXPECT_TRUE(json["time"].is_number_float());
  for (const char* key : {"x", "y", "z", "azimuth", "elevation", "activity", "E"}) {
    EXPECT_TRUE(json["src"][0][key].is_number_float()) << key;
  }
}

TEST(JsonLines, time_of_day_carries_over_midnight_and_leap_days) {
  const auto at = [](std::chrono::system_clock::duration since_epoch) {
    return nlohmann::json::parse(encoded(*make_json_lines_tracks(clock_of(since_epoch)), {}, 1))["utc"];
  };
  EXPECT_EQ(at(1709251199999ms), "2024-02-29T23:59:59.999Z");
  EXPECT_EQ(at(1709251200000ms), "2024-03-01T00:00:00.000Z");
}

TEST(JsonLines, allocates_nothing_for_a_hop) {
  test::HopOfHand hop;
  hop.tracks = {{7, "dynamic", {1, 0, 0}, 1}};
  hop.potentials.resize(4);
  const auto tracks = make_json_lines_tracks(clock_of(0s));
  const auto potentials = make_json_lines_potentials(clock_of(0s));
  const auto before = test::allocations();
  static_cast<void>(tracks->encode(hop.result(1)));
  static_cast<void>(potentials->encode(hop.result(1)));
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace odas::json_lines_test
