// SPDX-License-Identifier: MIT
// odaslive as those run it who have ODAS in their scripts.
#include <algorithm>
#include <cstring>

#include "support/goldens.hpp"
#include "support/small_run.hpp"
#include <fcntl.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "odas/io/file_descriptor.hpp"
#include "odas/io/tcp_listener.hpp"

namespace odas::odaslive_test {
namespace {

using test::has;
using test::SmallRun;

/// ODAS's clients cut the stream between `}` and `{`.
std::vector<nlohmann::json> hops_of(const std::string& stream) {
  std::vector<nlohmann::json> hops;
  for (std::size_t at = 0; at < stream.size();) {
    const std::size_t end = std::min(stream.find("}\n{", at), stream.size() - 2) + 2;
    hops.push_back(nlohmann::json::parse(stream.substr(at, end - at)));
    at = end;
  }
  return hops;
}

TEST(Odaslive, begins_with_a_silent_hop_and_drops_the_last_block_that_is_not_full) {
  SmallRun run;
  run.record_raw(SmallRun::sound(128 * 50 + 100));
  const auto result = run.odaslive();
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, "");
  const auto hops = hops_of(run.text("pots.json"));
  ASSERT_EQ(hops.size(), 51U);
  for (std::size_t i = 0; i < hops.size(); ++i) EXPECT_EQ(hops[i]["timeStamp"], i + 1);
  for (const auto& potential : hops[0]["src"]) {
    EXPECT_EQ(potential["E"], 0.0);
    EXPECT_EQ(potential["z"], 1.0);
  }
  EXPECT_GT(hops[30]["src"][0]["E"], 0.1);
  EXPECT_EQ(hops_of(run.text("tracks.json")).size(), 51U);
  EXPECT_EQ(run.text("separated.raw").size(), 51U * 128 * 4 * 2) << "four slots of 16 bits";
}

TEST(Odaslive, writes_the_same_bytes_with_threads_and_without) {
  SmallRun run;
  run.record_raw(SmallRun::sound(32000));
  ASSERT_EQ(run.odaslive().exit_code, 0);
  const std::vector<std::string> files{"pots.json", "tracks.json", "separated.raw"};
  std::vector<std::string> threaded;
  for (const std::string& file : files) threaded.push_back(run.text(file));
  EXPECT_TRUE(has(threaded[1], "\"tag\": \"dynamic\"")) << "or nothing much is compared";
  ASSERT_EQ(run.odaslive({"-s"}).exit_code, 0);
  for (std::size_t i = 0; i < files.size(); ++i) EXPECT_EQ(run.text(files[i]), threaded[i]) << files[i];
}

// ODAS wraps what is too loud (its fault B6): the worst of clicks.
TEST(Odaslive, holds_what_is_too_loud_at_full_scale_and_wraps_no_sample) {
  SmallRun run;
  run.record_raw(SmallRun::sound(16000));
  const auto samples_at = [&](const std::string& gain) {
    run.separated = R"(interface: { type = "file"; path = "separated.raw"; }; }; gain_sep = )" + gain +
                    R"(; postfiltered: { interface: { type = "blackhole"; };)";
    EXPECT_EQ(run.odaslive().exit_code, 0);
    const std::string bytes = run.text("separated.raw");
    std::vector<std::int16_t> samples(bytes.size() / 2);
    std::memcpy(samples.data(), bytes.data(), bytes.size());
    return samples;
  };
  const auto soft = samples_at("0.1");
  const auto loud = samples_at("10.0");
  ASSERT_EQ(soft.size(), loud.size());
  std::size_t held = 0;
  for (std::size_t n = 0; n < soft.size(); ++n) {
    const double meant = 100.0 * soft[n];
    ASSERT_NEAR(loud[n], std::clamp(meant, -32768.0, 32767.0), 51) << n;
    held += std::abs(meant) > 33000 ? 1U : 0U;
  }
  EXPECT_GT(held, 1000U) << "or nothing was too loud";
}

TEST(Odaslive, writes_the_potentials_that_odas_wrote) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "the shared test material is not there";
  const SmallRun place;
  const auto scene = *shared / "scenes" / "rsp4_static1";
  SndfileHandle recording((scene / "mics.wav").string());
  std::vector<short> samples(static_cast<std::size_t>(recording.frames() * recording.channels()));
  recording.readf(samples.data(), recording.frames());
  test::write_file(place.file("mics.raw"),
                   {reinterpret_cast<const char*>(samples.data()), samples.size() * sizeof(short)});
  test::ProgramOptions options;
  options.working_directory = place.file("");
  const auto result =
      test::run_program({test::program_path("odaslive"), "-c", (scene / "odas/odas.cfg").string()}, options);
  ASSERT_EQ(result.exit_code, 0) << result.err;

  const auto golden = test::read_goldens(scene / "odas/pots.json.gz");
  const auto ours = hops_of(place.text("pots.json"));
  ASSERT_EQ(ours.size(), golden.size());
  std::size_t equal = 0;
  std::size_t all = 0;
  for (std::size_t h = 0; h < ours.size(); ++h) {
    ASSERT_EQ(ours[h]["timeStamp"], golden[h].time);
    ASSERT_EQ(ours[h]["src"].size(), golden[h].rows.size());
    for (std::size_t i = 0; i < golden[h].rows.size(); ++i) {
      const auto& row = golden[h].rows[i];
      const auto is = [&](const char* key, float value) {
        return test::thousandths(ours[h]["src"][i][key].get<float>()) == test::thousandths(value);
      };
      equal += is("x", row.x) && is("y", row.y) && is("z", row.z) && is("E", row.value) ? 1U : 0U;
      ++all;
    }
  }
  EXPECT_GE(static_cast<double>(equal), 0.99 * static_cast<double>(all));
}

