// SPDX-License-Identifier: MIT
#include "odas/io/target_reader.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace odas::target_reader_test {
namespace {

constexpr const char* kDoor = R"({"targets":[{"tag":"door","x":2,"y":0,"z":0.0}]})";
constexpr const char* kDesk = R"({ "targets": [ { "tag": "desk {\"", "x": 0, "y": -1e0, "z": 0 } ] })";

std::vector<TargetMessage> all_of(TargetReader& reader, std::string_view piece) {
  reader.push(piece);
  std::vector<TargetMessage> messages;
  while (auto message = reader.next()) messages.push_back(*message);
  return messages;
}

std::vector<TargetMessage> all_of(std::string_view text) {
  TargetReader reader;
  return all_of(reader, text);
}

std::string tags_of(const std::vector<TargetMessage>& messages) {
  std::string text;
  for (const TargetMessage& message : messages) {
    text += message.is_good() ? "[" : "!";
    for (const Target& target : message.targets.view()) text += std::string(target.tag.view()) + " ";
    text += message.is_good() ? "]" : "";
  }
  return text;
}

TEST(ReadTargets, reads_tags_and_directions_of_length_1) {
  const TargetMessage message = read_targets(
      R"({"timeStamp":7,"targets":[{"tag":"a","x":3,"y":0,"z":4},{"tag":"é","x":0,"y":1e300,"z":1,"w":[]}]})");
  ASSERT_TRUE(message.is_good()) << message.fault;
  ASSERT_EQ(message.targets.view().size(), 2U);
  EXPECT_EQ(message.targets.view()[0].tag.view(), "a");
  EXPECT_NEAR(message.targets.view()[0].direction.x, 0.6, 1e-6);
  EXPECT_NEAR(message.targets.view()[0].direction.z, 0.8, 1e-6);
  EXPECT_EQ(message.targets.view()[1], (Target{"é", {0, 1, 0}}));
}

TEST(ReadTargets, an_empty_list_removes_all_and_an_empty_tag_is_passed_over) {
  const TargetMessage none = read_targets(R"({"targets":[]})");
  EXPECT_TRUE(none.is_good());
  EXPECT_TRUE(none.targets.view().empty());
  const TargetMessage empty = read_targets(R"({"targets":[{"tag":"","x":0,"y":0,"z":0}]})");
  EXPECT_TRUE(empty.is_good());
  EXPECT_TRUE(empty.targets.view().empty());
}

TEST(ReadTargets, says_what_is_wrong) {
  const auto fault = [](const std::string& text) { return read_targets(text).fault; };
  const auto target = [&](const std::string& item) { return fault("{\"targets\":[" + item + "]}"); };
  EXPECT_EQ(fault("[]"), "is no JSON object");
  EXPECT_EQ(fault("{\"targets\":}"), "is no JSON");
  EXPECT_EQ(fault(std::string(kDoor) + "}"), "is no JSON");
  EXPECT_EQ(fault("{}"), "has no list \"targets\", \"add\" or \"remove\"");
  EXPECT_EQ(fault("{\"targets\":{}}"), "has no list \"targets\"");
  EXPECT_EQ(target("3"), "targets[0] is no JSON object");
  EXPECT_EQ(target(R"({"x":1,"y":0,"z":0})"), "targets[0].tag is no text");
  EXPECT_EQ(target(R"({"tag":1,"x":1,"y":0,"z":0})"), "targets[0].tag is no text");
  EXPECT_EQ(target(R"({"tag":"\ud800","x":1,"y":0,"z":0})"), "is no JSON");
  EXPECT_EQ(target("{\"tag\":\"caf\xE9\",\"x\":1,\"y\":0,\"z\":0}"), "is no JSON");
  EXPECT_EQ(target("{\"tag\":\"" + std::string(64, 'x') + "\",\"x\":1,\"y\":0,\"z\":0}"),
            "targets[0].tag has more than 63 bytes");
  EXPECT_NE(target(R"({"tag":"dynamic","x":1,"y":0,"z":0})"), "");
  for (const char* xyz : {R"("x":0,"y":0,"z":0)", R"("x":1,"y":0)", R"("x":"1","y":0,"z":0)",
                          R"("x":null,"y":0,"z":1)", R"("x":1e999,"y":0,"z":0)"}) {
    EXPECT_NE(target("{\"tag\":\"a\"," + std::string(xyz) + "}"), "") << xyz;
  }
  EXPECT_EQ(target(R"({"tag":"a","x":1,"y":0,"z":0},{"tag":"a","x":0,"y":1,"z":0})"),
            "targets[1].tag is the tag of another target");
}

