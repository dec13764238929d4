// SPDX-License-Identifier: MIT
#include "odas/io/stream_archive.hpp"

#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "odas/base/error.hpp"

namespace odas::stream_archive_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const StreamArchive::Instant kNow{std::chrono::milliseconds(1735732800125)};  // 2025-01-01T12:00:00.125Z

StreamRecord tracks_at(HopIndex time) {
  StreamRecord record;
  record.time = time;
  record.tracks.resize(2);
  record.tracks[1] = {.id = 3, .tag = "a", .direction = {0, 1, 0}, .activity = 1};
  return record;
}

TEST(StreamArchive, writes_each_kind_into_a_file_of_its_own_with_the_time_of_receipt) {
  const test::Scratch scratch;
  StreamArchive archive(scratch / "run", 0.008);
  StreamRecord potentials;
  potentials.kind = StreamKind::potentials;
  potentials.time = 1;
  potentials.potentials.push_back({{1, 0, 0}, 0.5F});
  StreamRecord categories = tracks_at(2);
  categories.kind = StreamKind::categories;
  categories.tracks[1].category = Category::speech;
  EXPECT_TRUE(archive.add(tracks_at(126), "", kNow).ok());
  EXPECT_TRUE(archive.add(potentials, "", kNow).ok());
  EXPECT_TRUE(archive.add(categories, "", kNow).ok());
  EXPECT_TRUE(archive.flush().ok());
  const json track = json::parse(test::content(scratch / "run/tracks.jsonl"));
  EXPECT_EQ(track["timeStamp"], 126);
  EXPECT_EQ(track["time"], 1.0);
  EXPECT_EQ(track["utc"], "2025-01-01T12:00:00.125Z");
  EXPECT_EQ(track["src"][0]["slot"], 1);
  EXPECT_EQ(track["src"][0]["azimuth"], 90.0);
  EXPECT_EQ(json::parse(test::content(scratch / "run/potentials.jsonl"))["src"][0]["E"], 0.5);
  EXPECT_EQ(test::content(scratch / "run/categories.jsonl"),
            "{\"src\":[{\"class\":\"speech\",\"id\":3,\"slot\":1}],\"time\":0.008,\"timeStamp\":2,"
            "\"utc\":\"2025-01-01T12:00:00.125Z\"}\n");
}

TEST(StreamArchive, a_line_of_jsonl_stays_as_it_is) {
  const test::Scratch scratch;
  StreamArchive archive(scratch / "run", 0.008);
  StreamRecord record = tracks_at(1);
  record.is_line = true;
  EXPECT_TRUE(archive.add(record, R"({"timeStamp":1,"utc":"then","new":7,"src":[]})", kNow).ok());
  EXPECT_TRUE(archive.close().ok());
  EXPECT_EQ(test::content(scratch / "run/tracks.jsonl"),
            "{\"timeStamp\":1,\"utc\":\"then\",\"new\":7,\"src\":[]}\n");
}

TEST(StreamArchive, a_stamp_that_no_run_reaches_tells_no_time) {
  const test::Scratch scratch;
  StreamArchive archive(scratch / "run", 0.008);
  for (const HopIndex time : {HopIndex{0}, ~HopIndex{0}})
    EXPECT_TRUE(archive.add(tracks_at(time), "", kNow).ok());
  EXPECT_TRUE(archive.close().ok());
  const std::string text = test::content(scratch / "run/tracks.jsonl");
  const json last = json::parse(text.substr(text.find('\n') + 1));
  EXPECT_EQ(last["timeStamp"], ~HopIndex{0});
  EXPECT_EQ(last["time"], 0.0);
  EXPECT_EQ(last["utc"], "2025-01-01T12:00:00.125Z");
}

TEST(StreamArchive, overwrites_nothing) {
  const test::Scratch scratch;
  test::write_file(scratch / "mine", "x");
  EXPECT_THROW(StreamArchive(scratch.folder(), 0.008), IoError);
  EXPECT_THROW(StreamArchive(scratch / "mine", 0.008), IoError);
  EXPECT_THROW(StreamArchive(scratch / "mine/run", 0.008), IoError);
  EXPECT_EQ(test::content(scratch / "mine"), "x");
}

TEST(StreamArchive, each_connection_has_a_recording_of_its_own) {
  const test::Scratch scratch;
  {
    StreamArchive archive(scratch / "run", 0.008);
    for (const char* stream : {"separated", "separated", "postfiltered"}) {
      EXPECT_TRUE(archive.open_wav(stream, {})->close().ok());
    }
    EXPECT_TRUE(archive.note({"separated", "file", "[::1]:7", "separated_2.wav", 9}, kNow).ok());
    EXPECT_TRUE(archive.close().ok());
  }
  for (const char* name : {"separated.wav", "separated_2.wav", "postfiltered.wav"}) {
    EXPECT_TRUE(fs::exists(scratch / "run" / name)) << name;
  }
  EXPECT_EQ(test::content(scratch / "run/connections.jsonl"),
            "{\"bytes\":9,\"event\":\"file\",\"file\":\"separated_2.wav\",\"from\":\"[::1]:7\",\"stream\":"
            "\"separated\","
            "\"utc\":\"2025-01-01T12:00:00.125Z\"}\n");
}

TEST(StreamArchive, a_folder_that_nothing_came_into_goes_again) {
  const test::Scratch scratch;
  { const StreamArchive archive(scratch / "run", 0.008); }
  EXPECT_FALSE(fs::exists(scratch / "run"));
  fs::create_directory(scratch / "mine");
  { const StreamArchive archive(scratch / "mine", 0.008); }
  EXPECT_TRUE(fs::exists(scratch / "mine")) << "which it did not make";
}

TEST(StreamArchive, a_full_disk_is_said) {
  const test::Scratch scratch;
  StreamArchive archive(scratch / "run", 0.008);
  IoStatus status;
  {
    const test::FileSizeLimit limit(1000);
    for (int i = 1; i < 100; ++i)
      EXPECT_TRUE(archive.add(tracks_at(static_cast<HopIndex>(i)), "", kNow).ok());
    status = archive.flush();
  }
  EXPECT_NE(status.what().find("tracks.jsonl"), std::string::npos) << status.what();
}

}  // namespace
}  // namespace odas::stream_archive_test
