// SPDX-License-Identifier: MIT
// `odas run` as a user runs it: the built program, real files, exit codes and messages.
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "support/program.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sndfile.hh>

#include "odas/io/wav_writer.hpp"

namespace odas::run_test {
namespace {

namespace fs = std::filesystem;
using test::ProgramOptions;
using test::ProgramRun;

constexpr int kRate = 16000;
constexpr std::size_t kSecond = 16000;  // frames
constexpr std::size_t kHop = 128;
constexpr std::size_t kSlots = 4;

/// Noise from 40 degrees at the four microphones of configs/sample.cfg, from the first to the last quarter,
/// over a little noise of each microphone's own. Made at 32 times the rate, so that a delay is a shift.
std::vector<float> plane_wave(std::size_t frames) {
  constexpr std::size_t kUp = 32;
  constexpr double kAzimuth = 40 * 3.14159265 / 180;
  constexpr std::array<std::array<double, 2>, 4> kMics{{{-0.032, 0}, {0, -0.032}, {0.032, 0}, {0, 0.032}}};
  std::mt19937 generator(1);
  std::normal_distribution<float> normal(0, 1);
  std::vector<float> fine((frames + 8) * kUp);
  for (float& x : fine) x = normal(generator);
  std::vector<float> samples(frames * 4);
  for (std::size_t m = 0; m < 4; ++m) {
    const double delay = -(kMics[m][0] * std::cos(kAzimuth) + kMics[m][1] * std::sin(kAzimuth)) / 343;
    const auto shift = static_cast<std::size_t>(std::lround((4 - delay * kRate) * kUp));
    for (std::size_t n = 0; n < frames; ++n) {
      float sum = 0;  // over a sample and a half: keeps to what the recording's rate can carry
      for (std::size_t k = 0; k < 48; ++k) sum += fine[n * kUp + shift + k];
      const bool sounds = n >= frames / 4 && n < 3 * frames / 4;
      samples[n * 4 + m] = (sounds ? 0.01F * sum : 0) + 0.0005F * normal(generator);
    }
  }
  return samples;
}

class Run : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(config()) << R"(
      raw: { fS = 16000; hopSize = 128; nBits = 16; nChannels = 4; };
      general: { mics = ( { mu = (-0.032, 0.0, 0.0); }, { mu = (0.0, -0.032, 0.0); },
                          { mu = (0.032, 0.0, 0.0); }, { mu = (0.0, 0.032, 0.0); } ); };
    )";
  }

  [[nodiscard]] fs::path config() const { return folder_ / "array.cfg"; }
  [[nodiscard]] fs::path out() const { return folder_ / "out"; }

  /// A recording of a talker; the format by the name's ending.
  fs::path record(const std::string& name, std::size_t frames, int rate = kRate, int channels = 4) const {
    const fs::path file = folder_ / name;
    const std::vector<float> samples = plane_wave(frames);
    const int format = name.ends_with(".flac")  ? SF_FORMAT_FLAC
                       : name.ends_with(".raw") ? SF_FORMAT_RAW | SF_ENDIAN_LITTLE
                                                : SF_FORMAT_WAV;
    SndfileHandle sound(file.string(), SFM_WRITE, format | SF_FORMAT_PCM_16, channels, rate);
    sound.writef(samples.data(), static_cast<sf_count_t>(frames * 4) / channels);
    return file;
  }

  [[nodiscard]] ProgramRun run(const fs::path& recording, std::vector<std::string> more = {},
                               const ProgramOptions& options = {}) const {
    std::vector<std::string> command{test::program_path("odas"), "run", recording.string(), "-c",
                                     config().string(),          "-o",  out().string()};
    command.insert(command.end(), more.begin(), more.end());
    return run_program(command, options);
  }

  [[nodiscard]] std::string text(const std::string& name) const {
    std::ifstream in(out() / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  [[nodiscard]] std::vector<nlohmann::json> lines(const std::string& name) const {
    std::vector<nlohmann::json> result;
    std::ifstream in(out() / name);
    for (std::string line; std::getline(in, line);) result.push_back(nlohmann::json::parse(line));
    return result;
  }

  test::Scratch scratch_;
  fs::path folder_ = scratch_.folder();
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(Run, says_who_was_where_and_writes_it_all_down) {
  const ProgramRun result = run(record("talk.wav", 4 * kSecond));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.err, (out() / "report.html").string())) << result.err;
  EXPECT_FALSE(contains(result.err, "\r")) << "no progress where there is no terminal";

  const auto index = nlohmann::json::parse(text("voices/index.json"));
  ASSERT_GE(index.size(), 1U);
  EXPECT_TRUE(contains(result.out, "voices/" + index[0]["file"].get<std::string>())) << result.out;
  EXPECT_NEAR(index[0]["azimuth"].get<double>(), 40,
              8);  // 64 mm across at 16 kHz: a quarter lag is 5 degrees
  EXPECT_NEAR(index[0]["start"].get<double>(), 1, 0.5);
  const SndfileHandle voice((out() / "voices" / index[0]["file"].get<std::string>()).string());
  EXPECT_NEAR(static_cast<double>(voice.frames()) / kRate, index[0]["seconds"].get<double>(), 1e-3);
  EXPECT_GT(voice.frames(), kRate);

  EXPECT_EQ(SndfileHandle((out() / "microphone_1.wav").string()).frames(), 4 * kRate);
  EXPECT_TRUE(contains(text("report.html"), "id=\"audio-0\""));
  EXPECT_FALSE(lines("tracks.jsonl").empty());
  EXPECT_FALSE(lines("potentials.jsonl").empty());
  EXPECT_FALSE(fs::exists(out() / "tracks.json")) << "only with --odas-files";
}

