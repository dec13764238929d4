// SPDX-License-Identifier: MIT
// odasserver as a user runs it: our own programs write into it, and so do peers made of ODAS's bytes.
#include <atomic>
#include <future>
#include <map>
#include <mutex>
#include <optional>

#include "support/net_peer.hpp"
#include "support/small_run.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "odas/io/json_cutter.hpp"
#include "odas/io/stream_record.hpp"

namespace odas::test::odasserver_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// odasserver on ports that the system chooses, in a thread; ends by Ctrl-C.
class RunningServer {
 public:
  RunningServer(const fs::path& folder, std::vector<std::string> more) {
    std::vector<std::string> command{program_path("odasserver"), "-o", "received"};
    for (const char* stream : {"tracked", "potential", "category", "separated", "postfiltered"}) {
      command.insert(command.end(), {std::string("--") + stream, "0"});
    }
    command.insert(command.end(), more.begin(), more.end());
    ProgramOptions options;
    options.working_directory = folder;
    options.interrupt_when = [this] { return stop_.load(); };
    options.hear = [this](const std::string& err) {
      const std::lock_guard lock(mutex_);
      err_ = err;
    };
    run_ = std::async(std::launch::async, [command, options] { return run_program(command, options); });
  }
  ~RunningServer() { stop_ = true; }
  RunningServer(const RunningServer&) = delete;
  RunningServer& operator=(const RunningServer&) = delete;

