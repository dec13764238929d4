// SPDX-License-Identifier: MIT
#include "odas/studio/own_file.hpp"

#include <cstdlib>

#include "support/scratch.hpp"
#include <gtest/gtest.h>

namespace odas::own_file_test {
namespace {

TEST(OwnFile, names_that_lead_elsewhere_are_refused) {
  for (const char* name : {"", ".", "..", "../a.wav", "a/b.wav", "/etc/passwd", ".hidden", "a..wav", "a\\b",
                           "a\nb.wav", "..%2f"}) {
    EXPECT_FALSE(is_plain_name(name)) << name;
  }
  EXPECT_FALSE(is_plain_name(std::string(300, 'a')));
  EXPECT_TRUE(is_plain_name("20260131T120000.125Z_source_12.wav"));
}

TEST(OwnFile, is_a_file_and_neither_a_folder_nor_a_link) {
  const test::Scratch scratch;
  test::write_file(scratch / "a.wav", "");
  std::filesystem::create_symlink(scratch / "a.wav", scratch / "b.wav");
  EXPECT_TRUE(is_file(scratch / "a.wav"));
  EXPECT_FALSE(is_file(scratch / "b.wav"));
  EXPECT_FALSE(is_file(scratch.folder()));
  EXPECT_FALSE(is_file(scratch / "none"));
}

TEST(OwnFile, is_written_whole_and_leaves_nothing_else) {
  const test::Scratch scratch;
  ASSERT_TRUE(write_whole(scratch / "a.json", "one").ok());
  ASSERT_TRUE(write_whole(scratch / "a.json", "two").ok());
  EXPECT_EQ(test::content(scratch / "a.json"), "two");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(scratch.folder()), {}), 1);
}

TEST(OwnFile, that_cannot_be_written_is_said_and_the_old_one_stays) {
  const test::Scratch scratch;
  test::write_file(scratch / "a.json", "old");
  const test::FileSizeLimit limit(10);
  EXPECT_FALSE(write_whole(scratch / "a.json", std::string(100, 'x')).ok());
  EXPECT_EQ(test::content(scratch / "a.json"), "old");
  EXPECT_FALSE(write_whole(scratch / "none" / "a.json", "").ok());
}

TEST(OwnFile, finds_a_name_that_is_free) {
  const test::Scratch scratch;
  EXPECT_EQ(free_name(scratch.folder(), "a", ".wav"), scratch / "a.wav");
  test::write_file(scratch / "a.wav", "");
  test::write_file(scratch / "a_2.json", "");
  EXPECT_EQ(free_name(scratch.folder(), "a", ".wav"), scratch / "a_3.wav");
}

TEST(OwnFile, the_folder_is_the_one_of_the_configuration_or_the_users) {
  EXPECT_EQ(recordings_folder("/tmp/x"), "/tmp/x");
  EXPECT_TRUE(recordings_folder("").string().ends_with("/odas/recordings"));
  EXPECT_EQ(recordings_folder("~/x"), std::filesystem::path(std::getenv("HOME")) / "x");
}

}  // namespace
}  // namespace odas::own_file_test