TEST(Odaslive, keeps_stdout_for_the_terminal_sink) {
  SmallRun run;
  run.record_raw(SmallRun::sound(128 * 20));
  run.tracked = R"(format = "json"; interface: { type = "terminal"; };)";
  const auto result = run.odaslive({"-v"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(hops_of(result.out).size(), 21U);
  EXPECT_TRUE(has(result.err, "21 hops")) << result.err;
}

TEST(Odaslive, helps_and_complains_as_odas_does) {
  const auto help = test::run_program({test::program_path("odaslive"), "-h"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_TRUE(has(help.out, "-c FILE"));
  const auto missing = test::run_program({test::program_path("odaslive")});
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_EQ(missing.err, "Missing configuration file.\n");
  EXPECT_EQ(missing.out, "");
  const auto no_file = test::run_program({test::program_path("odaslive"), "-c", "no/such.cfg"});
  EXPECT_EQ(no_file.exit_code, 1) << "ODAS's code, where odas live has 2";
  EXPECT_TRUE(has(no_file.err, "no/such.cfg"));
}

TEST(Odaslive, only_reports_an_option_that_it_does_not_know) {
  SmallRun run;
  run.record_raw(SmallRun::sound(1280));
  const auto result = run.odaslive({"-x"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(has(result.err, "invalid option -- 'x'")) << result.err;
}

TEST(Odaslive, reads_a_wav_by_its_header_where_odas_took_it_for_sound) {
  SmallRun run;
  const Grid<float> sound = SmallRun::sound(12800);
  run.record_raw(sound);
  ASSERT_EQ(run.odaslive().exit_code, 0);
  const std::string from_raw = run.text("pots.json");
  run.record_wav(sound);
  run.source = R"(type = "file"; path = "mics.wav";)";
  ASSERT_EQ(run.odaslive().exit_code, 0);
  EXPECT_EQ(run.text("pots.json"), from_raw);
}

TEST(Odaslive, reads_pcm_of_all_sizes) {
  for (const auto& [bits, format] : {std::pair(8, SF_FORMAT_PCM_S8), std::pair(16, SF_FORMAT_PCM_16),
                                     std::pair(24, SF_FORMAT_PCM_24), std::pair(32, SF_FORMAT_PCM_32)}) {
    SmallRun run;
    run.bits = bits;
    run.record("mics.raw", SmallRun::sound(16000), SF_FORMAT_RAW | format | SF_ENDIAN_LITTLE);
    const auto result = run.odaslive();
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto hops = hops_of(run.text("pots.json"));
    EXPECT_EQ(hops.size(), 126U);
    EXPECT_GT(hops[100]["src"][0]["E"], 0.1) << bits << " bits";
  }
}

TEST(Odaslive, ends_well_at_ctrl_c_while_its_source_is_silent) {
  for (const char* mode : {"-v", "-s"}) {  // with threads, and without
    SmallRun run;
    const auto pipe = run.file("pipe");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const FileDescriptor writer(::open(pipe.c_str(), O_RDWR | O_CLOEXEC));
    run.record_raw(SmallRun::sound(2560));
    const std::string sound = run.text("mics.raw");
    ASSERT_EQ(::write(writer.get(), sound.data(), sound.size()), static_cast<ssize_t>(sound.size()));
    run.source = R"(type = "file"; path = "pipe";)";
    run.separated = R"(interface: { type = "file"; path = "separated.wav"; };)";
    test::ProgramOptions options;
    options.interrupt_when = [&] {
      std::error_code ignored;
      return std::filesystem::file_size(run.file("tracks.json"), ignored) > 1000 && !ignored;
    };
    const auto result = run.odaslive({mode}, options);
    EXPECT_EQ(result.exit_code, 0) << mode << result.err;
    EXPECT_EQ(hops_of(run.text("tracks.json")).size(), 21U) << mode;
    const SndfileHandle wav(run.file("separated.wav").string());
    EXPECT_EQ(wav.frames(), 21 * 128) << mode;
    EXPECT_EQ(wav.channels(), 4);
  }
}

TEST(Odaslive, says_which_port_it_cannot_have_before_anything_is_written) {
  SmallRun run;
  run.record_raw(SmallRun::sound(1280));
  const TcpListener other("", 0);
  run.potential = R"(format = "json"; interface: { type = "socket_listen"; port = )" +
                  std::to_string(other.port()) + "; };";
  const auto result = run.odaslive();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(has(result.err, "another program listens there")) << result.err;
  EXPECT_FALSE(std::filesystem::exists(run.file("tracks.json")));
}

TEST(Odaslive, goes_on_without_a_peer_and_says_what_was_lost) {
  SmallRun run;
  run.record_raw(SmallRun::sound(1280));
  int port = 0;
  { port = TcpListener("", 0).port(); }
  run.tracked = R"(format = "json"; interface: { type = "socket"; ip = "127.0.0.1"; port = )" +
                std::to_string(port) + "; };";
  const auto result = run.odaslive({"-v"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(has(result.err, "sst.tracked: nobody answers at 127.0.0.1:")) << result.err;
  EXPECT_TRUE(has(result.err, "11 hops (of audio: blocks) were lost")) << result.err;
  EXPECT_TRUE(has(result.err, "11 lost by peers")) << result.err;
  EXPECT_EQ(hops_of(run.text("pots.json")).size(), 11U) << "the others notice nothing";
}

}  // namespace
}  // namespace odas::odaslive_test
