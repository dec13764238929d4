// SPDX-License-Identifier: MIT
#include "odas/config/reader.hpp"

#include <cstdlib>
#include <filesystem>

#include "support/config_faults.hpp"

namespace odas::reader_test {
namespace {

namespace fs = std::filesystem;
using test::all_of;
using test::errs;
using test::read_with;

TEST(Reader, reports_all_faults_at_once_in_the_order_of_the_lines) {
  const auto loaded = read_configuration_text(R"(raw: {
  fS = "fast";
  nChannels = 2;
};
general: {
  gainMin = 7;
  mics = ( { mu = (0.1, 0, 0); angle = (90, 80); }, { mu = (0, 0, 0); direction = (0, 0, 0); } );
};
sst: { mode = "lidar"; };
)",
                                              "bad.cfg");
  EXPECT_FALSE(loaded.ok());
  ASSERT_EQ(loaded.faults.size(), 5U) << all_of(loaded.faults);
  EXPECT_EQ(to_string(loaded.faults[0]),
            "bad.cfg:2: error: raw.fS: is the text \"fast\", must be a whole number");
  EXPECT_EQ(to_string(loaded.faults[1]), "bad.cfg:6: error: general.gainMin: is 7, must be 0 to 1");
  EXPECT_EQ(loaded.faults[2].path, "general.mics[0].angle");
  EXPECT_EQ(loaded.faults[3].path, "general.mics[1].direction");
  EXPECT_EQ(loaded.faults[3].line, 7);
  EXPECT_EQ(loaded.faults[4].path, "sst.mode");
}

TEST(Reader, gives_the_line_of_a_syntax_error_and_what_stands_there) {
  const auto loaded = read_configuration_text("raw: {\n  fS = 16000\n  nChannels = = 2;\n};\n", "x.cfg");
  ASSERT_EQ(loaded.faults.size(), 1U);
  EXPECT_EQ(loaded.faults[0].line, 3);
  EXPECT_NE(loaded.faults[0].what.find("near: nChannels = = 2;"), std::string::npos) << all_of(loaded.faults);
}

TEST(Reader, names_a_key_that_is_given_twice) {
  const auto loaded = read_configuration_text("raw: {\n  fS = 16000;\n  fS = 8000;\n};\n", "x.cfg");
  ASSERT_EQ(loaded.faults.size(), 1U);
  EXPECT_EQ(loaded.faults[0].line, 3);
  EXPECT_NE(loaded.faults[0].what.find("given twice"), std::string::npos);
}

TEST(Reader, throws_all_faults_for_those_who_cannot_go_on) {
  try {
    (void)load_configuration("no/such/file.cfg");
    FAIL() << "must throw";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(), "no/such/file.cfg: error: there is no such file");
  }
}

TEST(Reader, wants_what_the_outputs_listen_to) {
  const Wanted none = read_with("").config.pipeline.wanted;
  EXPECT_FALSE(none.potentials || none.tracks || none.separated || none.postfiltered);
  const Wanted tracks =
      read_with(R"(sst: { tracked: { format = "json"; interface: { type = "terminal"; }; }; };)")
          .config.pipeline.wanted;
  EXPECT_TRUE(tracks.tracks);
  EXPECT_FALSE(tracks.separated);
  const Wanted category =
      read_with(R"(classify: { category: { format = "json"; interface: { type = "terminal"; }; }; };)")
          .config.pipeline.wanted;
  EXPECT_TRUE(category.categories);
}

TEST(Reader, makes_an_odd_frame_even_as_ODAS_does) {
  const auto loaded = test::read_changed("general: {", "general: { size: { frameSize = 257; };");
  EXPECT_TRUE(test::warns(loaded, "general.size.frameSize", "becomes 256"));
  EXPECT_EQ(loaded.config.pipeline.general.size.frame_size, 256);
}

TEST(Reader, keeps_the_lines_for_faults_that_are_found_later) {
  const auto loaded = read_with("sss: {\n  mode_sep = \"dgss\";\n};\n");
  const Fault late =
      loaded.locations.locate({Fault::Severity::error, "sss.mode_sep", "cannot be had", "", 0});
  EXPECT_EQ(late.file, "test.cfg");
  EXPECT_EQ(late.line, 9);
}

/// The folder beside the project that holds ODAS's files; empty where it is not.
fs::path shared() {
  if (const char* set = std::getenv("ODAS_SHARED")) return set;
  const fs::path beside = fs::path(ODAS_SOURCE_DIR) / "../shared";
  return fs::exists(beside) ? beside : fs::path();
}

std::vector<fs::path> files_below(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == extension) files.push_back(entry.path());
  }
  return files;
}

TEST(Reader, loads_all_files_that_ODAS_ships_and_those_it_refuses) {
  if (shared().empty()) GTEST_SKIP() << "ODAS's files are not here: set ODAS_SHARED";
  const auto files = files_below(shared() / "odas-configs", ".cfg");
  EXPECT_EQ(files.size(), 16U);
  for (const fs::path& file : files) {
    const auto loaded = read_configuration(file);
    EXPECT_TRUE(loaded.ok()) << all_of(loaded.faults);
    EXPECT_GE(loaded.config.pipeline.general.mics.size(), 4U);
    // Nothing in them is unknown; what is doubtful in two of them is said.
    for (const Fault& fault : loaded.faults)
      EXPECT_EQ(fault.what.find("unknown"), std::string::npos) << to_string(fault);
  }
}

TEST(Reader, warns_of_the_shipped_file_with_two_microphones_at_one_place) {
  if (shared().empty()) GTEST_SKIP() << "ODAS's files are not here: set ODAS_SHARED";
  const auto loaded = read_configuration(shared() / "odas-configs/delta1010lt.cfg");
  EXPECT_TRUE(test::warns(loaded, "general.mics[7].mu", "is the place of general.mics[6] too"));
}

TEST(Reader, loads_the_configurations_of_the_scenes) {
  if (shared().empty()) GTEST_SKIP() << "the scenes are not here: set ODAS_SHARED";
  const auto files = files_below(shared() / "scenes", ".cfg");
  EXPECT_GE(files.size(), 10U);
  for (const fs::path& file : files) EXPECT_TRUE(test::clean(read_configuration(file))) << file;
}

}  // namespace
}  // namespace odas::reader_test
