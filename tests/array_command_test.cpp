// SPDX-License-Identifier: MIT
// `odas array` and `odas arrays` as a user runs them.
#include "support/program.hpp"
#include "support/scratch.hpp"

namespace odas::array_command_test {
namespace {

test::ProgramRun odas(const std::vector<std::string>& arguments) {
  std::vector<std::string> command{test::program_path("odas")};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return test::run_program(command);
}

TEST(ArrayCommand, tells_what_a_geometry_can_hear) {
  const auto run = odas({"array", "respeaker_usb_4_mic"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  for (const char* piece :
       {"aperture        64.0 mm", "closest pair    45.3 mm", "from 2680 Hz (widest)", "6 of 6 hear",
        "All microphones are in a plane", "wrong by 4.5 us", "  azimuth         1.0 in the mean",
        "No two directions that are searched and 30 degrees apart look alike"}) {
    EXPECT_NE(run.out.find(piece), std::string::npos) << piece << '\n' << run.out;
  }
}

TEST(ArrayCommand, names_directions_that_look_alike) {
  const test::Scratch scratch;
  const auto file = scratch / "line.cfg";
  test::write_file(
      file,
      "raw: { fS = 16000; nChannels = 3; };\n"
      "general: { mics = ( { mu = (0, 0.05, 0); }, { mu = (0, -0.05, 0); }, { mu = (0, 0.02, 0); } ); };\n");
  const auto run = odas({"array", file.string()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("All microphones are on a line"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("degrees apart or more look alike, as\n  azimuth "), std::string::npos) << run.out;
}

TEST(ArrayCommand, draws_svg_and_png) {
  const test::Scratch scratch;
  const auto svg = scratch / "a.svg", png = scratch / "a.png";
  ASSERT_EQ(odas({"array", "pepper", "--svg", svg.string()}).exit_code, 0);
  EXPECT_NE(test::content(svg).find(">SoftBank Pepper<"), std::string::npos);
  const auto run = odas({"array", "pepper", "--png", png.string()});
  if (run.err.find("without cairo") != std::string::npos) GTEST_SKIP() << "built without cairo";
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(test::content(png).starts_with("\x89PNG"));
}

TEST(ArrayCommand, says_what_cannot_be_written) {
  const auto run = odas({"array", "pepper", "--svg", "/nowhere/a.svg"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("cannot write /nowhere/a.svg"), std::string::npos) << run.err;
}

TEST(Arrays, lists_names_and_what_they_are_for) {
  const auto run = odas({"arrays"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.out.find("minidsp_uma8         miniDSP UMA-8\n"), std::string::npos) << run.out;
  EXPECT_NE(odas({"arrays", "--paths"}).out.find("/configs/minidsp_uma8.cfg\n"), std::string::npos);
}

}  // namespace
}  // namespace odas::array_command_test