  /// Waits until it has said so; false if it does not.
  [[nodiscard]] bool says(const std::string& what, std::size_t times = 1) {
    for (int i = 0; i < 2000; ++i) {
      if (count(what) >= times) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }
  [[nodiscard]] int port(const std::string& stream) {
    const std::string words = stream + ": listens at 127.0.0.1:";
    EXPECT_TRUE(says("postfiltered: listens at ")) << said();
    const std::string text = said();
    const std::size_t at = text.find(words);
    return at == std::string::npos ? 0 : std::stoi(text.substr(at + words.size()));
  }
  ProgramRun end() {
    stop_ = true;
    return run_.get();
  }

 private:
  [[nodiscard]] std::string said() {
    const std::lock_guard lock(mutex_);
    return err_;
  }
  [[nodiscard]] std::size_t count(const std::string& what) {
    const std::string text = said();
    std::size_t times = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++times;
    return times;
  }

  std::mutex mutex_;
  std::string err_;
  std::atomic<bool> stop_{false};
  std::future<ProgramRun> run_;
};

std::vector<StreamRecord> records_of(const std::string& stream, StreamKind kind) {
  JsonCutter cutter;
  cutter.push(stream);
  std::vector<StreamRecord> records;
  while (const auto cut = cutter.next()) {
    EXPECT_EQ(cut->fault, nullptr);
    records.push_back(read_stream_record(cut->text, kind));
    EXPECT_TRUE(records.back().is_good()) << records.back().fault;
  }
  return records;
}

std::string socket_to(int port) {
  return fmt::format("interface: {{ type = \"socket\"; ip = \"127.0.0.1\"; port = {}; }};", port);
}

ProgramRun odasserver(std::vector<std::string> words, const fs::path& folder) {
  words.insert(words.begin(), program_path("odasserver"));
  ProgramOptions options;
  options.working_directory = folder;
  options.interrupt_when = [] { return false; };
  options.seconds = 20;
  return run_program(words, options);
}

TEST(Odasserver, keeps_what_odaslive_sends_just_as_odaslive_would_write_it) {
  SmallRun small;
  small.record_raw(SmallRun::sound(16000 * 2));
  ASSERT_EQ(small.odaslive().exit_code, 0);

  RunningServer server(small.file(""), {"--rate", "16000", "--channels", "4", "--bits", "16"});
  small.potential = "format = \"json\"; " + socket_to(server.port("potential"));
  small.tracked = "format = \"json\"; " + socket_to(server.port("tracked"));
  small.separated = socket_to(server.port("separated"));
  const ProgramRun sent = small.odaslive();
  ASSERT_EQ(sent.exit_code, 0) << sent.err;
  EXPECT_TRUE(server.says(" has gone", 3));
  const ProgramRun received = server.end();
  EXPECT_EQ(received.exit_code, 0) << received.err;
  EXPECT_TRUE(has(received.err, "odasserver: what has come is in received")) << received.err;
  EXPECT_TRUE(has(received.out, "id 1, azimuth ")) << received.out;

  EXPECT_EQ(wav_samples(small.file("received/separated.wav")), small.text("separated.raw"));
  for (const auto& [lines, bytes, kind] :
       {std::tuple{"received/tracks.jsonl", "tracks.json", StreamKind::tracks},
        std::tuple{"received/potentials.jsonl", "pots.json", StreamKind::potentials}}) {
    const auto kept = records_of(small.text(lines), kind);
    const auto written = records_of(small.text(bytes), kind);
    ASSERT_EQ(kept.size(), written.size()) << lines;
    for (std::size_t hop = 0; hop < kept.size(); ++hop) {
      ASSERT_EQ(kept[hop].time, written[hop].time);
      ASSERT_EQ(kept[hop].potentials.size(), written[hop].potentials.size());
      for (std::size_t i = 0; i < kept[hop].potentials.size(); ++i) {
        ASSERT_EQ(kept[hop].potentials[i].direction, written[hop].potentials[i].direction);
        ASSERT_EQ(kept[hop].potentials[i].energy, written[hop].potentials[i].energy);
      }
      for (std::size_t slot = 0; slot < kept[hop].tracks.size(); ++slot) {
        const Track &a = kept[hop].tracks[slot], &b = written[hop].tracks[slot];
        ASSERT_EQ(a.id, b.id);
        ASSERT_EQ(a.direction, b.direction);
        ASSERT_EQ(a.activity, b.activity);
      }
    }
  }
}

TEST(Odasserver, takes_ports_and_sound_from_the_configuration_of_the_sender) {
  SmallRun small;
  small.record_raw(SmallRun::sound(3200));
  const int tracked = free_port(), separated = free_port();
  small.tracked = "format = \"jsonl\"; " + socket_to(tracked);
  small.separated = "fS = 48000; hopSize = 384; nBits = 24; " + socket_to(separated);
  write_file(small.file("sender.cfg"), small.configuration());
  ProgramOptions options;
  options.working_directory = small.file("");
  std::atomic<bool> stop = false;
  options.interrupt_when = [&] { return stop.load(); };
  std::atomic<bool> ready = false;
  options.hear = [&](const std::string& err) { ready = has(err, "separated: listens at"); };
  auto running = std::async(std::launch::async, [&] {
    return run_program({program_path("odasserver"), "-c", "sender.cfg", "-o", "received", "-q"}, options);
  });
  for (int i = 0; i < 2000 && !ready; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  const ProgramRun sent = small.odaslive();
  EXPECT_EQ(sent.exit_code, 0) << sent.err;
  stop = true;
  const ProgramRun received = running.get();
  EXPECT_EQ(received.exit_code, 0) << received.err;
  EXPECT_EQ(received.out, "");
  EXPECT_FALSE(has(received.err, "potential: listens")) << received.err;
  SndfileHandle sound(small.file("received/separated.wav").string());
  EXPECT_EQ(sound.samplerate(), 48000);
  EXPECT_EQ(sound.channels(), 4);
  EXPECT_EQ(sound.format() & SF_FORMAT_SUBMASK, SF_FORMAT_PCM_24);
  const std::string lines = small.text("received/tracks.jsonl");
  EXPECT_TRUE(lines.starts_with("{\"timeStamp\":1,\"time\":0.000000,\"utc\":\"")) << lines.substr(0, 200);
}

TEST(Odasserver, survives_reconnects_and_garbage_and_finishes_its_files) {
  const Scratch scratch;
  RunningServer server(scratch.folder(), {"--channels", "2"});
  const int tracked = server.port("tracked"), separated = server.port("separated");
  for (int i = 1; i <= 3; ++i) {
    const NetPeer sound = NetPeer::dial(separated);
    ASSERT_TRUE(sound.open());
    ASSERT_TRUE(sound.send(std::string(400, static_cast<char>('a' + i)) + "xyz"));
    NetPeer tracks = NetPeer::dial(tracked);
    ASSERT_TRUE(
        tracks.send("\xFF\x00garbage\n" +
                    fmt::format("{{\n    \"timeStamp\": {},\n    \"src\": [\n    ]\n}}\n{{\n  \"time", i)));
    EXPECT_TRUE(server.says("tracked: what came is no JSON object", static_cast<std::size_t>(i)));
    if (i == 2) tracks.reset();
    tracks.close();
    EXPECT_TRUE(server.says("tracked: the sender from", static_cast<std::size_t>(i)));
    EXPECT_TRUE(server.says("separated: a sender has come", static_cast<std::size_t>(i)));
    // The peer goes here, and the next one finds its place.
    const_cast<NetPeer&>(sound).close();
    EXPECT_TRUE(server.says("separated: the sender from", static_cast<std::size_t>(i)));
  }
  const ProgramRun received = server.end();
  EXPECT_EQ(received.exit_code, 0) << received.err;
  for (const char* name : {"separated.wav", "separated_2.wav", "separated_3.wav"}) {
    EXPECT_EQ(SndfileHandle((scratch / "received" / name).string()).frames(), 100) << name;
  }
  EXPECT_EQ(records_of(content(scratch / "received/tracks.jsonl"), StreamKind::tracks).size(), 3U);
}

TEST(Odasserver, wrong_words_are_all_said_and_end_it_with_code_2) {
  const Scratch scratch;
  const ProgramRun run = odasserver(
      {"--rate", "fast", "--bits", "12", "--listen", "0.0.0.0", "--what", "more"}, scratch.folder());
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out, "");
  for (const char* part : {"--rate is \"fast\"", "--bits is 8, 16, 24 or 32", "--allow ADDRESS",
                           "--what is not known", "more is no option"}) {
    EXPECT_TRUE(has(run.err, part)) << part << '\n' << run.err;
  }
  EXPECT_EQ(odasserver({"-c", "no.cfg"}, scratch.folder()).exit_code, 2);
}

TEST(Odasserver, a_port_in_use_and_a_folder_that_is_not_empty_end_it_with_code_1) {
  const Scratch scratch;
  const NetListener other;
  const ProgramRun taken =
      odasserver({"--tracked", std::to_string(other.port()), "-o", "new"}, scratch.folder());
  EXPECT_EQ(taken.exit_code, 1);
  EXPECT_TRUE(has(taken.err, "another program listens there")) << taken.err;
  EXPECT_FALSE(fs::exists(scratch / "new"));
  write_file(scratch / "mine", "");
  const ProgramRun full = odasserver({"-o", "."}, scratch.folder());
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_TRUE(has(full.err, "is not empty")) << full.err;
}

TEST(Odasserver, says_when_nothing_has_come_and_leaves_nothing_behind) {
  const Scratch scratch;
  RunningServer server(scratch.folder(), {});
  EXPECT_NE(server.port("tracked"), 0);
  const ProgramRun run = server.end();
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(has(run.err, "nothing has come")) << run.err;
  EXPECT_FALSE(fs::exists(scratch / "received"));
}

}  // namespace
}  // namespace odas::test::odasserver_test
