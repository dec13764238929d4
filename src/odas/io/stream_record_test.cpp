// SPDX-License-Identifier: MIT
#include "odas/io/stream_record.hpp"

#include <memory>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "odas/io/hop_encoder.hpp"

namespace odas::stream_record_test {
namespace {

std::string_view text_of(std::span<const char> bytes) { return {bytes.data(), bytes.size()}; }

std::vector<Track> two_tracks() {
  std::vector<Track> tracks(4);
  tracks[1] = {.id = 7, .tag = "dynamic", .direction = {0, 1, 0}, .activity = 0.5F};
  tracks[3] = {.id = 9, .tag = "say \"hi\" {", .direction = {0.6F, 0, -0.8F}, .activity = 1};
  return tracks;
}

void expect_two_tracks(const StreamRecord& record) {
  ASSERT_TRUE(record.is_good()) << record.fault;
  EXPECT_EQ(record.kind, StreamKind::tracks);
  EXPECT_EQ(record.time, 126U);
  ASSERT_EQ(record.tracks.size(), 4U);
  const std::vector<Track> sent = two_tracks();
  for (std::size_t slot = 0; slot < 4; ++slot) {
    EXPECT_EQ(record.tracks[slot].id, sent[slot].id);
    EXPECT_EQ(record.tracks[slot].tag, sent[slot].tag);
    EXPECT_LT(norm(record.tracks[slot].direction - sent[slot].direction), 2e-3);
    EXPECT_NEAR(record.tracks[slot].activity, sent[slot].activity, 1e-3);
  }
}

TEST(StreamRecord, reads_the_tracks_that_our_own_encoders_write) {
  const std::vector<Track> tracks = two_tracks();
  const HopResult hop{126, {}, tracks, {}, {}};
  const StreamRecord odas =
      read_stream_record(text_of(make_odas_json_tracks()->encode(hop)), StreamKind::tracks);
  expect_two_tracks(odas);
  EXPECT_FALSE(odas.is_line);
  const auto lines = make_json_lines_tracks({.hop_seconds = 0.008});
  std::string_view line = text_of(lines->encode(hop));
  line.remove_suffix(1);
  const StreamRecord ours = read_stream_record(line, StreamKind::potentials);
  expect_two_tracks(ours);
  EXPECT_TRUE(ours.is_line);
}

TEST(StreamRecord, reads_potentials) {
  const std::vector<Potential> potentials{{{0, 0, 1}, 0.75F}, {{1, 0, 0}, 0.125F}};
  const HopResult hop{3, potentials, {}, {}, {}};
  const StreamRecord record =
      read_stream_record(text_of(make_odas_json_potentials()->encode(hop)), StreamKind::tracks);
  ASSERT_TRUE(record.is_good()) << record.fault;
  EXPECT_EQ(record.kind, StreamKind::potentials);
  ASSERT_EQ(record.potentials.size(), 2U);
  EXPECT_EQ(record.potentials[1].energy, 0.125F);
  EXPECT_EQ(record.potentials[1].direction.x, 1);
}

TEST(StreamRecord, reads_categories_by_slot_and_the_class_of_a_track) {
  const StreamRecord record = read_stream_record(
      "{\n    \"timeStamp\": 1,\n    \"src\": [\n        { \"category\": \"nonspeech\" },\n"
      "        { \"category\": \"speech\" },\n        { \"category\": \"undefined\" }\n    ]\n}\n",
      StreamKind::tracks);
  ASSERT_TRUE(record.is_good()) << record.fault;
  EXPECT_EQ(record.kind, StreamKind::categories);
  ASSERT_EQ(record.tracks.size(), 3U);
  EXPECT_EQ(record.tracks[0].category, Category::nonspeech);
  EXPECT_EQ(record.tracks[1].category, Category::speech);
  EXPECT_EQ(record.tracks[2].category, Category::undefined);
  const StreamRecord track = read_stream_record(
      R"({"timeStamp":1,"src":[{"id":1,"activity":1.0,"E":0.5,"class":"speech"}]})", StreamKind::tracks);
  EXPECT_EQ(track.tracks.at(0).category, Category::speech);
}

TEST(StreamRecord, takes_a_record_without_rows_for_what_is_expected) {
  for (const StreamKind kind : {StreamKind::tracks, StreamKind::potentials, StreamKind::categories}) {
    const StreamRecord record = read_stream_record(R"({"timeStamp":5,"src":[]})", kind);
    EXPECT_TRUE(record.is_good()) << record.fault;
    EXPECT_EQ(record.kind, kind);
  }
}

TEST(StreamRecord, reads_what_ODAS_prints_for_no_number_as_0) {
  const StreamRecord record = read_stream_record(
      R"({"timeStamp": 1, "src": [ { "x": nan, "y": -nan, "z": inf, "E": 0.500 } ] })", StreamKind::tracks);
  ASSERT_TRUE(record.is_good()) << record.fault;
  EXPECT_EQ(record.potentials.at(0).direction.x, 0);
  EXPECT_EQ(record.potentials.at(0).direction.z, 0);
  EXPECT_EQ(record.potentials.at(0).energy, 0.5F);
}

TEST(StreamRecord, says_what_is_wrong) {
  const auto fault = [](std::string_view text) { return read_stream_record(text, StreamKind::tracks).fault; };
  EXPECT_EQ(fault("{\"timeStamp\": }"), "is no JSON");
  EXPECT_EQ(fault("[]"), "is no JSON object");
  EXPECT_EQ(fault(R"({"src":[]})"), "has no \"timeStamp\"");
  EXPECT_EQ(fault(R"({"timeStamp":-1,"src":[]})"), "has no \"timeStamp\"");
  EXPECT_EQ(fault(R"({"timeStamp":1,"src":{}})"), "has no list \"src\"");
  EXPECT_EQ(fault(R"({"timeStamp":1,"src":[3]})"), "has rows that are no track, potential or category");
  EXPECT_EQ(fault(R"({"timeStamp":1,"src":[{"E":1.0},{"activity":1.0}]})"), "has rows of more than one kind");
  EXPECT_NE(fault(R"({"timeStamp":1,"src":[{"slot":99999999999,"activity":1.0}]})"), "");
}

RC_GTEST_PROP(StreamRecord, survives_rows_of_any_kind, (const std::vector<std::uint8_t>& picks)) {
  static constexpr const char* kParts[]{"{",        "}",     "[",         "]",         ",",    ":",  "\"id\"",
                                        "\"slot\"", "\"E\"", "\"src\":[", "\"class\"", "1e99", "-1", "\"x\""};
  std::string text = R"({"timeStamp":1,"src":[)";
  for (const std::uint8_t pick : picks) text += kParts[pick % std::size(kParts)];
  const StreamRecord record = read_stream_record(text, StreamKind::tracks);
  RC_ASSERT(record.is_good() || !record.fault.empty());
}

}  // namespace
}  // namespace odas::stream_record_test
