// SPDX-License-Identifier: MIT
#include "odas/studio/recording_shelf.hpp"

#include <cstring>
#include <functional>

#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "odas/studio/rpc.hpp"
#include "odas/studio/take.hpp"

namespace odas::recording_shelf_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// One second of a voice that is loud in its second half.
std::string make_take(const test::Scratch& scratch, std::uint64_t id, bool close = true) {
  TakeHead head;
  head.track = id;
  head.start = std::chrono::system_clock::time_point(std::chrono::seconds(1769860800 + id));
  Take take(scratch.folder(), head);
  std::vector<std::int16_t> samples(16000, 0);
  for (std::size_t i = 8000; i < 16000; ++i) samples[i] = i % 2 == 0 ? 16384 : -8192;
  std::vector<char> bytes(32000);
  std::memcpy(bytes.data(), samples.data(), bytes.size());
  EXPECT_TRUE(take.write(bytes).ok());
  take.steer(0, {0, 1, 0});
  EXPECT_TRUE((close ? take.close() : take.flush()).ok());
  return take.name();
}

std::string code(const std::function<void()>& act) {
  try {
    act();
  } catch (const RpcError& error) { return error.code(); }
  return "";
}

TEST(RecordingShelf, lists_only_what_a_studio_made_the_newest_first) {
  const test::Scratch scratch;
  const std::string one = make_take(scratch, 1), two = make_take(scratch, 2);
  test::write_file(scratch / "music.wav", "RIFF");
  test::write_file(scratch / "notes.txt", "mine");
  test::write_file(scratch / "other.wav", "RIFF");
  test::write_file(scratch / "other.json", R"({"file":"other.wav","made_by":"me"})");
  test::write_file(scratch / "torn.wav", "RIFF");
  test::write_file(scratch / "torn.json", R"({"made_by":"odas stu)");
  test::write_file(scratch / "liar.wav", "RIFF");
  test::write_file(scratch / "liar.json", R"({"made_by":"odas studio","file":"music.wav"})");
  test::write_file(scratch / "kind.wav", "RIFF");
  test::write_file(scratch / "kind.json", R"({"made_by":"odas studio","file":"kind.wav","kind":7})");
  RecordingShelf shelf(scratch.folder());
  const json list = shelf.list();
  ASSERT_EQ(list.size(), 2U) << list;
  EXPECT_EQ(list[0]["name"], two);
  EXPECT_EQ(list[1]["name"], one);
  EXPECT_EQ(list[1]["seconds"], 1.0);
  EXPECT_EQ(list[1]["track"], 1);
  EXPECT_EQ(list[1]["bytes"], 32080);
  EXPECT_EQ(list[1]["direction"], (json{0.0, 1.0, 0.0}));
  EXPECT_EQ(list[1]["transcript"], "");
}

TEST(RecordingShelf, knows_the_length_of_one_that_was_killed) {
  const test::Scratch scratch;
  make_take(scratch, 1, false);
  EXPECT_EQ(RecordingShelf(scratch.folder()).list()[0]["seconds"], 1.0);
}

TEST(RecordingShelf, of_a_folder_that_is_not_there_is_empty) {
  EXPECT_EQ(RecordingShelf("/nowhere/at/all").list(), json::array());
}

TEST(RecordingShelf, deletes_nothing_but_its_own) {
  const test::Scratch scratch;
  const std::string name = make_take(scratch, 1);
  fs::create_directories(scratch / "in");
  test::write_file(scratch / "in" / "victim.wav", "RIFF");
  test::write_file(scratch / "mine.wav", "RIFF");
  test::write_file(scratch / "notes.txt", "mine");
  fs::create_symlink(scratch / "in" / "victim.wav", scratch / "link.wav");
  test::write_file(scratch / "link.json", R"({"made_by":"odas studio","file":"link.wav"})");
  RecordingShelf shelf(scratch / "in" / "..");
  for (const char* bad : {"mine.wav", "notes.txt", "in/victim.wav", "../mine.wav", "/etc/passwd", "link.wav",
                          "", ".", "link.json", "none.wav"}) {
    EXPECT_EQ(code([&] { shelf.remove(bad); }), "not_found") << bad;
    EXPECT_EQ(code([&] { shelf.rename(bad, "x"); }), "not_found") << bad;
    EXPECT_EQ(code([&] { static_cast<void>(shelf.peaks(bad, 3)); }), "not_found") << bad;
    EXPECT_FALSE(shelf.find(bad).has_value()) << bad;
  }
  EXPECT_EQ(std::distance(fs::recursive_directory_iterator(scratch.folder()), {}), 8);
  shelf.remove(name);
  EXPECT_FALSE(fs::exists(scratch / name));
  EXPECT_EQ(std::distance(fs::recursive_directory_iterator(scratch.folder()), {}), 6);
  EXPECT_EQ(code([&] { shelf.remove(name); }), "not_found");
}

TEST(RecordingShelf, keeps_a_label) {
  const test::Scratch scratch;
  const std::string name = make_take(scratch, 1);
  RecordingShelf shelf(scratch.folder());
  shelf.rename(name, "my \"voice\" \xc3\xa9");
  EXPECT_EQ(shelf.list()[0]["label"], "my \"voice\" \xc3\xa9");
  EXPECT_EQ(RecordingShelf(scratch.folder()).list()[0]["label"], "my \"voice\" \xc3\xa9");
}

TEST(RecordingShelf, draws_the_waveform_of_the_file) {
  const test::Scratch scratch;
  const std::string name = make_take(scratch, 1);
  RecordingShelf shelf(scratch.folder());
  const json peaks = shelf.peaks(name, 4);
  EXPECT_EQ(peaks["min"], (json{0.0, 0.0, -0.25, -0.25}));
  EXPECT_EQ(peaks["max"], (json{0.0, 0.0, 0.5, 0.5}));
  EXPECT_EQ(peaks["seconds"], 1.0);
  EXPECT_EQ(peaks["rate"], 16000);
  EXPECT_EQ(shelf.peaks(name, 4), peaks) << "the second time from memory";
  const json fine = shelf.peaks(name, 20000);
  ASSERT_EQ(fine["max"].size(), 20000U) << "more columns than samples";
  EXPECT_EQ(fine["max"][19998], 0.5);
}

}  // namespace
}  // namespace odas::recording_shelf_test
