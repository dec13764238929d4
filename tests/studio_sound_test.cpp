// SPDX-License-Identifier: MIT
// Voices by the Studio's protocol: the same samples as the engine's own files, and each under its own id,
// whoever comes, goes and comes again.
#include <cstring>
#include <map>
#include <set>

#include "support/hop_maker.hpp"
#include "support/small_run.hpp"
#include "support/studio_daemon.hpp"
#include "support/web_client.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "odas/studio/server.hpp"

namespace odas::test::studio_sound_test {
namespace {

using nlohmann::json;

/// A binary message of sound.
struct Packet {
  explicit Packet(const std::string& bytes) : samples((bytes.size() - 24) / 2) {
    std::memcpy(&track, &bytes[4], 4);
    std::memcpy(&index, &bytes[8], 8);
    std::memcpy(&flags, &bytes[22], 2);
    std::memcpy(samples.data(), &bytes[24], 2 * samples.size());
  }
  std::uint32_t track = 0;
  std::uint64_t index = 0;
  std::uint16_t flags = 0;
  std::vector<std::int16_t> samples;
};

std::string wish(const std::vector<std::uint64_t>& tracks) {
  json message = {{"type", "subscribe"}, {"topics", {{"hops", 60}}}, {"audio", json::array()}};
  for (const std::uint64_t track : tracks) {
    message["audio"].push_back({{"stream", "separated"}, {"track", track}});
  }
  return message.dump();
}

int seconds_of_test() { return std::getenv("ODAS_SOAK") != nullptr ? 60 : 10; }

TEST(StudioSound, is_that_of_the_engines_own_file_sample_by_sample) {
  SmallRun run;
  const auto frames = static_cast<std::size_t>(16000 * (seconds_of_test() + 2));
  run.record_raw(SmallRun::sound(frames));
  run.source = R"(type = "file"; path = "mics.raw"; paced = true;)";
  run.separated = R"(interface: { type = "file"; path = "separated.wav"; };)";
  write_file(run.file("run.cfg"), run.configuration());
  ProgramOptions options;
  options.working_directory = run.file("");
  StudioDaemon daemon({"live", "run.cfg", "--studio", "127.0.0.1:0"}, options);
  ASSERT_NE(daemon.port(), 0) << daemon.said();

  WebClient client(daemon.port());
  client.send(wish({}));
  std::map<std::uint64_t, std::size_t> slots;          // by id
  std::map<std::uint64_t, std::vector<Packet>> heard;  // by id
  while (const auto message = client.next()) {
    if (message->opcode == 8) break;
    if (message->opcode == 2) {
      Packet packet(message->payload);
      heard[packet.track].push_back(std::move(packet));
      continue;
    }
    const json text = json::parse(message->payload);
    EXPECT_NE(text.at("type"), "gap");
    if (text.at("type") != "hops") continue;
    const std::size_t known = slots.size();
    for (const json& hop : text.at("hops")) {
      for (const json& track : hop.at("tracks")) slots.emplace(track.at(1), track.at(0));
    }
    if (slots.size() == known) continue;
    std::vector<std::uint64_t> all;
    for (const auto& [id, slot] : slots) all.push_back(id);
    client.send(wish(all));
  }
  EXPECT_EQ(daemon.wait().exit_code, 0) << daemon.said();

  SndfileHandle file(run.file("separated.wav").string());
  std::vector<std::int16_t> engine(static_cast<std::size_t>(file.frames() * file.channels()));
  file.readf(engine.data(), file.frames());
  const auto channels = static_cast<std::size_t>(file.channels());
  std::size_t longest = 0, different = 0, holes = 0;
  for (const auto& [id, packets] : heard) {
    std::size_t count = 0;
    for (const Packet& packet : packets) {
      holes += packet.flags & 1U;
      count += packet.samples.size();
      for (std::size_t i = 0; i < packet.samples.size(); ++i) {
        const std::size_t at = (packet.index + i) * channels + slots.at(id);
        different += at >= engine.size() || packet.samples[i] != engine[at] ? 1U : 0U;
      }
    }
    longest = std::max(longest, count);
  }
  EXPECT_EQ(different, 0U);
  EXPECT_EQ(holes, 0U) << "places where samples are missing";
  EXPECT_GT(longest, static_cast<std::size_t>(16000 * (seconds_of_test() - 2)));
  fmt::print("longest voice: {:.1f} s, {} samples differ from the engine's file, {} holes\n",
             static_cast<double>(longest) / 16000, different, holes);
}

/// Who is in which slot at a hop: each slot has a life of its own, with births and deaths, and ids that are
/// never used again; some change from one hop to the next.
std::vector<std::uint64_t> cast_of(HopIndex time) {
  std::vector<std::uint64_t> ids(8);
  for (std::uint64_t slot = 0; slot < 8; ++slot) {
    const HopIndex life = 20 + 7 * slot, born = time / life;
    const bool silent = slot % 2 == 1 && time % life < 5;  // even slots have no pause between two voices
    ids[slot] = silent ? 0 : 1 + slot + 8 * born;
  }
  return ids;
}

TEST(StudioSound, is_never_under_the_id_of_another) {
  RpcRegistry rpc;
  StudioConfig config;
  config.port = 0;
  StudioServer server(config, rpc, {}, {});
  HopMaker maker(8, 1);
  StreamInfo info = maker.info();
  server.begin(info);
  std::atomic<bool> over{false};
  std::atomic<HopIndex> now{0};
  std::thread engine([&] {
    while (!over) {
      maker.play(server, cast_of(maker.time + 1));
      now = maker.time;
      std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
  });
  // Each comes late, asks for all that live and a few that have died or are to come, hears a little, goes.
  constexpr int kComings = 1000;
  std::size_t packets = 0, samples = 0, wrong = 0, silent = 0;
  std::set<std::uint64_t> voices;
  for (int coming = 0; coming < kComings; ++coming) {
    WebClient client(server.port());
    std::vector<std::uint64_t> wanted;
    for (const HopIndex t : {now.load(), now.load() + 8}) {
      for (const std::uint64_t id : cast_of(t + 1)) {
        if (id != 0 && std::find(wanted.begin(), wanted.end(), id) == wanted.end()) wanted.push_back(id);
      }
    }
    client.send(wish(wanted));
    std::size_t heard = 0;
    while (heard < 3) {
      const auto message = client.next(2000);
      if (!message) break;
      if (message->opcode != 2) continue;
      const Packet packet(message->payload);
      ++heard;
      voices.insert(packet.track);
      const bool asked = std::find(wanted.begin(), wanted.end(), packet.track) != wanted.end();
      wrong += asked ? 0 : packet.samples.size();
      for (std::size_t i = 0; i < packet.samples.size(); ++i) {
        const int difference = packet.samples[i] - tone_sample(packet.track, packet.index + i);
        wrong += std::abs(difference) > 1 ? 1U : 0U;
      }
      samples += packet.samples.size();
    }
    packets += heard;
    silent += heard == 0 ? 1U : 0U;
    if (coming % 3 == 0) client.peer().reset();
  }
  over = true;
  engine.join();
  EXPECT_EQ(wrong, 0U) << "samples of another voice";
  EXPECT_EQ(silent, 0U) << "clients who heard nobody";
  EXPECT_GT(voices.size(), 100U);
  fmt::print("{} clients, {} packets, {} samples of {} voices, {} of another voice\n", kComings, packets,
             samples, voices.size(), wrong);
}

}  // namespace
}  // namespace odas::test::studio_sound_test
