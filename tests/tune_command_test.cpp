// SPDX-License-Identifier: MIT
// `odas tune` on rooms whose truth is known.
#include <algorithm>
#include <memory>
#include <sstream>

#include "support/program.hpp"
#include "support/scratch.hpp"
#include <nlohmann/json.hpp>

namespace odas::tune_command_test {
namespace {

namespace fs = std::filesystem;
using test::ProgramRun;

/// Bins weighted by their noise, but ODAS's mixtures: 0.4 where somebody speaks, where here 0.2 is much.
constexpr const char* kArray = R"(# The array under test: four microphones
raw: { fS = 16000; nBits = 16; nChannels = 4; };  # from a file
general: { mics = ( { mu = (-0.032, 0, 0); }, { mu = (0, -0.032, 0); },
                    { mu = (0.032, 0, 0); }, { mu = (0, 0.032, 0); } ); };
@include "tracking.cfg"
)";
constexpr const char* kTracking = "ssl: { weighting = \"snr\"; };\nsst: { N_prob = 4; # keep me\n};\n";

class Tune : public ::testing::Test {
 protected:
  // Made once: nothing that is tested changes what is heard.
  static void SetUpTestSuite() {
    heard_ = std::make_unique<test::Scratch>();
    write_config(*heard_);
    simulate("silence", "", 1);
    // The sample's talkers as one voice with pauses, in a little room with echoes.
    simulate("talk", R"(, "sources": [ { "speech": ")" ODAS_SOURCE_DIR R"(/samples/sample_4mic.flac",
      "path": [ { "azimuth": 60, "elevation": 20, "distance": 1.5 } ] } ])",
             2);
  }
  static void TearDownTestSuite() { heard_.reset(); }
  void SetUp() override { write_config(scratch_); }

  [[nodiscard]] fs::path config() const { return scratch_ / "array.cfg"; }
  [[nodiscard]] fs::path tuned() const { return scratch_ / "tuned.cfg"; }
  [[nodiscard]] static std::string sound(const std::string& name) {
    return (*heard_ / name / "mics.wav").string();
  }

  static void write_config(const test::Scratch& folder) {
    test::write_file(folder / "array.cfg", kArray);
    test::write_file(folder / "tracking.cfg", kTracking);
  }

  static void simulate(const std::string& name, const std::string& sources, int seed) {
    const fs::path scene = *heard_ / (name + ".json");
    test::write_file(scene, R"({ "seconds": 14, "array": ")" + (*heard_ / "array.cfg").string() + R"(",
      "room": { "size": [5, 4, 2.8], "rt60": 0.4 }, "seed": )" +
                                std::to_string(seed) + sources + R"(, "noise": { "kind": "pink", )" +
                                (sources.empty() ? R"("level_db": -45)" : R"("snr_db": 20)") + " } }");
    const ProgramRun run = test::run_program(
        {test::program_path("odas"), "simulate", scene.string(), "-o", (*heard_ / name).string()});
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }

  [[nodiscard]] ProgramRun tune(const std::vector<std::string>& more) const {
    std::vector<std::string> command{test::program_path("odas"), "tune", config().string()};
    command.insert(command.end(), more.begin(), more.end());
    return test::run_program(command);
  }
  [[nodiscard]] ProgramRun tune_files() const {
    return tune({"--silence", sound("silence"), "--talk", sound("talk"), "-o", tuned().string()});
  }

  /// Hops in which somebody is followed.
  [[nodiscard]] int followed(const fs::path& config, const std::string& recording) const {
    const fs::path out = scratch_ / "out";
    const ProgramRun run = test::run_program(
        {test::program_path("odas"), "run", sound(recording), "-c", config.string(), "-o", out.string()});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    std::istringstream lines(test::content(out / "tracks.jsonl"));
    int hops = 0;
    for (std::string line; std::getline(lines, line);) {
      const auto hop = nlohmann::json::parse(line);
      const auto& sources = hop["src"];
      if (std::any_of(sources.begin(), sources.end(), [](const auto& source) { return source["id"] != 0; }))
        ++hops;
    }
    return hops;
  }

  test::Scratch scratch_;
  inline static std::unique_ptr<test::Scratch> heard_;
};

TEST_F(Tune, finds_the_talker_where_the_defaults_do_not_and_nobody_in_silence) {
  const ProgramRun run = tune_files();
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_LT(followed(config(), "talk"), 200) << "the room is to be too hard for the defaults";
  EXPECT_GT(followed(tuned(), "talk"), 1400) << "of 1750 hops";
  EXPECT_EQ(followed(tuned(), "silence"), 0);
}

TEST_F(Tune, writes_a_configuration_that_differs_in_its_mixtures_alone) {
  ASSERT_EQ(tune_files().exit_code, 0);
  std::string text = test::content(tuned());
  for (const char* kept :
       {"# The array under test: four microphones\n", "};  # from a file\n", "N_prob = 4; # keep me\n"}) {
    EXPECT_NE(text.find(kept), std::string::npos) << text;
  }
  EXPECT_EQ(text.find("@include"), std::string::npos) << "it stands for itself, wherever it is put";
  EXPECT_EQ(test::run_program({test::program_path("odas"), "check", tuned().string()}).exit_code, 0);
  ASSERT_EQ(tune_files().exit_code, 0);
  EXPECT_EQ(test::content(tuned()), text) << "the same from the same";
}

TEST_F(Tune, draws_the_histograms_and_says_how_well_they_part) {
  const fs::path svg = scratch_ / "energies.svg";
  const ProgramRun run =
      tune({"--silence", sound("silence"), "--talk", sound("talk"), "--svg", svg.string()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(test::content(svg).find(">told apart at "), std::string::npos);
  for (const char* piece : {"strongest of each hop", " > ", "##", "Told apart at E = ", "sst.active = ("}) {
    EXPECT_NE(run.out.find(piece), std::string::npos) << piece << '\n' << run.out;
  }
}

TEST_F(Tune, writes_nothing_where_nobody_talked) {
  const ProgramRun run =
      tune({"--silence", sound("silence"), "--talk", sound("silence"), "-o", tuned().string()});
  EXPECT_EQ(run.exit_code, 1) << run.out;
  EXPECT_NE(run.err.find("cannot be told from the silence"), std::string::npos) << run.err;
  EXPECT_FALSE(fs::exists(tuned()));
}

TEST_F(Tune, refuses_what_it_cannot_measure_and_says_what_would_do) {
  EXPECT_EQ(tune({"--silence", sound("silence")}).exit_code, 2);
  EXPECT_NE(tune({}).err.find("is \"blackhole\""), std::string::npos) << tune({}).err;
  const ProgramRun itself =
      tune({"--silence", sound("silence"), "--talk", sound("talk"), "-o", config().string()});
  EXPECT_EQ(itself.exit_code, 1);
  EXPECT_NE(itself.err.find("is the configuration itself"), std::string::npos) << itself.err;
  EXPECT_EQ(test::content(config()), kArray);
}

}  // namespace
}  // namespace odas::tune_command_test
