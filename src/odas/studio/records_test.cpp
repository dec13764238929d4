// SPDX-License-Identifier: MIT
#include "odas/studio/records.hpp"

#include <thread>

#include "support/hop_maker.hpp"
#include "support/kept_messages.hpp"
#include "support/net_peer.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"
#include "odas/studio/session_reader.hpp"

namespace odas::records_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class RecordsTest : public testing::Test {
 protected:
  RecordsTest() {
    RecordsOptions options;
    options.folder = scratch / "kept";
    options.free_space = [this](const fs::path&) { return free.load(); };
    // Hears half a second, and knows what it was.
    options.speech.command =
        R"(head -c 16000 >/dev/null; echo '{"text":"hello","final":true}'; cat >/dev/null)";
    options.say = [this](const std::string&, const std::string& text) { said.push_back(text); };
    records.emplace(options, messages);
    records->add_methods(rpc);
  }
  json call(const std::string& method, const json& params = json::object()) {
    return rpc.call(method, params, Role::operator_);
  }
  std::string code(const std::string& method, const json& params = json::object()) {
    try {
      call(method, params);
    } catch (const RpcError& error) { return error.code(); }
    return "";
  }
  void play(int count, const std::vector<std::uint64_t>& ids) {
    for (int i = 0; i < count; ++i) hops.play(*records, ids);
  }
  void begin() { records->begin(hops.info()); }