TEST(ReadTargets, a_change_says_what_is_wrong_with_it) {
  const auto fault = [](const std::string& text) { return read_targets(text).fault; };
  EXPECT_EQ(fault(R"({"add":{}})"), "has no list \"add\"");
  EXPECT_EQ(fault(R"({"add":[{"tag":"a"}]})"), "add[0] has no direction: x, y and z are numbers, not all 0");
  EXPECT_EQ(fault(R"({"remove":"a"})"), "has no list \"remove\"");
  EXPECT_EQ(fault(R"({"remove":[1]})"), "remove has what is no text: it is a list of tags");
  EXPECT_EQ(fault(R"({"targets":[],"remove":["a"]})"), "has both \"targets\" and \"remove\"");
}

TEST(Heed, adds_moves_and_removes) {
  const auto tags_after = [](const std::vector<std::string>& messages) {
    TargetList targets;
    for (const std::string& text : messages) {
      std::size_t surplus = 0;
      targets = heed(read_targets(text), targets, surplus);
      EXPECT_EQ(surplus, 0U);
    }
    std::string all;
    for (const Target& t : targets.view()) {
      all += std::string(t.tag.view()) + (t.direction.x > 0.5F ? "x " : t.direction.y > 0.5F ? "y " : "z ");
    }
    return all;
  };
  const std::string two = R"({"targets":[{"tag":"a","x":1,"y":0,"z":0},{"tag":"b","x":0,"y":1,"z":0}]})";
  const std::string up = R"("x":0,"y":0,"z":1}]})";
  EXPECT_EQ(tags_after({two}), "ax by ");
  EXPECT_EQ(tags_after({two, R"({"add":[{"tag":"c",)" + up}), "ax by cz ");
  EXPECT_EQ(tags_after({two, R"({"add":[{"tag":"a",)" + up}), "az by ");
  EXPECT_EQ(tags_after({two, R"({"remove":["a","nobody"]})"}), "by ");
  EXPECT_EQ(tags_after({two, R"({"remove":["a"],"add":[{"tag":"a",)" + up}), "by az ");
  EXPECT_EQ(tags_after({two, R"({"targets":[{"tag":"c",)" + up}), "cz ");
}

TEST(Heed, counts_those_that_there_is_no_room_for) {
  TargetList targets;
  std::size_t lost = 0;
  for (int i = 0; i < 70; ++i) {
    std::size_t surplus = 0;
    targets = heed(read_targets(R"({"add":[{"tag":")" + std::to_string(i) + R"(","x":1,"y":0,"z":0}]})"),
                   targets, surplus);
    lost += surplus;
  }
  EXPECT_EQ(targets.view().size(), 64U);
  EXPECT_EQ(lost, 6U);
}

TEST(ReadTargets, keeps_the_first_64_and_counts_the_rest) {
  std::string text = "{\"targets\":[";
  for (int i = 0; i < 70; ++i) {
    text += std::string(i > 0 ? "," : "") + R"({"tag":")" + std::to_string(i) + R"(","x":1,"y":0,"z":0})";
  }
  const TargetMessage message = read_targets(text + "]}");
  ASSERT_TRUE(message.is_good());
  EXPECT_EQ(message.targets.view().size(), 64U);
  EXPECT_EQ(message.surplus, 6U);
}

