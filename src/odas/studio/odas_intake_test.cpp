// SPDX-License-Identifier: MIT
#include "odas/studio/odas_intake.hpp"

#include <algorithm>
#include <functional>

#include "support/hop_maker.hpp"
#include "support/kept_hops.hpp"
#include "support/net_peer.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::odas_intake_test {
namespace {

using test::eventually;
using test::NetPeer;

enum class Layout { odas, crlf, compact };

/// What ODAS sends of so many hops: text and sound.
struct Sent {
  std::string tracks, potentials, sound;
};

class OdasIntakeTest : public testing::Test {
 protected:
  void SetUp() override {
    OdasIntakeConfig config;
    config.tracked = config.potential = config.separated = config.postfiltered = 0;
    config.channels = 2;
    intake.emplace(config, kept, [this](const std::string&, const std::string& text) {
      const std::scoped_lock lock(mutex);
      said.push_back(text);
    });
    intake->start();
  }
  Sent make(int count, const std::function<std::vector<std::uint64_t>(int)>& ids,
            Layout layout = Layout::odas) {
    Sent sent;
    for (int i = 0; i < count; ++i) {
      const HopResult hop = maker.next(ids(i));
      std::string text = fmt::format("{{\n    \"timeStamp\": {},\n    \"src\": [\n", hop.time);
      for (std::size_t s = 0; s < hop.tracks.size(); ++s) {
        text += fmt::format(
            "        {{ \"id\": {}, \"tag\": \"{}\", \"x\": 0.000, \"y\": 1.000, \"z\": 0.000, \"activity\": "
            "0.900 }}{}\n",
            hop.tracks[s].id, hop.tracks[s].id == 0 ? "" : "dynamic", s + 1 < hop.tracks.size() ? "," : "");
      }
      text += "    ]\n}\n";
      sent.tracks += laid_out(text, layout);
      sent.potentials += laid_out(fmt::format("{{\n    \"timeStamp\": {},\n    \"src\": [\n        {{ \"x\": "
                                              "1.000, \"y\": 0.000, \"z\": 0.000, "
                                              "\"E\": 0.500 }}\n    ]\n}}\n",
                                              hop.time),
                                  layout);
      for (std::size_t k = 0; k < 128; ++k) {
        for (std::size_t s = 0; s < hop.tracks.size(); ++s) {
          const std::uint64_t id = hop.tracks[s].id;
          const std::int16_t sample = id == 0 ? 0 : test::tone_sample(id, (hop.time - 1) * 128 + k);
          sent.sound += static_cast<char>(sample & 0xFF);
          sent.sound += static_cast<char>((sample >> 8) & 0xFF);
        }
      }
    }
    return sent;
  }
  static std::string laid_out(std::string text, Layout layout) {
    if (layout == Layout::odas) return text;
    std::string out;
    for (const char c : text) {
      if (c == '\n' && layout == Layout::crlf) out += '\r';
      if (layout == Layout::compact && (c == '\n' || c == ' ')) continue;
      out += c;
    }
    return out;
  }
  /// Sends in chunks of pseudo-random sizes up to `most`.
  void send(const NetPeer& peer, const std::string& bytes, std::size_t most) {
    for (std::size_t at = 0; at < bytes.size();) {
      random = random * 1664525U + 1013904223U;
      const std::size_t size = most == 1 ? 1 : 1 + (random >> 8) % most;
      ASSERT_TRUE(peer.send(std::string_view(bytes).substr(at, size)));
      at += size;
    }
  }
  NetPeer dial(const char* stream) const { return NetPeer::dial(intake->port(stream)); }
  /// Hops that had sound; each of its samples is that of the id of its row.
  std::size_t sounding() {
    std::size_t count = 0;
    for (const auto& hop : kept.hops()) {
      if (hop.separated.empty()) continue;
      ++count;
      for (std::size_t slot = 0; slot < hop.tracks.size(); ++slot) {
        const std::uint64_t id = hop.tracks[slot].id;
        for (std::size_t i = 0; i < 128; ++i) {
          const float expected = id == 0 ? 0 : test::tone_of(id, (hop.time - 1) * 128 + i);
          if (std::abs(hop.separated[slot][i] - expected) > 1e-4F) {
            ADD_FAILURE() << "hop " << hop.time << ": not the voice of " << id;
            return count;
          }
        }
      }
    }
    return count;
  }
  bool is_said(const std::string& part) {
    const std::scoped_lock lock(mutex);
    return std::any_of(said.begin(), said.end(),
                       [&](const std::string& text) { return text.find(part) != std::string::npos; });
  }

