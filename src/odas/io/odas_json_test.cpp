// SPDX-License-Identifier: MIT
#include <cstring>
#include <string>

#include "support/allocation_counter.hpp"
#include "support/fake_io.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "odas/io/hop_encoder.hpp"

namespace odas::odas_json_test {
namespace {

std::string encoded(HopEncoder& encoder, const test::HopOfHand& hop, HopIndex time) {
  const auto bytes = encoder.encode(hop.result(time));
  return {bytes.begin(), bytes.end()};
}

TEST(OdasJson, of_potentials_is_odas_s_byte_for_byte) {
  test::HopOfHand hop;
  hop.potentials.resize(2);
  hop.potentials[1] = {{-0.0001F, 0.6425F, -1}, 0.1234F};
  EXPECT_EQ(encoded(*make_odas_json_potentials(), hop, 1),
            "{\n"
            "    \"timeStamp\": 1,\n"
            "    \"src\": [\n"
            "        { \"x\": 0.000, \"y\": 0.000, \"z\": 1.000, \"E\": 0.000 },\n"
            "        { \"x\": -0.000, \"y\": 0.642, \"z\": -1.000, \"E\": 0.123 }\n"
            "    ]\n"
            "}\n");
}

TEST(OdasJson, of_tracks_is_odas_s_byte_for_byte_with_the_empty_slots) {
  test::HopOfHand hop;
  hop.tracks.resize(2);
  hop.tracks[0] = {1, "dynamic", {0.641F, 0.688F, 0.341F}, 0};
  EXPECT_EQ(
      encoded(*make_odas_json_tracks(), hop, 751),
      "{\n"
      "    \"timeStamp\": 751,\n"
      "    \"src\": [\n"
      "        { \"id\": 1, \"tag\": \"dynamic\", \"x\": 0.641, \"y\": 0.688, \"z\": 0.341, \"activity\": "
      "0.000 },\n"
      "        { \"id\": 0, \"tag\": \"\", \"x\": 0.000, \"y\": 0.000, \"z\": 0.000, \"activity\": 0.000 }\n"
      "    ]\n"
      "}\n");
}

TEST(OdasJson, of_categories_is_odas_s_byte_for_byte) {
  test::HopOfHand hop;
  hop.tracks.resize(3);
  hop.tracks[0].category = Category::speech;
  hop.tracks[1].category = Category::nonspeech;
  EXPECT_EQ(encoded(*make_odas_json_categories(), hop, 1),
            "{\n"
            "    \"timeStamp\": 1,\n"
            "    \"src\": [\n"
            "        { \"category\": \"speech\" },\n"
            "        { \"category\": \"nonspeech\" },\n"
            "        { \"category\": \"nonspeech\" }\n"
            "    ]\n"
            "}\n");
}

TEST(OdasJson, without_rows_is_an_empty_list) {
  EXPECT_EQ(encoded(*make_odas_json_potentials(), {}, 3),
            "{\n    \"timeStamp\": 3,\n    \"src\": [\n    ]\n}\n");
}

TEST(OdasJson, holds_any_number_of_tracks_and_the_longest_tags_where_odas_overflowed) {
  test::HopOfHand hop;
  hop.tracks.resize(200);
  for (std::size_t s = 0; s < hop.tracks.size(); ++s) {
    hop.tracks[s] = {~std::uint64_t{0} - s, ShortString<63>(std::string(63, '\x01')), {-1, -1, -1}, 1e30F};
  }
  const std::string text = encoded(*make_odas_json_tracks(), hop, ~std::uint64_t{0});
  const auto json = nlohmann::json::parse(text);
  ASSERT_EQ(json["src"].size(), 200U);
  EXPECT_EQ(json["src"][199]["tag"].get<std::string>(), std::string(63, '\x01'));
  EXPECT_EQ(json["src"][199]["id"].get<std::uint64_t>(), ~std::uint64_t{0} - 199);
}

TEST(OdasJson, escapes_tags) {
  test::HopOfHand hop;
  hop.tracks = {{1, "the \"front\"\n", {1, 0, 0}, 1}};
  const auto json = nlohmann::json::parse(encoded(*make_odas_json_tracks(), hop, 1));
  EXPECT_EQ(json["src"][0]["tag"], "the \"front\"\n");
}

TEST(OdasJson, takes_nothing_over_from_the_hop_before) {
  test::HopOfHand many;
  many.potentials.resize(9);
  const auto encoder = make_odas_json_potentials();
  const std::string first = encoded(*encoder, {}, 1);
  encoded(*encoder, many, 2);
  EXPECT_EQ(encoded(*encoder, {}, 1), first);
}

TEST(OdasJson, allocates_nothing_for_a_hop) {
  test::HopOfHand hop;
  hop.potentials.resize(4);
  hop.tracks.resize(4);
  const auto potentials = make_odas_json_potentials();
  const auto tracks = make_odas_json_tracks();
  const auto before = test::allocations();
  static_cast<void>(potentials->encode(hop.result(1)));
  static_cast<void>(tracks->encode(hop.result(1)));
  EXPECT_EQ(test::allocations(), before);
}

TEST(BinaryPotentials, are_four_floats_each) {
  test::HopOfHand hop;
  hop.potentials.resize(2);
  hop.potentials[1] = {{0.5F, -0.25F, 1}, 0.75F};
  const std::string bytes = encoded(*make_binary_potentials(), hop, 1);
  float values[8];
  ASSERT_EQ(bytes.size(), sizeof values);
  std::memcpy(values, bytes.data(), sizeof values);
  EXPECT_EQ(values[2], 1);
  EXPECT_EQ(values[4], 0.5F);
  EXPECT_EQ(values[5], -0.25F);
  EXPECT_EQ(values[6], 1);
  EXPECT_EQ(values[7], 0.75F);
}

}  // namespace
}  // namespace odas::odas_json_test
