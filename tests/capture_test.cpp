// SPDX-License-Identifier: MIT
// The microphones of virtual devices, all the way through `odas live`, and back out of raw.record: what was
// played must be what was heard, sample by sample.
#include <cstdlib>

#include "support/program.hpp"
#include "support/virtual_devices.hpp"
#include <gtest/gtest.h>

namespace odas::test::capture_test {
namespace {

std::size_t seconds() { return std::getenv("ODAS_SOAK") != nullptr ? 60 : 5; }

std::string configuration(const std::string& interface) {
  return "raw: { fS = 16000; hopSize = 128; nBits = 16; nChannels = 8; interface: { " + interface +
         " };\n  record: { interface: { type = \"file\"; path = \"heard.raw\"; }; }; };\n"
         "mapping: { map = (1, 2, 8); };\n"
         "general: { mics = ( { mu = (0.0, 0.0, 0.0); }, { mu = (0.05, 0.0, 0.0); }, { mu = (0.0, 0.05, "
         "0.0); } ); };\n"
         "ssl: { scans = ( { level = 1; delta = 1; } ); };\n"
         "sst: { tracked: { format = \"jsonl\"; interface: { type = \"file\"; path = \"tracks.jsonl\"; }; }; "
         "};\n";
}

/// `odas live -v` until `over`.
ProgramRun listen(const Scratch& scratch, const std::string& interface, std::vector<std::string> environment,
                  std::function<bool()> over, const std::string& program = "odas") {
  write_file(scratch / "run.cfg", configuration(interface));
  std::vector<std::string> command{program_path(program), "-c", "run.cfg", "-v"};
  if (program == "odas") command.insert(command.begin() + 1, "live");
  return run_program(command, {.working_directory = scratch.folder(),
                               .interrupt_when = std::move(over),
                               .environment = std::move(environment),
                               .seconds = static_cast<int>(seconds()) + 60});
}

bool left_out(const ProgramRun& run) {
  return run.err.find("was left out when this program was built") != std::string::npos;
}

void expect_nothing_lost(const ProgramRun& run) {
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("0 hops dropped, 0 lost by peers; 0 blocks and 0 frames of the source lost"),
            std::string::npos)
      << run.err;
  EXPECT_EQ(run.err.find("overrun"), std::string::npos) << run.err;
}

void expect_heard(const Scratch& scratch, const std::string& played, bool from_the_start) {
  const std::string heard = content(scratch / "heard.raw");
  const std::size_t at = from_the_start ? 0 : heard.find(played.substr(0, 4096));
  ASSERT_NE(at, std::string::npos) << "nothing of it was heard";
  EXPECT_EQ(at % kVirtualFrame, 0U);
  ASSERT_GE(heard.size(), at + played.size());
  EXPECT_TRUE(heard.compare(at, played.size(), played) == 0) << "it is not what was played";
}

TEST(Capture, of_a_card_of_ALSA_is_exact) {
  if (!VirtualCard::possible()) GTEST_SKIP() << "no configuration of ALSA (libasound2-data) here";
  for (const char* program : {"odas", "odaslive"}) {
    const Scratch scratch;
    const std::string played = noise_bytes(seconds() * kVirtualRate);
    VirtualCard card(scratch);
    card.play(played);
    const ProgramRun run = listen(
        scratch, R"(type = "soundcard_name"; devicename = "array8";)", {card.environment()},
        [&] { return card.played(); }, program);
    if (left_out(run)) GTEST_SKIP() << run.err;
    expect_nothing_lost(run);
    expect_heard(scratch, played, true);
    const std::string stamp = "\"timeStamp\":" + std::to_string(seconds() * 125) + ",";
    EXPECT_NE(content(scratch / "tracks.jsonl").find(stamp), std::string::npos) << "time has slipped";
  }
}

TEST(Capture, of_a_source_of_PulseAudio_is_exact) {
  if (!VirtualPulse::possible()) GTEST_SKIP() << "no pulseaudio and pacat here";
  const Scratch scratch;
  VirtualPulse pulse(scratch);
  pulse.start();
  for (int i = 0; i < 100 && !pulse.ready(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  if (!pulse.ready()) GTEST_SKIP() << "pulseaudio does not run here: " << content(scratch / "pulse/log");
  for (const char* interface : {R"(type = "pulseaudio"; source = "mic8.monitor";)",
                                R"(type = "pulseaudio"; source = "mic8.monitor"; channelmap = ("aux0", "aux1",
                                   "aux2", "aux3", "aux4", "aux5", "aux6", "aux7");)"}) {
    const std::string played = noise_bytes(seconds() * kVirtualRate, 2);
    write_file(scratch / "played.raw", played);
    std::atomic<bool> over{false};
    std::filesystem::remove(scratch / "tracks.jsonl");
    std::thread player([&] {
      // Once it listens, there is a first line.
      for (int i = 0; i < 1000 && content(scratch / "tracks.jsonl").empty(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
      EXPECT_EQ(pulse.play(scratch / "played.raw"), 0);
      std::this_thread::sleep_for(std::chrono::milliseconds(500));
      over = true;
    });
    const ProgramRun run = listen(scratch, interface, pulse.environment(), [&] { return over.load(); });
    player.join();
    if (left_out(run)) GTEST_SKIP() << run.err;
    expect_nothing_lost(run);
    expect_heard(scratch, played, false);
  }
}

TEST(Capture, waits_for_a_server_of_PulseAudio_that_has_ended) {
  if (!VirtualPulse::possible()) GTEST_SKIP() << "no pulseaudio and pacat here";
  const Scratch scratch;
  VirtualPulse pulse(scratch);
  const auto wait = [&] {
    for (int i = 0; i < 100 && !pulse.ready(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return pulse.ready();
  };
  pulse.start();
  if (!wait()) GTEST_SKIP() << "pulseaudio does not run here: " << content(scratch / "pulse/log");
  std::atomic<bool> over{false};
  std::thread trouble([&] {
    const auto grows_beyond = [&](std::uintmax_t size) {
      std::error_code ignored;
      for (int i = 0; i < 2000; ++i) {
        const auto now = std::filesystem::file_size(scratch / "tracks.jsonl", ignored);
        if (!ignored && now > size) return now;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
      ADD_FAILURE() << "no more hops";
      return size;
    };
    grows_beyond(1000);
    pulse.end();
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    pulse.start();
    EXPECT_TRUE(wait());
    grows_beyond(grows_beyond(0) + 20000);
    over = true;
  });
  const ProgramRun run = listen(scratch, R"(type = "pulseaudio"; source = "mic8.monitor";)",
                                pulse.environment(), [&] { return over.load(); });
  trouble.join();
  if (left_out(run)) GTEST_SKIP() << run.err;
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("waiting until it is back"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("mic8.monitor is back"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("frames of the source were lost; the time stamps count them"), std::string::npos);
}

TEST(Devices, are_listed_with_a_section_that_runs) {
  if (!VirtualCard::possible()) GTEST_SKIP() << "no configuration of ALSA (libasound2-data) here";
  const Scratch scratch;
  VirtualCard card(scratch);
  card.play("");
  const ProgramOptions options{.environment = {card.environment(), "PULSE_SERVER=unix:/no/such/socket"}};
  const ProgramRun all = run_program({program_path("odas"), "devices"}, options);
  EXPECT_EQ(all.exit_code, 0) << all.err;
  EXPECT_NE(all.out.find("array8"), std::string::npos) << all.out;
  EXPECT_NE(all.out.find("A virtual array"), std::string::npos) << all.out;
  EXPECT_NE(all.out.find("devicename = \"array8\""), std::string::npos) << all.out;
  const ProgramRun one = run_program({program_path("odas"), "devices", "array8", "--json"}, options);
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_NE(one.out.find("\"S16_LE\""), std::string::npos) << one.out;
  const ProgramRun none = run_program({program_path("odas"), "devices", "hw:CARD=NoSuchCard"}, options);
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_NE(none.err.find("hw:CARD=NoSuchCard"), std::string::npos) << none.err;
}

}  // namespace
}  // namespace odas::test::capture_test
