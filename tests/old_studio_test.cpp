// SPDX-License-Identifier: MIT
// The old Studio beside our engine: a model of its four sockets, driven by the outputs that ODAS has, shows
// the right tracks, and records the right tone under each id. And the other way round: our page's intake
// stands where the old Studio stood.
#include "support/old_studio.hpp"

#include <cmath>
#include <future>
#include <numbers>

#include "support/kept_hops.hpp"
#include "support/net_peer.hpp"
#include "support/program.hpp"
#include "support/scratch.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "odas/array/types.hpp"
#include "odas/studio/odas_intake.hpp"

namespace odas::test::old_studio_test {
namespace {

using nlohmann::json;

constexpr int kRate = 16000;
constexpr std::size_t kHop = 128, kMics = 8;
constexpr double kRadius = 0.1, kSeconds = 7;

/// Somebody who hums: a tone with all its overtones, from one place, for a while.
struct Hum {
  double pitch, azimuth, from, to;
};
constexpr std::array<Hum, 3> kHums{{{110, 30, 0.3, 3.5}, {140, 150, 1.5, 5.5}, {175, -90, 4.0, 6.8}}};

/// What the microphones of a ring hear of them. 16 bits, [frame][mic].
std::string sound() {
  const auto frames = static_cast<std::size_t>(kSeconds * kRate);
  std::vector<double> heard(frames * kMics);
  std::uint32_t random = 7;
  for (double& x : heard) {
    random = random * 1664525U + 1013904223U;
    x = (static_cast<double>(random >> 8) / (1 << 24) - 0.5) * 0.002;
  }
  for (const Hum& hum : kHums) {
    for (std::size_t m = 0; m < kMics; ++m) {
      const double place = 2 * std::numbers::pi * static_cast<double>(m) / kMics;
      const double delay = -kRadius * std::cos(place - hum.azimuth * std::numbers::pi / 180) / 343.0;
      for (int k = 1; k * hum.pitch < 7000; ++k) {
        // Oscillators by recurrence: sin(a + i w).
        const double step = 2 * std::numbers::pi * k * hum.pitch / kRate;
        const auto first = static_cast<std::size_t>(hum.from * kRate);
        const double phase = 0.7 * k * k - step * delay * kRate;
        double now = std::sin(phase), before = std::sin(phase - step);
        const double twice = 2 * std::cos(step);
        for (std::size_t i = first; i < static_cast<std::size_t>(hum.to * kRate); ++i) {
          heard[i * kMics + m] += 0.02 * now;
          const double next = twice * now - before;
          before = now;
          now = next;
        }
      }
    }
  }
  std::string bytes;
  bytes.reserve(heard.size() * 2);
  for (const double x : heard) {
    const auto sample = static_cast<std::int16_t>(std::lround(32767 * std::clamp(x, -1.0, 1.0)));
    bytes += static_cast<char>(sample & 0xFF);
    bytes += static_cast<char>((sample >> 8) & 0xFF);
  }
  return bytes;
}

std::string socket_at(int port) {
  return fmt::format("interface: {{ type = \"socket\"; ip = \"127.0.0.1\"; port = {}; }};", port);
}

std::string configuration(int tracked, int potential, int separated, int postfiltered,
                          const std::string& source) {
  std::string mics;
  for (std::size_t m = 0; m < kMics; ++m) {
    const double place = 2 * std::numbers::pi * static_cast<double>(m) / kMics;
    mics += fmt::format("{}{{ mu = ({:.5f}, {:.5f}, 0.0); }}", m == 0 ? "" : ", ", kRadius * std::cos(place),
                        kRadius * std::sin(place));
  }
  return fmt::format(
      "raw: {{ fS = 16000; hopSize = 128; nBits = 16; nChannels = 8; interface: {{ {} }}; }};\n"
      "general: {{ mics = ( {} ); }};\n"
      "ssl: {{ nPots = 4; potential: {{ format = \"json\"; {} }}; }};\n"
      "sst: {{ tracked: {{ format = \"json\"; {} }}; }};\n"
      "sss: {{ mode_sep = \"dgss\"; mode_pf = \"ms\"; separated: {{ fS = 16000; hopSize = 128; nBits = 16; "
      "{} }};\n"
      "  postfiltered: {{ fS = 16000; hopSize = 128; nBits = 16; {} }}; }};\n",
      source, mics, socket_at(potential), socket_at(tracked), socket_at(separated), socket_at(postfiltered));
}

/// How much of a voice is of a pitch: the power of its overtones from 500 Hz on.
double power_of(const std::vector<double>& voice, double pitch) {
  double sum = 0;
  for (int k = static_cast<int>(500 / pitch) + 1; k * pitch < 4000; ++k) {
    const double step = 2 * std::numbers::pi * k * pitch / kRate;
    double re = 0, im = 0;
    for (std::size_t i = 0; i < voice.size(); ++i) {
      re += voice[i] * std::cos(step * static_cast<double>(i));
      im += voice[i] * std::sin(step * static_cast<double>(i));
    }
    sum += (re * re + im * im) / static_cast<double>(voice.size());
  }
  return sum;
}

/// The pitch that a voice is the most of.
double pitch_of(const std::vector<double>& voice) {
  double best = 0, most = 0;
  for (const Hum& hum : kHums) {
    const double power = power_of(voice, hum.pitch);
    if (power > most) {
      most = power;
      best = hum.pitch;
    }
  }
  return best;
}

/// Which hum comes from a direction; none: no track of it lived long enough to count.
const Hum* hum_at(double azimuth) {
  for (const Hum& hum : kHums) {
    if (std::abs(std::remainder(azimuth - hum.azimuth, 360.0)) < 12) return &hum;
  }
  return nullptr;
}

double azimuth_of(double x, double y) { return std::atan2(y, x) * 180 / std::numbers::pi; }

std::vector<double> samples_of(const std::string& bytes) {
  std::vector<double> samples;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    samples.push_back(static_cast<std::int16_t>(static_cast<unsigned char>(bytes[i]) |
                                                (static_cast<unsigned char>(bytes[i + 1]) << 8)));
  }
  return samples;
}

/// One of the ports of the old Studio, with what came in the chunks in which it came.
class OldPort {
 public:
  [[nodiscard]] int port() const noexcept { return listener_.port(); }
  std::vector<std::string> chunks() { return got_.get(); }
  std::string bytes() {
    std::string all;
    for (const std::string& chunk : chunks()) all += chunk;
    return all;
  }