TEST_F(Run, hears_the_same_from_wav_flac_and_headerless) {
  ASSERT_EQ(run(record("talk.wav", 2 * kSecond)).exit_code, 0);
  const std::string voice =
      "voices/" + nlohmann::json::parse(text("voices/index.json"))[0]["file"].get<std::string>();
  const std::string from_wav = text(voice);
  for (const char* name : {"talk.flac", "talk.raw"}) {
    const ProgramRun result = run(record(name, 2 * kSecond));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(text(voice) == from_wav) << name;
  }
}

TEST_F(Run, pads_the_last_hop_and_begins_with_the_sound_itself) {
  const ProgramRun result = run(record("talk.wav", 9 * kHop + 1), {"--odas-files"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(fs::file_size(out() / "separated.raw"), 10 * kHop * kSlots * 2);
  EXPECT_EQ(fs::file_size(out() / "postfiltered.raw"), 10 * kHop * kSlots * 2);
  for (const char* name : {"pots.json", "tracks.json"}) {
    EXPECT_TRUE(text(name).starts_with("{\n    \"timeStamp\": 1,\n    \"src\": [\n")) << text(name);
    EXPECT_TRUE(contains(text(name), "\"timeStamp\": 10,")) << name;
    EXPECT_FALSE(contains(text(name), "\"timeStamp\": 11,")) << name;
  }
}

TEST_F(Run, replaces_the_files_of_an_earlier_run_and_no_others) {
  fs::create_directories(out() / "voices");
  std::ofstream(out() / "voices/source_99.wav") << "old";
  std::ofstream(out() / "voices/keep.txt") << "mine";
  std::ofstream(out() / "tracks.jsonl") << "not json\n";
  ASSERT_EQ(run(record("talk.wav", kSecond)).exit_code, 0);
  EXPECT_FALSE(fs::exists(out() / "voices/source_99.wav"));
  EXPECT_TRUE(fs::exists(out() / "voices/keep.txt"));
  EXPECT_FALSE(contains(text("tracks.jsonl"), "not json"));
}

TEST_F(Run, leaves_no_ODAS_files_of_an_earlier_run_to_be_taken_for_its_own) {
  ASSERT_EQ(run(record("talk.wav", kSecond), {"--odas-files"}).exit_code, 0);
  ASSERT_TRUE(fs::exists(out() / "tracks.json"));
  ASSERT_EQ(run(record("talk.wav", kSecond)).exit_code, 0);
  EXPECT_FALSE(fs::exists(out() / "tracks.json"));
}

TEST_F(Run, shows_its_progress_on_a_terminal) {
  ProgramOptions terminal;
  terminal.terminal = true;
  const ProgramRun result = run(record("talk.wav", 2 * kSecond), {}, terminal);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(contains(result.err, " left")) << result.err;
}

TEST_F(Run, finishes_its_files_on_ctrl_c) {
  const fs::path recording = folder_ / "long.raw";
  std::ofstream(recording) << "";
  fs::resize_file(recording, 3600ULL * kRate * 4 * 2);  // an hour of silence; takes no room
  ProgramOptions options;
  options.interrupt_when = [this] {
    std::error_code none;
    return fs::file_size(out() / "microphone_1.wav", none) > 100'000 && !none;
  };
  const ProgramRun result = run(recording, {}, options);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.err, "stopped at")) << result.err;
  EXPECT_LT(SndfileHandle((out() / "microphone_1.wav").string()).frames(), 3600 * kRate);
  EXPECT_GT(SndfileHandle((out() / "microphone_1.wav").string()).frames(), 0);
  EXPECT_TRUE(contains(text("report.html"), "stopped before the recording ended"));
  EXPECT_FALSE(lines("tracks.jsonl").empty());
}

