// SPDX-License-Identifier: MIT
// Fixed directions added, moved and removed in a run that goes on: `sst.control` and `odas targets`.
#include <atomic>
#include <fstream>
#include <thread>

#include "support/program.hpp"
#include "support/small_run.hpp"
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "odas/io/tcp_listener.hpp"

namespace odas::test::targets_test {
namespace {

/// A port that nobody listens at.
int free_port() { return TcpListener("", 0).port(); }

/// `odas live` on silence that does not end before it is told to.
class EndlessRun {
 public:
  EndlessRun() {
    run_.potential = "";
    run_.source = R"(type = "file"; path = "mics.fifo";)";
    run_.tracked = R"(format = "jsonl"; interface: { type = "file"; path = "tracks.jsonl"; }; }; control: {)"
                   R"( interface: { type = "socket_listen"; token = "s3cret"; port = )" +
                   std::to_string(port_) + "; };";
    ::mkfifo(run_.file("mics.fifo").c_str(), 0600);
    live_ = std::thread(
        [this] { result_ = run_.odas_live({}, {.interrupt_when = [this] { return over_.load(); }}); });
    silence_ = std::thread([this] {
      std::ofstream fifo(run_.file("mics.fifo"), std::ios::binary);
      const std::string block(128 * SmallRun::kMics * 2, '\0');
      while (!over_ && fifo.write(block.data(), static_cast<std::streamsize>(block.size())).flush()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(8));
      }
    });
  }
  ~EndlessRun() { end(); }
  EndlessRun(const EndlessRun&) = delete;
  EndlessRun& operator=(const EndlessRun&) = delete;

  const ProgramRun& end() {
    over_ = true;
    if (silence_.joinable()) silence_.join();
    if (live_.joinable()) live_.join();
    return result_;
  }

  /// `odas targets`, as soon as the run listens.
  [[nodiscard]] ProgramRun targets(const std::vector<std::string>& options) const {
    std::vector<std::string> command{program_path("odas"), "targets", std::to_string(port_)};
    command.insert(command.end(), options.begin(), options.end());
    ProgramRun told;
    for (int i = 0; i < 200; ++i) {
      told = run_program(command);
      if (!has(told.err, "nobody takes targets")) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return told;
  }

  /// Whether the tracks of the run come to hold `piece` some time.
  [[nodiscard]] bool comes_to(const std::string& piece) const {
    for (int i = 0; i < 1000; ++i) {
      if (has(run_.text("tracks.jsonl"), piece)) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return false;
  }

 private:
  SmallRun run_;
  int port_ = free_port();
  std::atomic<bool> over_{false};
  ProgramRun result_;
  std::thread live_, silence_;
};

TEST(Targets, come_move_and_go_while_a_run_goes_on) {
  EndlessRun run;
  const std::vector<std::string> token{"--token", "s3cret"};
  const auto with = [&](std::vector<std::string> options) {
    options.insert(options.end(), token.begin(), token.end());
    return run.targets(options);
  };
  const ProgramRun added = with({"--add", "door=90,0", "--add", "fan=0,0,1"});
  EXPECT_EQ(added.exit_code, 0) << added.err;
  EXPECT_TRUE(has(added.out, R"("tag":"door")") && has(added.out, R"("tag":"fan")")) << added.out;
  EXPECT_TRUE(run.comes_to(R"("tag":"door","x":0.000,"y":1.000,"z":0.000)"));
  EXPECT_EQ(with({"--add", "door=180,0", "--remove", "fan"}).exit_code, 0);
  EXPECT_TRUE(run.comes_to(R"("tag":"door","x":-1.000)"));
  EXPECT_EQ(with({"--clear"}).out, "{\"targets\":[]}\n");
  EXPECT_TRUE(run.comes_to(R"("src":[]})"));

  const ProgramRun stranger = run.targets({"--add", "x=0,0"});
  EXPECT_EQ(stranger.exit_code, 1);
  EXPECT_TRUE(has(stranger.err, "the first line must be the token")) << stranger.err;

  const ProgramRun& ended = run.end();
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_TRUE(has(ended.err, "did not give the token first")) << ended.err;
}

TEST(Targets, the_command_says_what_is_wrong) {
  const auto run = [](std::vector<std::string> options) {
    options.insert(options.begin(), {program_path("odas"), "targets"});
    return run_program(options);
  };
  const ProgramRun nobody = run({"127.0.0.1:" + std::to_string(free_port()), "--clear"});
  EXPECT_EQ(nobody.exit_code, 1);
  EXPECT_TRUE(has(nobody.err, "nobody takes targets at 127.0.0.1:")) << nobody.err;
  for (const char* target :
       {"door", "door=", "=1,2", "door=1", "door=1,2,3,4", "door=a,b", "door=1,2x", "door=nan,0"}) {
    const ProgramRun wrong = run({"9010", "--add", target});
    EXPECT_EQ(wrong.exit_code, 2) << target;
    EXPECT_TRUE(has(wrong.err, "is not TAG=AZIMUTH,ELEVATION")) << wrong.err;
  }
  for (const char* address : {"robot", "robot:", "0", "1:99999", ":"}) {
    EXPECT_EQ(run({address, "--clear"}).exit_code, 2) << address;
  }
}

}  // namespace
}  // namespace odas::test::targets_test
