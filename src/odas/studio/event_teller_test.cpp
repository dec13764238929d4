// SPDX-License-Identifier: MIT
#include "odas/studio/event_teller.hpp"

#include "support/hop_maker.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace odas::event_teller_test {
namespace {

using nlohmann::json;

struct Told {
  std::vector<json> all;
  EventTeller teller{[this](const json& event) { all.push_back(event); }};
  [[nodiscard]] std::vector<std::string> words() const {
    std::vector<std::string> list;
    for (const json& event : all) {
      list.push_back(event["event"].get<std::string>() + " " + event["track"].dump() + " " +
                     event["class"].dump());
    }
    return list;
  }
};

TEST(EventTeller, tells_who_appears_and_who_disappears) {
  Told told;
  test::HopMaker hops;
  told.teller.begin(hops.info());
  hops.play(told.teller, {0, 0});
  for (int i = 0; i < 10; ++i) hops.play(told.teller, {1, 0});
  for (int i = 0; i < 10; ++i) hops.play(told.teller, {1, 2});
  hops.play(told.teller, {2, 3});  // 2 has another slot: it is the same
  hops.play(told.teller, {2, 0});
  told.teller.end();
  EXPECT_EQ(told.words(), (std::vector<std::string>{"appear 1 0", "appear 2 0", "appear 3 0", "disappear 1 0",
                                                    "disappear 3 0", "disappear 2 0"}));
  EXPECT_EQ(told.all[0]["at"], "2026-01-31T12:00:00.008Z");
  EXPECT_EQ(told.all[0]["direction"], (json{0.0, 1.0, 0.0}));
  EXPECT_EQ(told.all[0]["type"], "event");
}

TEST(EventTeller, tells_a_class_once_it_has_held_for_half_a_second) {
  Told told;
  test::HopMaker hops;
  told.teller.begin(hops.info());
  hops.play(told.teller, {1, 0});
  for (int i = 0; i < 200; ++i) {  // it wavers
    hops.category = i % 2 == 0 ? Category::speech : Category::nonspeech;
    hops.play(told.teller, {1, 0});
  }
  EXPECT_EQ(told.all.size(), 1U);
  hops.category = Category::speech;
  for (int i = 0; i < 200; ++i) hops.play(told.teller, {1, 0});
  EXPECT_EQ(told.words(), (std::vector<std::string>{"appear 1 0", "class 1 2"}));
}

TEST(EventTeller, forgets_everybody_when_another_run_begins) {
  Told told;
  test::HopMaker hops;
  told.teller.begin(hops.info());
  hops.play(told.teller, {1, 0});
  told.teller.begin(hops.info());
  hops.play(told.teller, {1, 0});
  EXPECT_EQ(told.words(), (std::vector<std::string>{"appear 1 0", "disappear 1 0", "appear 1 0"}));
}

}  // namespace
}  // namespace odas::event_teller_test