  test::HopMaker maker;
  test::KeptHops kept;
  std::mutex mutex;
  std::vector<std::string> said;
  std::uint32_t random = 1;
  std::optional<OdasIntake> intake;  // the first to go
};

std::vector<std::uint64_t> coming_and_going(int i) {
  return {static_cast<std::uint64_t>(i / 20 % 3 == 0 ? 0 : 1 + i / 20),
          static_cast<std::uint64_t>(100 + i / 33)};
}

TEST_F(OdasIntakeTest, reads_any_chunks_in_any_layout) {
  std::size_t hops = 0, run = 0;
  for (const Layout layout : {Layout::odas, Layout::crlf, Layout::compact}) {
    for (const std::size_t most : {std::size_t{1}, std::size_t{7}, std::size_t{1460}, std::size_t{65536}}) {
      const int count = most == 1 ? 10 : 100;
      maker.time = 0;
      const Sent sent = make(count, coming_and_going, layout);
      NetPeer tracks = dial("tracked"), potentials = dial("potential"), sound = dial("separated");
      send(potentials, sent.potentials, most);
      send(tracks, sent.tracks, most);
      send(sound, sent.sound, most);
      hops += static_cast<std::size_t>(count);
      ASSERT_TRUE(eventually([&] { return kept.count() == hops; })) << kept.count() << " of " << hops;
      sound.close();
      potentials.close();
      tracks.close();
      ASSERT_TRUE(eventually([&] { return !kept.running(); }));
      EXPECT_EQ(kept.infos().size(), ++run);
    }
  }
  EXPECT_EQ(sounding(), hops) << "every hop has its sound";
  for (const auto& hop : kept.hops()) EXPECT_EQ(hop.potentials.size(), 1U);
  EXPECT_FALSE(is_said("passed over"));
}

TEST_F(OdasIntakeTest, begins_anew_after_a_sender_that_was_cut_off_in_the_middle) {
  const Sent first = make(50, coming_and_going);
  {
    const NetPeer tracks = dial("tracked"), sound = dial("separated");
    send(sound, first.sound.substr(0, first.sound.size() - 333), 4096);
    send(tracks, first.tracks.substr(0, first.tracks.size() - 77), 4096);
    ASSERT_TRUE(eventually([&] { return kept.count() >= 48; }));
  }
  ASSERT_TRUE(eventually([&] { return !kept.running(); }));
  const std::size_t before = kept.count();
  EXPECT_EQ(before, 49U);
  maker.time = 0;
  const Sent second = make(50, coming_and_going);
  const NetPeer tracks = dial("tracked"), sound = dial("separated");
  send(sound, second.sound, 4096);
  send(tracks, second.tracks, 4096);
  ASSERT_TRUE(eventually([&] { return kept.count() == before + 50; }));
  EXPECT_EQ(kept.infos().size(), 2U);
  EXPECT_GE(sounding(), before - 1 + 50);
}

TEST_F(OdasIntakeTest, shows_tracks_without_sound_of_somebody_who_joins_late) {
  maker.time = 500;
  const Sent sent = make(50, coming_and_going);
  const NetPeer sound = dial("separated"), tracks = dial("tracked");
  send(sound, sent.sound, 4096);
  send(tracks, sent.tracks, 4096);
  ASSERT_TRUE(eventually([&] { return kept.count() == 50; }));
  EXPECT_EQ(sounding(), 0U);
  EXPECT_TRUE(is_said("joined under way"));
}

TEST_F(OdasIntakeTest, passes_nonsense_over_and_says_so) {
  const NetPeer tracks = dial("tracked"), sound = dial("separated");
  const Sent sent = make(10, [](int) { return std::vector<std::uint64_t>{1, 2}; });
  send(tracks, "GET / HTTP/1.1\r\n\r\n" + sent.tracks, 65536);
  send(sound, sent.tracks, 65536);  // the ports are mixed up
  ASSERT_TRUE(eventually([&] { return is_said("the ports of the sender are mixed up"); }));
  ASSERT_TRUE(eventually([&] { return kept.count() == 10; })) << kept.count();
  EXPECT_EQ(sounding(), 0U);
  EXPECT_TRUE(is_said("GET / HTTP"));
}

TEST_F(OdasIntakeTest, has_one_sender_at_a_time) {
  const NetPeer first = dial("tracked");
  first.send("{");
  ASSERT_TRUE(eventually([&] { return intake->has_sender(); }));
  const NetPeer second = dial("tracked");
  EXPECT_TRUE(second.is_left());
  EXPECT_TRUE(is_said("is turned away"));
}

TEST_F(OdasIntakeTest, can_be_stopped_and_started_again) {
  intake->stop();
  intake->start();
  const Sent sent = make(5, [](int) { return std::vector<std::uint64_t>{1, 0}; });
  const NetPeer tracks = dial("tracked");
  send(tracks, sent.tracks, 100);
  ASSERT_TRUE(eventually([&] { return kept.count() == 5; }));
  intake->stop();
  EXPECT_FALSE(kept.running());
}

TEST(OdasIntakeConfig, of_impossible_numbers_is_refused) {
  test::KeptHops kept;
  OdasIntakeConfig config;
  config.tracked = config.potential = config.separated = config.postfiltered = 0;
  config.bits = 12;
  EXPECT_THROW(OdasIntake(config, kept, {}), ConfigError);
  config.bits = 16;
  config.channels = 0;
  EXPECT_THROW(OdasIntake(config, kept, {}), ConfigError);
}

}  // namespace
}  // namespace odas::odas_intake_test