TEST_F(Run, ends_with_what_it_could_write_when_the_disk_is_full) {
  ProgramOptions options;
  options.largest_file = 100'000;
  const ProgramRun result = run(record("talk.wav", 8 * kSecond), {}, options);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(contains(result.err, "cannot write") || contains(result.err, "full")) << result.err;
  // Whole: the header tells the true length, and no line is cut.
  const SndfileHandle reference((out() / "microphone_1.wav").string());
  EXPECT_EQ(reference.error(), 0);
  EXPECT_EQ(static_cast<std::uintmax_t>(reference.frames()) * 2 + kWavHeaderSize,
            fs::file_size(out() / "microphone_1.wav"));
  EXPECT_NO_THROW(static_cast<void>(lines("tracks.jsonl")));
  EXPECT_NO_THROW(static_cast<void>(lines("potentials.jsonl")));
}

struct BadInput {
  const char* name;
  std::vector<const char*> says;
};

TEST_F(Run, says_what_is_wrong_with_a_recording) {
  std::ofstream(folder_ / "empty.wav") << "";
  std::ofstream(folder_ / "empty.raw") << "";
  std::ofstream(folder_ / "text.wav") << "this is not a sound";
  record("fast.wav", kSecond, 44100);
  record("stereo.wav", kSecond, kRate, 2);
  const std::vector<BadInput> inputs{
      {"missing.wav", {"missing.wav"}}, {"empty.wav", {"empty.wav"}}, {"empty.raw", {"empty.raw"}},
      {"fast.wav", {"44100", "16000"}}, {"stereo.wav", {"2", "4"}},
  };
  for (const BadInput& input : inputs) {
    const ProgramRun result = run(folder_ / input.name);
    EXPECT_EQ(result.exit_code, 1) << input.name << ": " << result.err;
    for (const char* part : input.says) EXPECT_TRUE(contains(result.err, part)) << result.err;
    EXPECT_TRUE(result.out.empty()) << input.name;
    EXPECT_FALSE(fs::exists(out())) << input.name
                                    << ": nothing is touched before the input is known to be good";
  }
}

TEST_F(Run, processes_what_is_there_of_a_truncated_recording) {
  const fs::path whole = record("cut.wav", 2 * kSecond);
  fs::resize_file(whole, fs::file_size(whole) / 2);
  const ProgramRun result = run(whole);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.err, "warning")) << result.err;
  EXPECT_NEAR(static_cast<double>(SndfileHandle((out() / "microphone_1.wav").string()).frames()), kRate, 100);
}

TEST_F(Run, refuses_a_folder_that_it_cannot_use) {
  const fs::path recording = record("talk.wav", kSecond);
  std::ofstream(out()) << "a file";
  const ProgramRun on_file = run(recording);
  EXPECT_EQ(on_file.exit_code, 1);
  EXPECT_TRUE(contains(on_file.err, "is a file")) << on_file.err;
  EXPECT_EQ(fs::file_size(out()), 6U) << "the file is as it was";

  const fs::path below = out() / "below";
  const ProgramRun under_file = test::run_program(
      {test::program_path("odas"), "run", recording.string(), "-c", config().string(), "-o", below.string()});
  EXPECT_EQ(under_file.exit_code, 1);
  EXPECT_TRUE(contains(under_file.err, below.string())) << under_file.err;
}

TEST_F(Run, does_not_overwrite_its_own_recording) {
  fs::create_directories(out());
  fs::rename(record("talk.wav", kSecond), out() / "microphone_1.wav");
  const auto size = fs::file_size(out() / "microphone_1.wav");
  const ProgramRun result = run(out() / "microphone_1.wav");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(contains(result.err, "overwrite")) << result.err;
  EXPECT_EQ(fs::file_size(out() / "microphone_1.wav"), size);
}

TEST_F(Run, warns_of_a_dead_microphone_on_screen_and_in_the_report) {
  std::vector<float> samples = plane_wave(2 * kSecond);
  for (std::size_t i = 2; i < samples.size(); i += 4) samples[i] = 0;
  const fs::path file = folder_ / "dead.wav";
  {
    SndfileHandle sound(file.string(), SFM_WRITE, SF_FORMAT_WAV | SF_FORMAT_PCM_16, 4, kRate);
    sound.writef(samples.data(), static_cast<sf_count_t>(2 * kSecond));
  }
  const ProgramRun result = run(file);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.err, "microphone 3")) << result.err;
  EXPECT_TRUE(contains(text("report.html"), "microphone 3"));
}

TEST_F(Run, ends_with_2_on_wrong_usage_and_wrong_configuration) {
  const fs::path recording = record("talk.wav", kSecond);
  EXPECT_EQ(test::run_program({test::program_path("odas"), "run", recording.string()}).exit_code, 2);
  std::ofstream(config(), std::ios::app) << "ssl: { nPots = -3; };\n";
  const ProgramRun result = run(recording);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(contains(result.err, "array.cfg:")) << result.err;
  EXPECT_TRUE(contains(result.err, "nPots")) << result.err;
}

}  // namespace
}  // namespace odas::run_test
