// SPDX-License-Identifier: MIT
#include "odas/studio/zip.hpp"

#include "support/program.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::zip_test {
namespace {

class Zip : public testing::TestWithParam<bool> {};

TEST_P(Zip, is_unpacked_by_others_with_the_same_bytes) {
  const test::Scratch scratch;
  const std::string sound(200000, '\x5a');
  test::write_file(scratch / "a.wav", sound);
  test::write_file(scratch / "empty", "");
  ZipWriter writer(scratch / "all.zip", GetParam());
  writer.add(scratch / "a.wav", "a.wav");
  writer.add(scratch / "empty", "d\xc3\xa9j\xc3\xa0.json");
  writer.close();
  const test::ProgramRun python = test::run_program({"/usr/bin/env", "python3", "-c",
                                                     "import sys, zipfile\n"
                                                     "z = zipfile.ZipFile(sys.argv[1])\n"
                                                     "assert z.testzip() is None\n"
                                                     "print([(i.filename.encode('utf-8').hex(), i.file_size, "
                                                     "i.date_time[0] > 2000) for i in z.infolist()])\n"
                                                     "sys.stdout.write(z.read('a.wav').hex()[:8])\n",
                                                     (scratch / "all.zip").string()},
                                                    {});
  const test::ProgramRun unzip =
      test::run_program({"/usr/bin/env", "unzip", "-t", (scratch / "all.zip").string()}, {});
  if (python.exit_code == 127 && unzip.exit_code == 127) GTEST_SKIP() << "neither python3 nor unzip here";
  if (python.exit_code != 127) {
    EXPECT_EQ(python.out, "[('612e776176', 200000, True), ('64c3a96ac3a02e6a736f6e', 0, True)]\n5a5a5a5a")
        << python.err;
  }
  if (unzip.exit_code != 127) { EXPECT_EQ(unzip.exit_code, 0) << unzip.out; }
}

INSTANTIATE_TEST_SUITE_P(ShortAndLong, Zip, testing::Bool());

TEST(ZipWriter, of_a_file_that_is_not_there_says_so) {
  const test::Scratch scratch;
  ZipWriter writer(scratch / "all.zip");
  EXPECT_THROW(writer.add(scratch / "none", "none"), IoError);
  EXPECT_THROW(ZipWriter(scratch / "none" / "all.zip"), IoError);
}

TEST(ZipWriter, of_a_full_disk_says_so) {
  const test::Scratch scratch;
  test::write_file(scratch / "a.wav", std::string(50000, 'x'));
  const test::FileSizeLimit limit(20000);
  ZipWriter writer(scratch / "all.zip");
  EXPECT_THROW(
      {
        writer.add(scratch / "a.wav", "a.wav");
        writer.close();
      },
      IoError);
}

}  // namespace
}  // namespace odas::zip_test
