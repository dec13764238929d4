// SPDX-License-Identifier: MIT
// Runs ODAS's own configurations on scenes of which ODAS's output is known.
#include <iostream>
#include <map>
#include <set>

#include "support/goldens.hpp"
#include <gtest/gtest.h>
#include <sndfile.h>

#include "odas/config/reader.hpp"
#include "odas/pipeline/pipeline.hpp"

namespace odas::odas_conformance_test {
namespace {

using test::GoldenHop;
using test::thousandths;

constexpr float kOneDegree = 1;

float angle_deg(Vec3 a, Vec3 b) {
  return degrees(std::acos(std::clamp(dot(normalized(a), normalized(b)), -1.F, 1.F)));
}

/// The recording as [mic][frame], with the hop of silence that ODAS puts first.
Grid<float> read_recording(const std::filesystem::path& file, std::size_t hop) {
  SF_INFO info{};
  SNDFILE* sound = sf_open(file.c_str(), SFM_READ, &info);
  if (sound == nullptr) throw std::runtime_error("cannot read " + file.string());
  const auto channels = static_cast<std::size_t>(info.channels);
  const std::size_t frames = static_cast<std::size_t>(info.frames) / hop * hop;
  std::vector<float> interleaved(frames * channels);
  sf_readf_float(sound, interleaved.data(), static_cast<sf_count_t>(frames));
  sf_close(sound);
  Grid<float> mics(channels, frames + hop);
  for (std::size_t n = 0; n < frames; ++n) {
    for (std::size_t m = 0; m < channels; ++m) mics[m][hop + n] = interleaved[n * channels + m];
  }
  return mics;
}

struct Ours {
  std::vector<std::vector<Potential>> potentials;  // [hop]
  std::vector<std::vector<Track>> tracks;          // [hop]
};

Ours run(const std::filesystem::path& scene) {
  PipelineConfig config = load_configuration(scene / "odas/odas.cfg").config.pipeline;
  config.wanted = {.potentials = true, .tracks = true, .separated = false, .postfiltered = false};
  Pipeline pipeline(config);
  const std::size_t hop = pipeline.hop_size();
  const Grid<float> mics = read_recording(scene / "mics.wav", hop);
  Ours ours;
  for (std::size_t n = 0; n + hop <= mics.cols(); n += hop) {
    const HopResult result = pipeline.process_hop({mics.data() + n, mics.rows(), hop, mics.cols()});
    ours.potentials.emplace_back(result.potentials.begin(), result.potentials.end());
    ours.tracks.emplace_back(result.tracks.begin(), result.tracks.end());
  }
  return ours;
}

class Conformance : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const auto shared = test::shared_folder();
    if (!shared) GTEST_SKIP() << "no shared/scenes on this machine";
    scene_ = *shared / "scenes" / GetParam();
  }
  std::filesystem::path scene_;
};

TEST_P(Conformance, Potentials_are_those_that_ODAS_prints) {
  const Ours ours = run(scene_);
  const std::vector<GoldenHop> golden = test::read_goldens(scene_ / "odas/pots.json.gz");
  ASSERT_EQ(ours.potentials.size(), golden.size());
  std::size_t same = 0;
  std::size_t all = 0;
  std::size_t strongest_near = 0;
  std::map<std::size_t, std::size_t> different;  // [place among the hop's potentials]
  for (std::size_t h = 0; h < golden.size(); ++h) {
    for (std::size_t s = 0; s < golden[h].rows.size(); ++s, ++all) {
      const auto& theirs = golden[h].rows[s];
      const Potential& own = ours.potentials[h][s];
      const bool equal = thousandths(own.direction.x) == thousandths(theirs.x) &&
                         thousandths(own.direction.y) == thousandths(theirs.y) &&
                         thousandths(own.direction.z) == thousandths(theirs.z) &&
                         thousandths(own.energy) == thousandths(theirs.value);
      same += equal ? 1 : 0;
      if (!equal) ++different[s];
    }
    const auto strongest = [](const auto& list, auto energy) {
      return *std::max_element(list.begin(), list.end(),
                               [&](auto& a, auto& b) { return energy(a) < energy(b); });
    };
    const auto theirs = strongest(golden[h].rows, [](const test::GoldenRow& r) { return r.value; });
    const Potential own = strongest(ours.potentials[h], [](const Potential& p) { return p.energy; });
    strongest_near += angle_deg({theirs.x, theirs.y, theirs.z}, own.direction) <= kOneDegree ? 1 : 0;
  }
  const double share = static_cast<double>(same) / static_cast<double>(all);
  const double near = static_cast<double>(strongest_near) / static_cast<double>(golden.size());
  std::cout << "  " << GetParam() << ": potentials equal " << 100 * share << " %, strongest within 1 degree "
            << 100 * near << " % of hops; different by place:";
  for (const auto& [place, count] : different) std::cout << " " << place << ":" << count;
  std::cout << "\n";
  EXPECT_GE(share, 0.99);
  EXPECT_GE(near, 0.999);
}