 private:
  NetListener listener_;
  std::future<std::vector<std::string>> got_{std::async(std::launch::async, [this] {
    const NetPeer peer = listener_.accept();
    std::vector<std::string> chunks;
    for (std::string chunk; !(chunk = peer.receive(65536)).empty();) chunks.push_back(std::move(chunk));
    return chunks;
  })};
};

ProgramRun run_odaslive(const Scratch& scratch, const std::string& config) {
  write_file(scratch / "run.cfg", config);
  ProgramOptions options;
  options.working_directory = scratch.folder();
  return run_program({program_path("odaslive"), "-c", "run.cfg"}, options);
}

TEST(OldStudio, shows_the_right_tracks_and_records_the_right_tone_under_each_id) {
  const Scratch scratch;
  write_file(scratch / "mics.raw", sound());
  OldPort tracked, potential, separated, postfiltered;
  const ProgramRun run =
      run_odaslive(scratch, configuration(tracked.port(), potential.port(), separated.port(),
                                          postfiltered.port(), "type = \"file\"; path = \"mics.raw\";"));
  ASSERT_EQ(run.exit_code, 0) << run.err;

  const std::vector<json> frames = parse_like_odas_web(tracked.bytes(), 1448);
  EXPECT_EQ(frames.size(), static_cast<std::size_t>(kSeconds * kRate) / kHop) << "the last one is held";
  for (const json& frame : parse_like_odas_web(potential.bytes(), 1448)) {
    ASSERT_FALSE(frame.is_discarded());
    EXPECT_EQ(frame["src"].size(), 4U);
  }
  const std::vector<std::string> voices = record_like_odas_web(separated.chunks());
  const std::vector<std::string> filtered = record_like_odas_web(postfiltered.chunks());

  OldStudioSlots slots;
  struct Recorded {
    std::string separated, postfiltered;
    double x = 0, y = 0;
  };
  std::map<std::uint64_t, Recorded> recorded;
  for (std::size_t hop = 0; hop < frames.size(); ++hop) {
    ASSERT_FALSE(frames[hop].is_discarded()) << hop;
    ASSERT_EQ(frames[hop]["timeStamp"], hop + 1);
    slots.hear(frames[hop]);
    for (std::size_t slot = 0; slot < 4; ++slot) {
      const std::uint64_t id = slots.ids()[slot];
      if (id == 0) continue;
      Recorded& voice = recorded[id];
      voice.separated += voices[slot].substr(hop * kHop * 2, kHop * 2);
      voice.postfiltered += filtered[slot].substr(hop * kHop * 2, kHop * 2);
      for (const json& source : frames[hop]["src"]) {
        if (source["id"] != id) continue;
        voice.x += source["x"].get<double>();
        voice.y += source["y"].get<double>();
      }
    }
  }
  std::map<double, int> heard;
  for (const auto& [id, voice] : recorded) {
    if (voice.separated.size() < kRate) continue;  // half a second: too short to have a pitch
    const Hum* hum = hum_at(azimuth_of(voice.x, voice.y));
    ASSERT_NE(hum, nullptr) << id << " at " << azimuth_of(voice.x, voice.y);
    EXPECT_EQ(pitch_of(samples_of(voice.separated)), hum->pitch) << id;
    EXPECT_EQ(pitch_of(samples_of(voice.postfiltered)), hum->pitch) << id;
    ++heard[hum->pitch];
  }
  EXPECT_EQ(heard.size(), kHums.size()) << "everybody was followed";
}

TEST(OurPage, stands_where_the_old_studio_stood) {
  const Scratch scratch;
  write_file(scratch / "mics.raw", sound());
  KeptHops kept;
  OdasIntakeConfig config;
  config.tracked = config.potential = config.separated = config.postfiltered = 0;
  std::string said;
  OdasIntake intake(config, kept, [&](const std::string& level, const std::string& text) {
    if (level != "info") said += text + "\n";
  });
  intake.start();
  const ProgramRun run = run_odaslive(
      scratch, configuration(intake.port("tracked"), intake.port("potential"), intake.port("separated"),
                             intake.port("postfiltered"), "type = \"file\"; path = \"mics.raw\";"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  ASSERT_TRUE(eventually([&] { return kept.count() > 0 && !kept.running(); }));
  intake.stop();
  const std::vector<KeptHops::Hop> hops = kept.hops();
  EXPECT_EQ(hops.size(), static_cast<std::size_t>(kSeconds * kRate) / kHop + 1);
  EXPECT_EQ(said, "");

  struct Heard {
    std::vector<double> separated;
    double x = 0, y = 0;
  };
  std::map<std::uint64_t, Heard> voices;
  for (const KeptHops::Hop& hop : hops) {
    EXPECT_EQ(hop.potentials.size(), 4U) << hop.time;
    ASSERT_EQ(hop.separated.size(), hop.tracks.size()) << hop.time;
    ASSERT_EQ(hop.postfiltered.size(), hop.tracks.size()) << hop.time;
    for (std::size_t slot = 0; slot < hop.tracks.size(); ++slot) {
      const Track& track = hop.tracks[slot];
      const auto& voice = hop.separated[slot];
      if (track.id == 0) continue;
      Heard& heard = voices[track.id];
      heard.separated.insert(heard.separated.end(), voice.begin(), voice.end());
      heard.x += track.direction.x;
      heard.y += track.direction.y;
    }
  }
  std::map<double, int> heard;
  for (const auto& [id, voice] : voices) {
    if (voice.separated.size() < kRate / 2) continue;
    const Hum* hum = hum_at(azimuth_of(voice.x, voice.y));
    ASSERT_NE(hum, nullptr) << id;
    EXPECT_EQ(pitch_of(voice.separated), hum->pitch) << id;
    ++heard[hum->pitch];
  }
  EXPECT_EQ(heard.size(), kHums.size());
}

}  // namespace
}  // namespace odas::test::old_studio_test
