// SPDX-License-Identifier: MIT
// `odas check` as a user runs it.
#include <filesystem>
#include <fstream>

#include "support/program.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "odas/config/keys.hpp"

namespace odas::check_command_test {
namespace {

namespace fs = std::filesystem;

test::ProgramRun check(const std::string& argument) {
  return test::run_program({test::program_path("odas"), "check", argument});
}

class CheckCommand : public ::testing::Test {
 protected:
  std::string write(const std::string& text) const {
    const fs::path file = folder_ / "my.cfg";
    std::ofstream(file) << text;
    return file.string();
  }
  test::Scratch scratch_;
  fs::path folder_ = scratch_.folder();
};

TEST_F(CheckCommand, prints_the_plan_of_every_array_file_and_nothing_else) {
  for (const auto& entry : fs::directory_iterator(fs::path(ODAS_SOURCE_DIR) / "configs")) {
    if (entry.is_directory()) continue;
    const auto run = check(entry.path().string());
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    for (const char* piece : {"Array\n", "Search\n", "Time\n", "Ways\n", "hear a common direction", "MiB"}) {
      EXPECT_NE(run.out.find(piece), std::string::npos) << entry.path() << piece;
    }
  }
}

TEST_F(CheckCommand, finds_an_array_by_its_name) {
  const auto run = check("minidsp_uma8");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("microphones     7"), std::string::npos) << run.out;
}

TEST_F(CheckCommand, names_the_arrays_that_there_are_where_a_name_is_wrong) {
  const auto run = check("respeeker_usb_4_mic");
  EXPECT_EQ(run.exit_code, 2);
  for (const char* piece :
       {"did you mean \"respeaker_usb_4_mic\"?", "There are: azimut3_closed_16 ", " t_top "}) {
    EXPECT_NE(run.err.find(piece), std::string::npos) << run.err;
  }
}

TEST_F(CheckCommand, shows_the_pairs_that_the_body_of_a_closed_array_takes_away) {
  const auto run = check(ODAS_SOURCE_DIR "/configs/azimut3_closed_16.cfg");
  EXPECT_NE(run.out.find("88 of 120 hear a common direction"), std::string::npos) << run.out;
}

TEST_F(CheckCommand, says_all_faults_on_stderr_and_ends_with_code_2) {
  const std::string file = write("raw: {\n  fS = \"fast\";\n};\n");
  const auto run = check(file);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out, "");
  for (const std::string piece :
       {":2: error: raw.fS: is the text \"fast\"", ": error: raw.nChannels: is missing",
        ": error: general.mics: is missing"}) {
    EXPECT_NE(run.err.find(piece), std::string::npos) << run.err;
  }
}

TEST_F(CheckCommand, goes_on_after_a_warning) {
  const auto run =
      check(write("raw: { fS = 16000; nChannels = 2; };\n"
                  "general: { mics = ( { mu = (0.1, 0, 0); }, { mu = (0, 0, 0); } ); };\n"
                  "sss: { gain_spe = 2; };\n"));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.err.find("my.cfg:3: warning: sss.gain_spe: unknown key, ignored; did you mean \"gain_sep\"?"),
            std::string::npos)
      << run.err;
  EXPECT_NE(run.out.find("Array\n"), std::string::npos);
}

TEST_F(CheckCommand, gives_a_line_to_what_only_a_stage_can_find) {
  // Two microphones that hear nothing in common, back to back.
  const auto run =
      check(write("raw: { fS = 16000; nChannels = 2; };\n"
                  "general: { mics = (\n"
                  "  { mu = (0.1, 0, 0); direction = (1, 0, 0); angle = (40, 50); },\n"
                  "  { mu = (0, 0, 0); direction = (-1, 0, 0); angle = (40, 50); } ); };\n"));
  EXPECT_EQ(run.exit_code, 2) << run.out;
  EXPECT_NE(run.err.find("my.cfg:"), std::string::npos) << run.err;
}

TEST_F(CheckCommand, names_files_that_are_none) {
  const auto missing = check("no/such.cfg");
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_NE(missing.err.find("no/such.cfg: error: there is no such file"), std::string::npos) << missing.err;
  const auto folder = check(folder_.string());
  EXPECT_EQ(folder.exit_code, 2);
  EXPECT_NE(folder.err.find("is a folder"), std::string::npos) << folder.err;
}

TEST_F(CheckCommand, prints_the_reference_of_all_keys) {
  const auto run = check("--keys");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out, key_reference());
}

}  // namespace
}  // namespace odas::check_command_test