  test::Scratch scratch;
  test::KeptMessages messages;
  test::HopMaker hops;
  RpcRegistry rpc;
  std::atomic<std::uint64_t> free{1'000'000'000};
  std::vector<std::string> said;
  std::optional<Records> records;
};

TEST_F(RecordsTest, record_a_voice_by_command) {
  begin();
  play(100, {1, 2});
  const json started = call("record.start", {{"what", "track"}, {"track", 2}, {"stream", "separated"}});
  EXPECT_TRUE(started["name"].get<std::string>().ends_with("_source_2.wav"));
  const json active = messages.of("recordings").back()["active"];
  ASSERT_EQ(active.size(), 1U);
  EXPECT_EQ(active[0]["id"], started["id"]);
  EXPECT_EQ(active[0]["track"], 2);
  EXPECT_EQ(active[0]["name"], started["name"]);
  EXPECT_EQ(messages.of("recordings").back()["disk_free"], 1'000'000'000);
  play(25, {1, 2});
  EXPECT_EQ(call("record.stop", {{"id", started["id"]}})["names"], json::array({started["name"]}));
  EXPECT_TRUE(messages.of("recordings").back()["active"].empty());
  const json list = call("recordings.list");
  ASSERT_EQ(list.size(), 1U);
  EXPECT_NEAR(list[0]["seconds"].get<double>(), 0.8 + 0.2, 1e-6) << "with all of the look-back there is";
}

TEST_F(RecordsTest, say_what_is_wrong_with_a_command) {
  EXPECT_EQ(code("record.start", {{"what", "raw"}}), "conflict") << "nothing runs";
  begin();
  play(1, {1, 0});
  EXPECT_EQ(code("record.start"), "bad_request");
  EXPECT_EQ(code("record.start", {{"what", "world"}}), "bad_request");
  EXPECT_EQ(code("record.start", {{"what", "track"}}), "bad_request");
  EXPECT_EQ(code("record.start", {{"what", "track"}, {"track", 9}}), "failed");
  EXPECT_EQ(code("record.start", {{"what", "all"}, {"stream", "raw"}}), "bad_request");
  EXPECT_EQ(code("record.stop", {{"id", 99}}), "not_found");
  EXPECT_EQ(code("recordings.peaks", {{"name", "../x.wav"}}), "not_found");
  EXPECT_EQ(code("recordings.rename", {{"name", "x.wav"}, {"label", std::string(1000, 'x')}}), "bad_request");
  EXPECT_EQ(code("record.stop", {{"all", true}}), "");
}

TEST_F(RecordsTest, keep_what_is_being_recorded_from_being_deleted) {
  begin();
  play(1, {1, 0});
  const json voice = call("record.start", {{"what", "track"}, {"track", 1}});
  const json session = call("record.start", {{"what", "session"}});
  EXPECT_EQ(code("recordings.delete", {{"names", {voice["name"]}}}), "conflict");
  EXPECT_EQ(code("sessions.delete", {{"names", {session["name"]}}}), "conflict");
  EXPECT_EQ(code("record.start", {{"what", "session"}}), "conflict") << "one at a time";
  call("recordings.rename", {{"name", voice["name"]}, {"label", "me"}});
  EXPECT_EQ(call("sessions.list"), json::array());
  play(5, {1, 0});
  EXPECT_EQ(call("record.stop", {{"all", true}})["names"].size(), 2U);
  EXPECT_EQ(call("recordings.list")[0]["label"], "me");
  EXPECT_EQ(call("recordings.delete", {{"names", {voice["name"]}}})["deleted"].size(), 1U);
  EXPECT_EQ(call("sessions.delete", {{"names", {session["name"]}}})["deleted"].size(), 1U);
  EXPECT_TRUE(fs::is_empty(scratch / "kept"));
}

TEST_F(RecordsTest, stop_before_the_disk_is_full_and_say_so) {
  begin();
  play(1, {1, 0});
  free = 50'000'000;
  EXPECT_EQ(code("record.start", {{"what", "raw"}}), "failed");
  free = 1'000'000'000;
  call("record.start", {{"what", "raw"}});
  call("record.start", {{"what", "session"}});
  free = 99'000'000;
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // it is looked at each second
  play(2, {1, 0});
  const json told = messages.of("recordings").back();
  EXPECT_TRUE(told["active"].empty());
  EXPECT_TRUE(told["fault"].get<std::string>().starts_with("recording has stopped: only 99 MB are free"));
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(call("recordings.list").size(), 1U) << "what was recorded is kept";
  EXPECT_EQ(call("sessions.list").at(0)["fault"], "");
}

TEST_F(RecordsTest, of_a_folder_that_cannot_be_used_say_so) {
  test::write_file(scratch / "kept", "a file");
  begin();
  play(1, {1, 0});
  EXPECT_EQ(code("record.start", {{"what", "raw"}}), "failed");
  play(1, {1, 0});
}

TEST_F(RecordsTest, keep_in_a_session_what_is_announced_through_them) {
  begin();
  play(1, {1, 0});
  records->announce("events", {{"type", "event"}, {"event", "before"}});
  const json session = call("record.start", {{"what", "session"}, {"audio", json::array({"raw"})}});
  records->announce("events", {{"type", "event"}, {"event", "appear"}});
  records->announce("log", {{"type", "log"}, {"lines", json::array()}});
  records->announce("meters", {{"type", "meters"}});
  play(10, {1, 0});
  call("record.stop", {{"id", session["id"]}});
  EXPECT_EQ(messages.of("events").size(), 3U) << "and everybody is told; somebody has appeared, too";
  std::vector<std::string> topics;
  SessionReader::Visitor visitor;
  visitor.text = [&](const std::string& topic, const json&) { topics.push_back(topic); };
  EXPECT_EQ(SessionReader(scratch / "kept" / session["name"].get<std::string>()).read(visitor), "");
  EXPECT_EQ(topics, (std::vector<std::string>{"event", "log"}));
  EXPECT_EQ(call("sessions.list")[0]["audio"], json::array({"raw"}));
}

TEST_F(RecordsTest, tell_of_sources_and_of_what_they_say_and_keep_it_beside_the_recording) {
  begin();
  play(1, {0, 0});
  call("record.start", {{"what", "all"}});
  play(100, {7, 0});
  ASSERT_TRUE(test::eventually([&] { return !messages.of("transcripts").empty(); }));
  play(1, {0, 0});
  const json words = messages.of("transcripts")[0];
  EXPECT_EQ(words["type"], "transcript");
  EXPECT_EQ(words["track"], 7);
  EXPECT_EQ(words["text"], "hello");
  EXPECT_EQ(words["final"], true);
  ASSERT_TRUE(test::eventually([&] { return call("recordings.list")[0]["transcript"] == "hello"; }));
  ASSERT_EQ(messages.of("events").size(), 2U);
  EXPECT_EQ(messages.of("events")[0]["event"], "appear");
  EXPECT_EQ(messages.of("events")[1]["event"], "disappear");
}

TEST_F(RecordsTest, refuse_an_address_for_events_that_is_none) {
  RecordsOptions options;
  options.events.url = "nonsense";
  EXPECT_THROW(Records(options, messages), ConfigError);
}

TEST_F(RecordsTest, go_on_when_the_pipeline_is_replaced_and_end_with_the_run) {
  begin();
  play(10, {1, 0});
  call("record.start", {{"what", "all"}});
  call("record.start", {{"what", "session"}});
  hops.time = 0;
  begin();
  play(10, {1, 0});
  EXPECT_EQ(messages.of("recordings").back()["active"].size(), 2U);
  records->end();
  EXPECT_TRUE(messages.of("recordings").back()["active"].empty());
  EXPECT_EQ(call("recordings.list").size(), 2U);
  EXPECT_EQ(call("sessions.list")[0]["fault"], "");
}

TEST_F(RecordsTest, are_used_by_several_threads_at_once) {
  begin();
  play(1, {1, 2});
  std::thread others([&] {
    for (int i = 0; i < 30; ++i) {
      const json id = call("record.start", {{"what", i % 3 == 0 ? "session" : i % 3 == 1 ? "raw" : "all"}});
      records->announce("log", {{"type", "log"}});
      call("recordings.list");
      call("record.stop", {{"id", id["id"]}});
    }
  });
  for (int i = 0; i < 300; ++i) {
    play(1, {1, i % 50 < 25 ? 2U : 0U});
    if (i % 10 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  others.join();
  EXPECT_TRUE(said.empty()) << said.front();
}

/// Keeps a message only after another one, or after a while, once it is asked to.
class LateMessages : public test::KeptMessages {
 public:
  void announce(const std::string& topic, const json& message) override {
    if (late.exchange(false)) {
      const std::size_t before = of(topic).size();
      waits = true;
      for (int i = 0; i < 100 && of(topic).size() == before; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
      }
    }
    KeptMessages::announce(topic, message);
  }
  std::atomic<bool> late{false}, waits{false};
};

TEST(RecordsOfTwoThreads, tell_last_how_it_is) {
  const test::Scratch scratch;
  LateMessages messages;
  RecordsOptions options;
  options.folder = scratch.folder();
  Records records(options, messages);
  RpcRegistry rpc;
  records.add_methods(rpc);
  test::HopMaker hops;
  records.begin(hops.info());
  hops.play(records, {1, 0});
  messages.late = true;
  std::thread starts([&] {
    static_cast<void>(rpc.call("record.start", {{"what", "raw"}}, Role::operator_));
  });
  while (!messages.waits) std::this_thread::yield();
  static_cast<void>(rpc.call("record.stop", {{"all", true}}, Role::operator_));
  starts.join();
  EXPECT_TRUE(messages.of("recordings").back()["active"].empty());
}

}  // namespace
}  // namespace odas::records_test
