// SPDX-License-Identifier: MIT
#include "odas/config/source_text.hpp"

#include <fstream>

#include "support/scratch.hpp"
#include <gtest/gtest.h>

namespace odas::source_text_test {
namespace {

namespace fs = std::filesystem;

std::string prepared(std::string_view text) {
  std::vector<Fault> faults;
  std::string out = SourceText::from_text(text, "t.cfg", faults).text();
  EXPECT_TRUE(faults.empty()) << to_string(faults.front());
  return out;
}

std::vector<Fault> faults_of(std::string_view text) {
  std::vector<Fault> faults;
  SourceText::from_text(text, "t.cfg", faults);
  return faults;
}

class SourceFiles : public ::testing::Test {
 protected:
  SourceFiles() { fs::create_directories(folder_ / "parts"); }
  fs::path write(const std::string& name, std::string_view text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  test::Scratch scratch_;
  fs::path folder_ = scratch_.folder();
};

TEST(SourceText, makes_lists_of_arrays_so_that_numbers_may_mix) {
  EXPECT_EQ(prepared("a = [1, 2.5];"), "a = (1, 2.5);\n");
}

TEST(SourceText, keeps_whole_numbers_that_libconfig_would_cut) {
  EXPECT_EQ(prepared("a = 99999999999;"), "a = 99999999999.0;\n");
  EXPECT_EQ(prepared("a = -99999999999;"), "a = -99999999999.0;\n");
  EXPECT_EQ(prepared("a = 99999999999L;"), "a = 99999999999.0;\n");
  EXPECT_EQ(prepared("a = 0xFFFFFFFF;"), "a = 4294967295.000000;\n");
  EXPECT_EQ(prepared("a = 2147483647; b = 0x7F; c = 1E-20; d = -.5; e = 1.; f = +0.3"),
            "a = 2147483647; b = 0x7F; c = 1E-20; d = -.5; e = 1.; f = +0.3\n");
}

TEST(SourceText, leaves_strings_comments_and_names_as_they_are) {
  for (const char* text : {"a = \"[99999999999 { \\\" (\";\n", "# [ 99999999999\n", "// ( {\n",
                           "/* [ \n @include \"x\" ( */\n", "mics99999999999 = 1;\n", "a-9 = 1;\n"}) {
    EXPECT_EQ(prepared(text), text);
  }
}

TEST(SourceText, names_both_ends_of_brackets_that_do_not_match) {
  const auto wrong = faults_of("a = (\n1, 2\n};\n");
  ASSERT_EQ(wrong.size(), 1U);
  EXPECT_EQ(to_string(wrong[0]), "t.cfg:3: error: '}' closes the '(' of line 1");
  const auto open = faults_of("\ngeneral: {\n a = 1;\n");
  ASSERT_EQ(open.size(), 1U);
  EXPECT_EQ(to_string(open[0]), "t.cfg:2: error: '{' that is opened here is never closed");
  EXPECT_EQ(faults_of("a = 1; }").at(0).what, "'}' closes nothing");
  EXPECT_EQ(faults_of("a = \"x;\n").at(0).what, "the quote that is opened here is never closed");
  EXPECT_EQ(faults_of("/* x\n").at(0).what, "the comment that is opened here is never closed");
}

TEST(SourceText, names_a_text_that_stands_where_none_can) {
  EXPECT_EQ(faults_of("a \"x\";").at(0).what,
            "a text in quotes cannot stand here; is a '=' missing before it?");
  EXPECT_EQ(faults_of("a = (1 \"x\");").at(0).what,
            "a text in quotes cannot stand here; is a ',' missing before it?");
  EXPECT_TRUE(faults_of("a = \"x\" // go on\n \"y\"; b: \"z\"; c = (\"x\", [\"y\"]);").empty());
}

TEST(SourceText, refuses_nesting_that_no_configuration_has) {
  EXPECT_TRUE(faults_of("a=" + std::string(64, '(') + std::string(64, ')')).empty());
  EXPECT_FALSE(faults_of("a=" + std::string(65, '(') + std::string(65, ')')).empty());
}

TEST(SourceText, refuses_zero_bytes) { EXPECT_EQ(faults_of(std::string("a = 1;\0b = 2;", 13)).size(), 1U); }

TEST(SourceText, reads_files_written_on_windows) {
  EXPECT_EQ(prepared("a = 1;\r\nb = 2;\r\n"), "a = 1;\nb = 2;\n");
}

TEST_F(SourceFiles, puts_included_files_in_and_keeps_their_lines) {
  write("parts/mics.cfg", "# first\nm = 1;\n");
  const fs::path main = write("main.cfg", "a = 1;\n  @include \"parts/mics.cfg\"\nb = 2;\n");
  std::vector<Fault> faults;
  const SourceText source = SourceText::from_file(main, faults);
  EXPECT_TRUE(faults.empty());
  EXPECT_EQ(source.text(), "a = 1;\n# first\nm = 1;\nb = 2;\n");
  EXPECT_EQ(source.location(3).file, (folder_ / "parts/mics.cfg").string());
  EXPECT_EQ(source.location(3).line, 2);
  EXPECT_EQ(source.location(4).file, main.string());
  EXPECT_EQ(source.location(4).line, 3);
  EXPECT_EQ(source.excerpt(4), "b = 2;");
  EXPECT_EQ(source.written(), source.text());
}

TEST_F(SourceFiles, find_what_a_copied_array_file_includes) {
  const fs::path copy = write("copy.cfg", "@include \"common/hearing.cfg\"\n");
  std::vector<Fault> faults;
  const SourceText source = SourceText::from_file(copy, faults);
  EXPECT_TRUE(faults.empty()) << to_string(faults.front());
  EXPECT_NE(source.text().find("srp_clean"), std::string::npos);
}

TEST_F(SourceFiles, say_at_the_including_line_what_cannot_be_included) {
  const fs::path main = write("main.cfg", "\n@include \"nowhere.cfg\"\n@include \"parts\"\n");
  std::vector<Fault> faults;
  SourceText::from_file(main, faults);
  ASSERT_EQ(faults.size(), 2U);
  EXPECT_EQ(faults[0].line, 2);
  EXPECT_NE(faults[0].what.find("there is no such file"), std::string::npos);
  EXPECT_EQ(faults[1].line, 3);
  EXPECT_NE(faults[1].what.find("is a folder"), std::string::npos);
}

TEST_F(SourceFiles, stop_where_a_file_includes_itself) {
  const fs::path main = write("main.cfg", "a = 1;\n@include \"main.cfg\"\n");
  std::vector<Fault> faults;
  SourceText::from_file(main, faults);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_NE(faults[0].what.find("included too deep"), std::string::npos);
}

TEST_F(SourceFiles, skip_a_byte_order_mark) {
  std::vector<Fault> faults;
  EXPECT_EQ(SourceText::from_file(write("bom.cfg",
                                        "\xEF\xBB\xBF"
                                        "a = 1;\n"),
                                  faults)
                .text(),
            "a = 1;\n");
}

TEST_F(SourceFiles, refuse_what_is_no_configuration) {
  const auto refused = [](const fs::path& path) {
    std::vector<Fault> faults;
    SourceText::from_file(path, faults);
    return faults.empty() ? "" : faults[0].what;
  };
  EXPECT_EQ(refused(folder_ / "none.cfg"), "there is no such file");
  EXPECT_EQ(refused(folder_), "is a folder; a configuration file is wanted");
  EXPECT_EQ(refused(write("zero.cfg", std::string_view("a\0b", 3))),
            "holds zero bytes: this is no text file");
  EXPECT_EQ(refused(write("huge.cfg", std::string((4U << 20U) + 1, ' '))),
            "is larger than 4 MiB: this is no configuration");
}

}  // namespace
}  // namespace odas::source_text_test