TEST(TargetReader, reads_messages_one_after_another) {
  EXPECT_EQ(tags_of(all_of(std::string(kDoor) + kDesk + "\n\n" + kDoor + "\r\n")),
            "[door ][desk {\" ][door ]");
}

TEST(TargetReader, says_once_what_stands_between_messages) {
  EXPECT_EQ(tags_of(all_of("GET / HTTP/1.1\r\n\r\n" + std::string(kDoor) + "]} , \n" + kDesk)),
            "![door ]![desk {\" ]");
}

TEST(TargetReader, finds_the_next_message_after_one_that_was_cut) {
  const std::string door = kDoor;
  EXPECT_EQ(tags_of(all_of(door.substr(0, door.find(",\"x\"")) + kDesk)), "![desk {\" ]");
  // Cut where a value may stand, the next one is taken for it; the one after that is found.
  EXPECT_EQ(tags_of(all_of("{\"targets\":[" + door + kDesk)), "![desk {\" ]");
}

TEST(TargetReader, gives_up_on_a_message_without_end_and_goes_on) {
  TargetReader reader;
  const std::string piece(1000, '[');
  EXPECT_TRUE(all_of(reader, "{\"targets\":").empty());
  std::size_t faults = 0;
  for (int i = 0; i < 200; ++i) faults += all_of(reader, piece).size();
  EXPECT_EQ(faults, 1U);
  EXPECT_EQ(tags_of(all_of(reader, kDoor)), "[door ]");
}

TEST(TargetReader, forgets_a_peer_that_has_gone) {
  TargetReader reader;
  EXPECT_TRUE(all_of(reader, "{\"targets\":[{\"tag\":\"a").empty());
  reader.reset();
  EXPECT_EQ(tags_of(all_of(reader, kDoor)), "[door ]");
}

RC_GTEST_PROP(TargetReader, reads_the_same_however_the_bytes_are_cut, ()) {
  std::string text;
  const auto parts =
      *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(std::vector<std::string>{
          kDoor, kDesk, "{", "}", "\"", "\\", "x", " ", R"({"targets":[]})", R"({"targets":[{"tag":"a")"}));
  for (const std::string& part : parts) text += part;
  const std::string whole = tags_of(all_of(text));
  TargetReader reader;
  std::string pieces;
  for (std::size_t at = 0; at < text.size();) {
    const auto size = *rc::gen::inRange<std::size_t>(1, 30);
    pieces += tags_of(all_of(reader, std::string_view(text).substr(at, size)));
    at += size;
  }
  RC_ASSERT(pieces == whole);
}

RC_GTEST_PROP(TargetReader, survives_any_bytes_and_gives_only_targets_that_can_be_followed, ()) {
  std::string text = std::string(kDoor) + kDesk;
  const auto changes = *rc::gen::container<std::vector<std::pair<std::size_t, char>>>(
      rc::gen::pair(rc::gen::inRange<std::size_t>(0, text.size()), rc::gen::arbitrary<char>()));
  for (const auto& [at, byte] : changes) text[at] = byte;
  TargetReader reader;
  for (const TargetMessage& message : all_of(reader, text)) {
    RC_ASSERT(message.is_good() || message.targets.view().empty());
    for (const Target& target : message.targets.view()) {
      RC_ASSERT(*fault_of(target) == '\0');
      RC_ASSERT(std::abs(norm(target.direction) - 1) < 1e-5F);
    }
  }
  reader.reset();
  RC_ASSERT(tags_of(all_of(reader, kDoor)) == "[door ]");
}

RC_GTEST_PROP(TargetReader, loses_no_good_message_after_a_faulty_one_that_is_whole, ()) {
  const auto faulty =
      *rc::gen::elementOf(std::vector<std::string>{"{}", "{\"targets\":3}", "garbage", "{\"targets\":[{}]}",
                                                   "{\"targets\":[{\"tag\":\"}\"}]}", "{,}", "]"});
  RC_ASSERT(tags_of(all_of(kDoor + faulty + kDoor)) == "[door ]![door ]");
}

}  // namespace
}  // namespace odas::target_reader_test
