// SPDX-License-Identifier: MIT
// Bad input and a bad world: each is said, with the right exit code, and what was written is whole.
#include <cmath>
#include <limits>

#include "support/small_run.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "odas/io/wav_writer.hpp"

namespace odas::faults_test {
namespace {

using test::has;
using test::SmallRun;

constexpr const char* kWav = R"(type = "file"; path = "mics.wav";)";

/// Lines of JSON that are all whole. -1 where one is not.
int whole_lines(const std::string& text) {
  int lines = 0;
  for (std::size_t at = 0; at < text.size(); ++lines) {
    const std::size_t end = text.find('\n', at);
    if (end == std::string::npos || !nlohmann::json::accept(text.substr(at, end - at))) return -1;
    at = end + 1;
  }
  return lines;
}

void use_json_lines(SmallRun& run) {
  run.potential = R"(format = "jsonl"; interface: { type = "file"; path = "pots.jsonl"; };)";
  run.tracked = R"(format = "jsonl"; interface: { type = "file"; path = "tracks.jsonl"; };)";
  run.separated = R"(interface: { type = "file"; path = "separated.wav"; };)";
}

TEST(Faults, a_missing_recording_is_said_and_nothing_is_written) {
  SmallRun run;
  for (const auto& result : {run.odas_live(), run.odaslive()}) {
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(has(result.err, "cannot open mics.raw: No such file or directory")) << result.err;
  }
  EXPECT_FALSE(std::filesystem::exists(run.file("pots.json")));
}

TEST(Faults, an_empty_recording_is_said) {
  SmallRun run;
  test::write_file(run.file("mics.raw"), "");
  const auto result = run.odas_live();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(has(result.err, "mics.raw is empty")) << result.err;
}

TEST(Faults, a_recording_of_another_rate_is_said) {
  SmallRun run;
  run.record_wav(SmallRun::sound(1000), 44100);
  run.source = kWav;
  const auto result = run.odas_live();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(has(result.err, "mics.wav has 44100 Hz, but raw.fS is 16000")) << result.err;
}

TEST(Faults, a_recording_of_another_array_is_said) {
  SmallRun run;
  run.record_wav(test::noise(2, 1000));
  run.source = kWav;
  const auto result = run.odas_live();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(has(result.err, "mics.wav has 2 channels, but raw.nChannels is 3")) << result.err;
}

TEST(Faults, a_recording_that_was_cut_is_processed_to_its_end_and_said) {
  SmallRun run;
  use_json_lines(run);
  run.record_wav(SmallRun::sound(32000));
  std::filesystem::resize_file(run.file("mics.wav"), std::filesystem::file_size(run.file("mics.wav")) / 2);
  run.source = kWav;
  const auto result = run.odas_live();
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(has(result.err, "warning: mics.wav ends early, after 1.0 s of 2.0 s")) << result.err;
  EXPECT_NEAR(whole_lines(run.text("tracks.jsonl")), 125, 1);
}

TEST(Faults, a_damaged_recording_is_processed_as_far_as_it_goes_and_is_a_failure) {
  SmallRun run;
  use_json_lines(run);
  run.record("mics.flac", SmallRun::sound(32000), SF_FORMAT_FLAC | SF_FORMAT_PCM_16);
  std::filesystem::resize_file(run.file("mics.flac"), std::filesystem::file_size(run.file("mics.flac")) / 2);
  run.source = R"(type = "file"; path = "mics.flac";)";
  const auto result = run.odas_live();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(has(result.err, "cannot read on in mics.flac after")) << result.err;
  EXPECT_GT(whole_lines(run.text("tracks.jsonl")), 50);
}

TEST(Faults, samples_that_are_no_numbers_are_counted_and_do_not_spread) {
  SmallRun run;
  use_json_lines(run);
  Grid<float> sound = SmallRun::sound(32000);
  sound[1][1000] = std::numeric_limits<float>::quiet_NaN();
  sound[2][1001] = std::numeric_limits<float>::infinity();
  run.record("mics.wav", sound, SF_FORMAT_WAV | SF_FORMAT_FLOAT);
  run.source = kWav;
  const auto result = run.odas_live();
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(has(result.err, "warning: 2 samples of the input were not numbers")) << result.err;
  std::string last = run.text("pots.jsonl");
  last = last.substr(last.rfind('\n', last.size() - 2) + 1);
  EXPECT_GT(nlohmann::json::parse(last)["src"][0]["E"], 0.1);
}

TEST(Faults, dead_duplicate_and_clipped_microphones_are_named) {
  SmallRun run;
  Grid<float> sound = SmallRun::sound(32000);
  std::fill(sound[2].begin(), sound[2].end(), 0.0F);
  run.record_raw(sound);
  auto result = run.odas_live();
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "odas: warning: microphone 3 (channel 3) is silent\n");

  sound = SmallRun::sound(32000);
  std::copy(sound[0].begin(), sound[0].end(), sound[1].begin());
  run.record_raw(sound);
  EXPECT_TRUE(has(run.odas_live().err, "microphone 2 (channel 2) is the same as microphone 1 (channel 1)"));

