// SPDX-License-Identifier: MIT
// `odas score` as a user runs it.
#include <filesystem>
#include <fstream>

#include "support/program.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>

namespace odas::score_command_test {
namespace {

namespace fs = std::filesystem;

class ScoreCommand : public ::testing::Test {
 protected:
  ScoreCommand() {
    std::ofstream(folder_ / "truth.json") << R"({"fs":16000,"hop":128,"scene":{"seconds":0.016},"sources":[)"
                                          << R"({"doa":[[1,0,0],[1,0,0]],"active":[1,1]}]})";
  }
  void write_tracks() const {
    std::ofstream(folder_ / "tracks.jsonl")
        << R"({"timeStamp":2,"src":[{"slot":0,"id":1,"x":1,"y":0,"z":0}]})";
  }
  [[nodiscard]] test::ProgramRun score(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> command{test::program_path("odas"), "score", folder_.string(),
                                     (folder_ / "truth.json").string()};
    command.insert(command.end(), more.begin(), more.end());
    return test::run_program(command);
  }
  test::Scratch scratch_;
  fs::path folder_ = scratch_.folder();
};

TEST_F(ScoreCommand, prints_a_table_and_nothing_else) {
  write_tracks();
  const auto run = score();
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_NE(run.out.find("followed while talking (recall), %                50.0      50.0\n"),
            std::string::npos)
      << run.out;
}

TEST_F(ScoreCommand, prints_one_json_object_when_asked) {
  write_tracks();
  const auto run = score({"--json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with("{\"false_s\":0.0,")) << run.out;
  EXPECT_NE(run.out.find("\"az_recall\":0.5,"), std::string::npos) << run.out;
}

TEST_F(ScoreCommand, says_which_file_is_missing) {
  const auto run = score();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.out, "");
  EXPECT_NE(run.err.find("neither tracks.json nor tracks.jsonl"), std::string::npos) << run.err;
  write_tracks();
  fs::remove(folder_ / "truth.json");
  const auto no_truth = score();
  EXPECT_EQ(no_truth.exit_code, 1);
  EXPECT_NE(no_truth.err.find("cannot read the truth of a scene: there is no "), std::string::npos)
      << no_truth.err;
}

TEST_F(ScoreCommand, needs_both_folders) {
  const auto run = test::run_program({test::program_path("odas"), "score", folder_.string()});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("TRUTH"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace odas::score_command_test
