// SPDX-License-Identifier: MIT
#include "odas/studio/speech_program.hpp"

#include <csignal>

#include "support/net_peer.hpp"
#include <gtest/gtest.h>

namespace odas::speech_program_test {
namespace {

using test::eventually;

class SpeechProgramTest : public testing::Test {
 protected:
  SpeechProgramTest() { std::signal(SIGPIPE, SIG_IGN); }
  static std::string read_all(SpeechProgram& program) {
    std::string all;
    EXPECT_TRUE(eventually([&] {
      all += program.read(4096);
      return program.ended();
    }));
    return all;
  }
};

TEST_F(SpeechProgramTest, gets_what_is_written_and_its_environment) {
  SpeechProgram program("echo $ODAS_TRACK; cat; exit 3", {"ODAS_TRACK=12"});
  EXPECT_EQ(program.write("sound"), 5U);
  program.close_input();
  EXPECT_EQ(read_all(program), "12\nsound");
  EXPECT_TRUE(eventually([&] { return program.exit_code() == 3; }));
}

TEST_F(SpeechProgramTest, that_does_not_read_holds_nobody_up) {
  SpeechProgram program("sleep 100", {});
  const std::string much(std::size_t{1} << 20, 'x');
  std::size_t taken = 0;
  for (int i = 0; i < 100; ++i) taken += program.write(much);
  EXPECT_LT(taken, much.size());
  EXPECT_EQ(program.read(10), "");
  EXPECT_FALSE(program.exit_code().has_value());
  program.kill();
  EXPECT_TRUE(eventually([&] { return program.exit_code() == 128 + SIGKILL; }));
}

TEST_F(SpeechProgramTest, that_has_gone_takes_everything) {
  SpeechProgram program("exit 0", {});
  ASSERT_TRUE(eventually([&] { return program.exit_code() == 0; }));
  EXPECT_TRUE(eventually([&] { return program.write("sound") == 5 && program.input() < 0; }));
}

TEST_F(SpeechProgramTest, that_is_missing_ends_with_127) {
  SpeechProgram program("/nowhere/at/all", {});
  EXPECT_TRUE(eventually([&] { return program.exit_code() == 127; }));
}

TEST_F(SpeechProgramTest, is_killed_with_all_that_it_has_started) {
  std::string pid;
  {
    SpeechProgram program("sleep 100 & echo $!; wait", {});
    ASSERT_TRUE(eventually([&] {
      pid += program.read(100);
      return pid.ends_with("\n");
    }));
    EXPECT_EQ(::kill(std::stoi(pid), 0), 0);
  }
  // Its parent is gone: it may be a zombie for a while where nobody reaps.
  EXPECT_TRUE(eventually([&] {
    if (::kill(std::stoi(pid), 0) != 0) return true;
    std::FILE* file = std::fopen(("/proc/" + std::to_string(std::stoi(pid)) + "/stat").c_str(), "r");
    if (file == nullptr) return true;
    char state = 0;
    const int got = std::fscanf(file, "%*d %*s %c", &state);
    std::fclose(file);
    return got == 1 && state == 'Z';
  }));
}

}  // namespace
}  // namespace odas::speech_program_test
