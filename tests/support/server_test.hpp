// SPDX-License-Identifier: MIT
// A server of the Studio with a run of silence behind it.
#pragma once

#include <set>

#include "support/fake_io.hpp"
#include "support/scratch.hpp"
#include "support/web_client.hpp"
#include <gtest/gtest.h>

#include "odas/studio/server.hpp"

namespace odas::test {

inline constexpr std::size_t kSlots = 4, kHop = 128;

/// A run of silence with one source, number 7, in slot 1.
class FakeRun {
 public:
  FakeRun() {
    info.run = 1;
    info.name = "test array";
    info.slots = kSlots;
    info.hop_size = kHop;
    info.mics.resize(2);
    info.start = std::chrono::system_clock::now();
    hop.potentials.resize(2);
    hop.tracks.resize(kSlots);
    hop.tracks[1] = {.id = 7, .tag = "dynamic", .direction = {0, 1, 0}, .activity = 0.5F};
    hop.separated = hop.postfiltered = Grid<float>(kSlots, kHop);
    mics = Grid<float>(2, kHop);
  }
  HopResult next() {
    HopResult result = hop.result(++time);
    result.mics = mics;
    result.power = power;
    return result;
  }
  StreamInfo info;
  HopOfHand hop;
  Grid<float> mics;
  std::vector<float> power{0.5F, 0.25F};
  HopIndex time = 0;
};

/// Knows one file and one text.
class FakeFiles final : public FileProvider {
 public:
  explicit FakeFiles(std::filesystem::path file) : file_(std::move(file)) {}
  std::optional<Served> find(std::string_view path, const Query& query) override {
    if (path == "/api/v1/recordings/a b.wav") return Served{file_, false, "", "audio/wav", "a b.wav"};
    if (path == "/api/v1/export/csv") return Served{{}, false, query.find("session")->second, "text/csv", ""};
    return std::nullopt;
  }

 private:
  std::filesystem::path file_;
};

class ServerTest : public testing::Test {
 protected:
  static StudioConfig any_port() {
    StudioConfig config;
    config.port = 0;
    return config;
  }
  StudioServer& serve(const StudioConfig& config = any_port()) {
    ServerHooks hooks;
    hooks.say = [this](const std::string& what) { said.insert(what); };
    hooks.failure = [this] { return failure; };
    server = std::make_unique<StudioServer>(config, rpc, std::vector<FileProvider*>{&files}, hooks);
    return *server;
  }

  Scratch scratch;
  RpcRegistry rpc;
  FakeFiles files{scratch / "a.wav"};
  std::multiset<std::string> said;
  std::string failure;
  std::unique_ptr<StudioServer> server;
};

}  // namespace odas::test
