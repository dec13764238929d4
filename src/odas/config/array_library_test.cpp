// SPDX-License-Identifier: MIT
#include "odas/config/array_library.hpp"

#include <algorithm>

#include "support/scratch.hpp"

#include "odas/base/error.hpp"

namespace odas::array_library_test {
namespace {

namespace fs = std::filesystem;

class ArrayLibrary : public ::testing::Test {
 protected:
  ArrayLibrary() {
    for (const fs::path& folder : folders_) fs::create_directories(folder);
    test::write_file(folders_[0] / "kitchen.cfg", "# My kitchen: four microphones\n");
    test::write_file(folders_[1] / "respeaker_usb.cfg", "# ReSpeaker USB, v2.0: four microphones\n");
    test::write_file(folders_[1] / "kitchen.cfg", "# another\n");
    test::write_file(folders_[1] / "plain.cfg", "raw: {};\n");
    test::write_file(folders_[1] / "notes.txt", "# no array\n");
    fs::create_directory(folders_[1] / "folder.cfg");
  }
  std::string refusal(const std::string& name) const {
    try {
      return "found " + find_configuration(name, folders_).string();
    } catch (const ConfigError& error) { return error.what(); }
  }

  test::Scratch scratch_;
  std::vector<fs::path> folders_{scratch_ / "first", scratch_ / "second"};
};

TEST_F(ArrayLibrary, finds_a_name_in_the_first_folder_that_has_it) {
  EXPECT_EQ(find_configuration("kitchen", folders_), folders_[0] / "kitchen.cfg");
  EXPECT_EQ(find_configuration("respeaker_usb", folders_), folders_[1] / "respeaker_usb.cfg");
}

TEST_F(ArrayLibrary, takes_a_path_as_it_is_and_leaves_what_is_wrong_with_it_to_the_reader) {
  const fs::path file = scratch_ / "kitchen";
  test::write_file(file, "");
  EXPECT_EQ(find_configuration(file.string(), folders_), file);
  EXPECT_EQ(find_configuration("not/there", folders_), "not/there");
  EXPECT_EQ(find_configuration("nowhere.cfg", folders_), "nowhere.cfg");
}

TEST_F(ArrayLibrary, says_what_was_probably_meant_and_all_that_there_is) {
  EXPECT_NE(refusal("kitchne").find("did you mean \"kitchen\"?\nThere are: kitchen plain respeaker_usb"),
            std::string::npos)
      << refusal("kitchne");
  EXPECT_NE(refusal("respeaker").find("did you mean \"respeaker_usb\"?"), std::string::npos);
  EXPECT_NE(refusal("respeker").find("did you mean \"respeaker_usb\"?"), std::string::npos);
  EXPECT_NE(refusal("usb").find("did you mean \"respeaker_usb\"?"), std::string::npos);
  EXPECT_EQ(refusal("xyzzy").find("did you mean"), std::string::npos);
  EXPECT_NE(refusal("folder").find("no array of this name"), std::string::npos);
}

TEST_F(ArrayLibrary, lists_each_name_once_with_what_it_is_for) {
  const auto files = array_files(folders_);
  ASSERT_EQ(files.size(), 3U);
  EXPECT_EQ(files[0].name, "kitchen");
  EXPECT_EQ(files[0].title, "My kitchen");
  EXPECT_EQ(files[0].path, folders_[0] / "kitchen.cfg");
  EXPECT_EQ(files[1].title, "");
  EXPECT_EQ(files[2].title, "ReSpeaker USB, v2.0");
}

TEST(ArrayFolders, hold_the_arrays_of_the_source_tree_for_programs_of_a_build) {
  const auto files = array_files(array_folders());
  const auto sample =
      std::find_if(files.begin(), files.end(), [](const auto& f) { return f.name == "sample"; });
  ASSERT_NE(sample, files.end());
  EXPECT_TRUE(fs::equivalent(sample->path, fs::path(ODAS_SOURCE_DIR) / "configs/sample.cfg"));
}

}  // namespace
}  // namespace odas::array_library_test
