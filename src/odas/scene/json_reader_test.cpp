// SPDX-License-Identifier: MIT
#include "odas/scene/json_reader.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace odas::json_reader_test {
namespace {

TEST(JsonReader, Reads_what_is_there_and_falls_back_where_it_may) {
  const auto json = nlohmann::json::parse(
      R"({"n": 3, "t": "word", "v": [1, 2.5, -3], "f": true, "c": "pink", "o": {"x": 1}, "l": [{"y": 2}]})");
  std::vector<Fault> faults;
  JsonReader reader(json, "", faults);
  EXPECT_EQ(reader.number("n", std::nullopt), 3);
  EXPECT_EQ(reader.number("absent", 7), 7);
  EXPECT_EQ(reader.text("t", std::nullopt), "word");
  EXPECT_EQ(reader.vector("v", std::nullopt), (Vec3{1, 2.5F, -3}));
  EXPECT_TRUE(reader.flag("f", false));
  EXPECT_EQ(reader.choice("c", 0, {"white", "pink"}), 1U);
  EXPECT_EQ(reader.object("o").number("x", std::nullopt), 1);
  ASSERT_EQ(reader.list("l").size(), 1U);
  reader.finish();
  EXPECT_TRUE(faults.empty());
}

TEST(JsonReader, Names_every_fault_with_its_path) {
  const auto json = nlohmann::json::parse(
      R"({"high": 99, "word": 5, "v": [1, 2], "c": "mauve", "f": 1, "l": [{"y": "two"}, 4], "odd": 0})");
  std::vector<Fault> faults;
  JsonReader reader(json, "scene", faults);
  reader.number("high", 1, {0, 10});
  reader.number("absent", std::nullopt);
  reader.text("word", "");
  reader.vector("v", Vec3{});
  reader.choice("c", 0, {"white", "pink"});
  reader.flag("f", false);
  for (JsonReader& element : reader.list("l")) element.number("y", 0);
  reader.finish();
  std::vector<std::string> paths;
  for (const Fault& fault : faults) paths.push_back(fault.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"scene.high", "scene.absent", "scene.word", "scene.v", "scene.c",
                                             "scene.f", "scene.l[1]", "scene.l[0].y", "scene.odd"}));
  EXPECT_EQ(faults[0].what, "is 99; it has to be from 0 to 10");
  EXPECT_EQ(faults[4].what, "is \"mauve\"; it has to be one of white, pink");
}

}  // namespace
}  // namespace odas::json_reader_test
