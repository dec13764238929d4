// SPDX-License-Identifier: MIT
#include "odas/studio/speech.hpp"

#include <algorithm>
#include <map>
#include <thread>

#include "support/hop_maker.hpp"
#include "support/net_peer.hpp"
#include <gtest/gtest.h>

namespace odas::speech_test {
namespace {

using test::eventually;

class SpeechTest : public testing::Test {
 protected:
  void start(const std::string& command, std::chrono::milliseconds patience = std::chrono::seconds(20)) {
    Speech::Options options;
    options.command = command;
    options.patience = patience;
    options.heard = [this](const SpokenText& text) {
      const std::scoped_lock lock(mutex);
      heard.push_back(text);
    };
    options.say = [this](const std::string&, const std::string& text) {
      const std::scoped_lock lock(mutex);
      said.push_back(text);
    };
    speech.emplace(options);
    speech->begin(hops.info());
  }
  void play(int count, const std::vector<std::uint64_t>& ids) {
    for (int i = 0; i < count; ++i) hops.play(*speech, ids);
  }
  std::vector<SpokenText> words() {
    const std::scoped_lock lock(mutex);
    return heard;
  }
  bool is_said(const std::string& part) {
    const std::scoped_lock lock(mutex);
    return std::any_of(said.begin(), said.end(),
                       [&](const std::string& text) { return text.find(part) != std::string::npos; });
  }

  std::mutex mutex;
  std::vector<SpokenText> heard;
  std::vector<std::string> said;
  test::HopMaker hops;
  std::optional<Speech> speech;  // the first to go
};

TEST_F(SpeechTest, each_voice_is_heard_by_a_program_of_its_own_to_the_sample) {
  start(R"(n=$(cksum | tr ' ' '-'); echo "{\"text\":\"$ODAS_TRACK $ODAS_SAMPLE_RATE $n\",\"final\":true}")");
  play(10, {0, 0});
  play(100, {1, 0});
  play(100, {1, 2});
  play(1, {0, 0});
  ASSERT_TRUE(eventually([&] { return words().size() == 2; }));
  std::map<std::uint64_t, SpokenText> all;
  for (const SpokenText& text : words()) all[text.track] = text;
  EXPECT_TRUE(all.at(1).text.starts_with("1 16000 ")) << all.at(1).text;
  EXPECT_TRUE(all.at(1).text.ends_with("-" + std::to_string(200 * 128 * 2))) << all.at(1).text;
  EXPECT_TRUE(all.at(2).text.ends_with("-" + std::to_string(100 * 128 * 2))) << all.at(2).text;
  EXPECT_TRUE(all.at(1).is_final);
  EXPECT_NEAR(all.at(1).from_s, 10 * 0.008 - 0.016, 1e-9);
  EXPECT_NEAR(all.at(1).to_s, 210 * 0.008 - 0.016, 1e-9);
  EXPECT_TRUE(said.empty()) << said.front();
}

TEST_F(SpeechTest, guesses_come_while_the_voice_goes_on) {
  start(R"(head -c 8000 >/dev/null; echo '{"text":"hel"}'; head -c 8000 >/dev/null;)"
        R"( echo '{"text":"hello","final":true,"from":0.1,"to":0.5}'; cat >/dev/null)");
  play(125, {1, 0});
  ASSERT_TRUE(eventually([&] { return words().size() == 2; }));
  EXPECT_FALSE(words()[0].is_final);
  EXPECT_EQ(words()[1].text, "hello");
  EXPECT_NEAR(words()[1].from_s, 0.1 - 0.016, 1e-9);
  EXPECT_NEAR(words()[1].to_s, 0.5 - 0.016, 1e-9);
}

TEST_F(SpeechTest, a_voice_shorter_than_a_word_starts_no_program) {
  const std::string mark = testing::TempDir() + "odas_speech_short_" + std::to_string(::getpid());
  start("touch " + mark);
  play(10, {1, 0});
  play(10, {0, 0});
  play(10, {0, 2});
  speech.reset();
  EXPECT_NE(::access(mark.c_str(), F_OK), 0);
}

TEST_F(SpeechTest, a_program_that_is_missing_is_said_and_not_tried_for_ever) {
  start("/nowhere/at/all");
  for (std::uint64_t id = 1; id <= 6; ++id) {
    play(60, {id, 0});
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  EXPECT_TRUE(eventually([&] { return is_said("with code 127; it is not started again"); }));
}

TEST_F(SpeechTest, a_program_that_does_not_read_or_end_is_killed_and_nobody_waits) {
  start("sleep 100", std::chrono::milliseconds(50));
  play(3000, {1, 0});
  play(1, {0, 0});
  EXPECT_TRUE(eventually([&] { return is_said("did not end after its voice"); }));
  EXPECT_TRUE(is_said("reads too slowly"));
}

TEST_F(SpeechTest, a_program_that_floods_is_killed) {
  start("yes '{\"text\":\"" + std::string(200, ' ') + "\"}'");
  play(60, {1, 0});
  EXPECT_TRUE(eventually([&] { return is_said("writes without end"); }));
  play(60, {1, 0});
}

TEST_F(SpeechTest, nonsense_is_passed_over_and_said_once) {
  start(R"(cat >/dev/null; echo nonsense; echo '{"words":1}'; echo '{"text":"ok"}'; echo '[]')");
  play(60, {1, 0});
  play(1, {0, 0});
  ASSERT_TRUE(eventually([&] { return words().size() == 1; }));
  EXPECT_EQ(words()[0].text, "ok");
  EXPECT_TRUE(eventually([&] { return is_said("no line of"); }));
  EXPECT_EQ(said.size(), 1U);
}

TEST_F(SpeechTest, without_a_command_nothing_happens) {
  start("");
  play(100, {1, 0});
  speech.reset();
  EXPECT_TRUE(said.empty());
}

}  // namespace
}  // namespace odas::speech_test