/// Our id for each of ODAS's, given by the hops that they share nearby in; each is used once.
std::map<std::uint64_t, std::uint64_t> renaming(const Ours& ours, const std::vector<GoldenHop>& golden) {
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::size_t> together;
  for (std::size_t h = 0; h < golden.size(); ++h) {
    for (const auto& theirs : golden[h].rows) {
      for (const Track& own : ours.tracks[h]) {
        if (theirs.id == 0 || own.id == 0) continue;
        if (angle_deg({theirs.x, theirs.y, theirs.z}, own.direction) <= kOneDegree)
          ++together[{theirs.id, own.id}];
      }
    }
  }
  std::vector<std::pair<std::size_t, std::pair<std::uint64_t, std::uint64_t>>> order;
  for (const auto& [ids, hops] : together) order.push_back({hops, ids});
  std::sort(order.rbegin(), order.rend());
  std::map<std::uint64_t, std::uint64_t> names;
  std::set<std::uint64_t> taken;
  for (const auto& [hops, ids] : order) {
    if (names.contains(ids.first) || taken.contains(ids.second)) continue;
    names[ids.first] = ids.second;
    taken.insert(ids.second);
  }
  return names;
}

/// The tracks of a hop by our names.
using Named = std::map<std::uint64_t, Vec3>;

Named named(const GoldenHop& hop, const std::map<std::uint64_t, std::uint64_t>& names) {
  constexpr std::uint64_t kUnmatched = 1000000;
  Named tracks;
  for (const auto& row : hop.rows) {
    if (row.id == 0) continue;
    const auto name = names.find(row.id);
    tracks[name == names.end() ? kUnmatched + row.id : name->second] = {row.x, row.y, row.z};
  }
  return tracks;
}

Named named(const std::vector<Track>& hop) {
  Named tracks;
  for (const Track& t : hop) {
    if (t.id != 0) tracks[t.id] = t.direction;
  }
  return tracks;
}

/// The same tracks within a degree, but for those that are born or die within two hops from here.
bool same_tracks(const std::vector<Named>& a, const std::vector<Named>& b, std::size_t h) {
  const auto near_an_end = [&](std::uint64_t id) {
    const std::size_t first = h >= 2 ? h - 2 : 0;
    const std::size_t last = std::min(h + 2, a.size() - 1);
    bool in_a = false;
    bool in_b = false;
    for (std::size_t i = first; i <= last; ++i) {
      in_a = in_a || a[i].contains(id);
      in_b = in_b || b[i].contains(id);
    }
    return in_a && in_b;
  };
  for (const auto& [id, direction] : a[h]) {
    const auto other = b[h].find(id);
    if (other == b[h].end() ? !near_an_end(id) : angle_deg(direction, other->second) > kOneDegree)
      return false;
  }
  return std::all_of(b[h].begin(), b[h].end(),
                     [&](const auto& t) { return a[h].contains(t.first) || near_an_end(t.first); });
}

/// Hops, as ODAS counts them, in which its fault B5 shows: a potential so clear that all its hypotheses
/// underflow moves no track, and after it tracks that lie side by side go other ways. With that fault put
/// back for a trial, all hops of all scenes were equal. B15 shows in none of them.
struct Stretch {
  std::size_t first, last;
};
std::map<std::string, Stretch> mended() { return {{"rsp4_cross2", {867, 1810}}}; }

TEST_P(Conformance, Tracks_are_those_that_ODAS_prints) {
  const Ours ours = run(scene_);
  const std::vector<GoldenHop> golden = test::read_goldens(scene_ / "odas/tracks.json.gz");
  ASSERT_EQ(ours.tracks.size(), golden.size());
  const auto names = renaming(ours, golden);
  std::vector<Named> a;
  std::vector<Named> b;
  for (std::size_t h = 0; h < golden.size(); ++h) {
    a.push_back(named(ours.tracks[h]));
    b.push_back(named(golden[h], names));
  }
  const auto excused = mended();
  const auto excuse = excused.find(GetParam());
  std::size_t same = 0;
  std::string stretches;
  for (std::size_t h = 0; h < golden.size(); ++h) {
    const bool is_mended =
        excuse != excused.end() && h + 1 >= excuse->second.first && h + 1 <= excuse->second.last;
    if (is_mended || same_tracks(a, b, h)) {
      ++same;
      continue;
    }
    std::size_t end = h;
    while (end < golden.size() && !same_tracks(a, b, end)) ++end;
    stretches += " " + std::to_string(h + 1) + "-" + std::to_string(end);
    h = end - 1;
  }
  const double share = static_cast<double>(same) / static_cast<double>(golden.size());
  std::cout << "  " << GetParam() << ": tracks equal or mended in " << 100 * share << " % of hops; "
            << names.size() << " tracks; other stretches:" << (stretches.empty() ? " none" : stretches)
            << "\n";
  EXPECT_GE(share, 0.98);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Conformance,
                         ::testing::Values("rsp4_static1", "rsp4_static2", "rsp4_moving1", "rsp4_cross2",
                                           "rsp4_noisy1", "rsp4_noise_only", "uma7_static2", "uma7_static4",
                                           "oma16_static2", "cma16_static2"),
                         [](const auto& scene) { return std::string(scene.param); });

}  // namespace
}  // namespace odas::odas_conformance_test