  sound = SmallRun::sound(32000);
  for (float& x : sound[1]) x = std::clamp(30 * x, -1.0F, 0.9999F);
  run.record_raw(sound);
  EXPECT_TRUE(has(run.odas_live().err, "microphone 2 (channel 2) is clipped"));
}

TEST(Faults, an_output_that_cannot_be_written_is_said_before_anything_starts) {
  SmallRun run;
  run.record_raw(SmallRun::sound(32000));
  run.separated = R"(interface: { type = "file"; path = "no/such/folder/separated.wav"; };)";
  for (const auto& result : {run.odas_live(), run.odaslive()}) {
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(has(result.err, "cannot write no/such/folder/separated.wav: No such file or directory"))
        << result.err;
  }
  EXPECT_EQ(run.text("pots.json"), "");
}

TEST(Faults, a_full_disk_stops_the_run_and_is_said_once) {
  SmallRun run;
  run.record_raw(SmallRun::sound(160000));
  run.tracked = R"(format = "json"; interface: { type = "file"; path = "/dev/full"; };)";
  for (const auto& result : {run.odas_live(), run.odaslive(), run.odaslive({"-s"})}) {
    EXPECT_EQ(result.exit_code, 1);
    const std::string what = "sst.tracked (/dev/full): cannot write /dev/full: No space left on device";
    const std::size_t first = result.err.find(what);
    ASSERT_NE(first, std::string::npos) << result.err;
    EXPECT_EQ(result.err.find(what, first + 1), std::string::npos);
  }
}

TEST(Faults, what_was_written_before_the_disk_was_full_is_whole) {
  SmallRun run;
  use_json_lines(run);
  run.record_raw(SmallRun::sound(160000));
  test::ProgramOptions options;
  options.largest_file = 100000;
  const auto result = run.odas_live({}, options);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(has(result.err, "cannot write")) << result.err;
  EXPECT_GT(whole_lines(run.text("pots.jsonl")), 100);
  EXPECT_GT(whole_lines(run.text("tracks.jsonl")), 10);
  const SndfileHandle wav(run.file("separated.wav").string());
  EXPECT_EQ(wav.channels(), 4);
  EXPECT_GT(wav.frames(), 1000);
  EXPECT_EQ(std::filesystem::file_size(run.file("separated.wav")),
            kWavHeaderSize + static_cast<unsigned>(wav.frames()) * 8);
}

/// Ends a run that would never end by a signal.
void expect_finished_files(int signal) {
  SmallRun run;
  use_json_lines(run);
  run.source = R"(type = "file"; path = "/dev/urandom";)";  // never ends
  test::ProgramOptions options;
  options.interruption = signal;
  options.interrupt_when = [&] {
    std::error_code ignored;
    return std::filesystem::file_size(run.file("tracks.jsonl"), ignored) > 1000 && !ignored;
  };
  const auto result = run.odas_live({}, options);
  EXPECT_EQ(result.exit_code, 0) << "signal " << signal << ": " << result.err;
  const int hops = whole_lines(run.text("tracks.jsonl"));
  EXPECT_GT(hops, 10);
  EXPECT_EQ(whole_lines(run.text("pots.jsonl")), hops);
  EXPECT_EQ(SndfileHandle(run.file("separated.wav").string()).frames(), 128 * hops);
}

TEST(Faults, ctrl_c_finishes_the_files) { expect_finished_files(SIGINT); }

TEST(Faults, a_service_that_is_stopped_and_a_terminal_that_is_closed_leave_finished_files) {
  expect_finished_files(SIGTERM);
  expect_finished_files(SIGHUP);
}

TEST(Faults, a_reader_of_stdout_that_goes_away_is_said) {
  SmallRun run;
  run.record_raw(SmallRun::sound(160000));
  run.tracked = R"(format = "jsonl"; interface: { type = "terminal"; };)";
  test::write_file(run.file("run.cfg"), run.configuration());
  test::ProgramOptions options;
  options.working_directory = run.file("");
  const auto result = test::run_program(
      {"/bin/sh", "-c",
       "{ '" + test::program_path("odas") + "' live -c run.cfg; echo $? > code; } | head -n 3"},
      options);
  EXPECT_EQ(whole_lines(result.out), 3);
  EXPECT_EQ(run.text("code"), "1\n");
  EXPECT_TRUE(has(result.err, "sst.tracked (standard output): nobody reads it any more")) << result.err;
}

TEST(Faults, a_wrong_configuration_has_code_2_and_all_its_faults) {
  SmallRun run;
  run.general = "gainMin = 5.0; nThetas = 0;";
  const auto result = run.odas_live();
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(has(result.err, "general.gainMin")) << result.err;
  EXPECT_TRUE(has(result.err, "general.nThetas")) << result.err;
}

}  // namespace
}  // namespace odas::faults_test
