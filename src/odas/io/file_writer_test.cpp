// SPDX-License-Identifier: MIT
#include "odas/io/file_writer.hpp"

#include "support/allocation_counter.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::file_writer_test {
namespace {

TEST(FileWriter, has_its_records_in_the_file_after_a_flush_and_not_only_at_the_end) {
  const test::Scratch scratch;
  FileWriter writer(scratch / "out");
  EXPECT_TRUE(writer.write(std::string("one\n")).ok());
  EXPECT_TRUE(writer.flush().ok());
  EXPECT_EQ(test::content(scratch / "out"), "one\n");
  EXPECT_TRUE(writer.write(std::string("two\n")).ok());
  EXPECT_TRUE(writer.close().ok());
  EXPECT_EQ(test::content(scratch / "out"), "one\ntwo\n");
}

TEST(FileWriter, replaces_a_file_that_is_there) {
  const test::Scratch scratch;
  test::write_file(scratch / "out", "much longer than before");
  FileWriter writer(scratch / "out");
  EXPECT_TRUE(writer.write(std::string("new")).ok());
  EXPECT_TRUE(writer.close().ok());
  EXPECT_EQ(test::content(scratch / "out"), "new");
}

TEST(FileWriter, writes_records_of_any_size_in_order) {
  const test::Scratch scratch;
  FileWriter writer(scratch / "out");
  std::string all;
  for (std::size_t i = 0; i < 3000; ++i) {
    const std::string record(i % 300 + (i % 1000 == 0 ? 200000 : 0), static_cast<char>('a' + i % 26));
    all += record;
    ASSERT_TRUE(writer.write(record).ok());
  }
  EXPECT_TRUE(writer.close().ok());
  EXPECT_EQ(test::content(scratch / "out"), all);
}

TEST(FileWriter, says_at_once_where_it_cannot_write) {
  const test::Scratch scratch;
  try {
    FileWriter writer(scratch / "missing/out");
    FAIL();
  } catch (const IoError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("missing/out: No such file or directory"), std::string::npos) << what;
  }
  EXPECT_THROW(FileWriter(scratch.folder()), IoError) << "a folder";
}

TEST(FileWriter, says_that_the_disk_is_full) {
  FileWriter writer("/dev/full");
  EXPECT_TRUE(writer.write(std::string("text")).ok()) << "still in memory";
  const IoStatus status = writer.flush();
  EXPECT_EQ(status.what(), "cannot write /dev/full: No space left on device");
  EXPECT_TRUE(writer.close().ok()) << "it is said once";
}

TEST(FileWriter, leaves_whole_records_where_the_disk_is_full) {
  const test::Scratch scratch;
  const test::FileSizeLimit limit(1000);
  FileWriter writer(scratch / "out");
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(writer.write(std::string(300, static_cast<char>('a' + i))).ok());
  EXPECT_FALSE(writer.flush().ok());
  EXPECT_TRUE(writer.close().ok());
  EXPECT_EQ(test::content(scratch / "out"),
            std::string(300, 'a') + std::string(300, 'b') + std::string(300, 'c'));
  EXPECT_EQ(writer.size(), 900U);
}

TEST(FileWriter, keeps_what_was_flushed_before_the_disk_was_full) {
  const test::Scratch scratch;
  const test::FileSizeLimit limit(1000);
  FileWriter writer(scratch / "out");
  EXPECT_TRUE(writer.write(std::string(400, 'a')).ok());
  EXPECT_TRUE(writer.flush().ok());
  EXPECT_TRUE(writer.write(std::string(700, 'b')).ok());
  EXPECT_FALSE(writer.close().ok());
  EXPECT_EQ(test::content(scratch / "out"), std::string(400, 'a'));
}

TEST(FileWriter, allocates_nothing_for_a_record) {
  const test::Scratch scratch;
  FileWriter writer(scratch / "out");
  const std::string record(1000, 'a');
  const auto before = test::allocations();
  for (int i = 0; i < 500; ++i) ASSERT_TRUE(writer.write(record).ok());
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace odas::file_writer_test
