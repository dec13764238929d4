// SPDX-License-Identifier: MIT
#include "support/config_faults.hpp"

#include "odas/config/checks.hpp"

namespace odas::check_stages_test {
namespace {

using test::clean;
using test::errs;
using test::read_changed;
using test::read_with;
using test::warns;

TEST(CheckStages, want_scans_that_go_from_coarse_to_fine) {
  EXPECT_TRUE(errs(read_with("ssl: { scans = ( { level = 4; }, { level = 2; } ); };"), "ssl.scans[1].level",
                   "is 2 after 4: levels must rise"));
  EXPECT_TRUE(errs(read_with("ssl: { scans = (); };"), "ssl.scans", "must have at least one level"));
}

TEST(CheckStages, want_potentials_and_links_that_the_grids_can_give) {
  EXPECT_TRUE(errs(read_with("ssl: { nPots = 20; nMatches = 3; scans = ( { level = 0; } ); };"), "ssl.nPots",
                   "more than the 12 directions"));
  EXPECT_TRUE(warns(read_with("ssl: { nMatches = 50; scans = ( { level = 1; }, { level = 3; } ); };"),
                    "ssl.nMatches", "more than the 42 directions"));
  EXPECT_TRUE(clean(read_with("ssl: { nPots = 1; };"))) << "fewer potentials than scans: ODAS's fault B8";
}

TEST(CheckStages, want_deltas_and_correlations_of_a_sane_length) {
  EXPECT_TRUE(errs(read_with("ssl: { interpRate = 1; scans = ( { level = 2; delta = 200; } ); };"),
                   "ssl.scans[0].delta", "more than half of the correlation (128)"));
  EXPECT_TRUE(
      errs(read_changed("general: {", "ssl: { interpRate = 64; }; general: { size: { frameSize = 65536; };"),
           "ssl.interpRate", "must be at most 262144"));
}

TEST(CheckStages, want_mixtures_with_weight) {
  EXPECT_TRUE(errs(read_with("sst: { active = (); };"), "sst.active", "must have at least one Gaussian"));
  EXPECT_TRUE(errs(read_with("sst: { inactive = ( { weight = 0.0; mu = 0.2; } ); };"), "sst.inactive",
                   "has weights that are all 0"));
}

TEST(CheckStages, want_one_to_sixty_four_tracks) {
  EXPECT_TRUE(errs(read_with("sst: { N_inactive = (); };"), "sst.N_inactive", "has 0 numbers"));
  std::string many = "1";
  for (int i = 1; i < 65; ++i) many += ", 1";
  EXPECT_TRUE(errs(read_with("sst: { N_inactive = (" + many + "); };"), "sst.N_inactive", "has 65 numbers"));
  EXPECT_TRUE(errs(read_with("sst: { nTracks = 65; };"), "sst.nTracks", "must be 0 to 64"));
  EXPECT_TRUE(errs(read_with("sst: { nTracks = 2; N_inactive = (); };"), "sst.N_inactive", "has 0 numbers"));
  const LoadedConfiguration both = read_with("sst: { nTracks = 6; N_inactive = (100, 50); };");
  EXPECT_TRUE(clean(both));
  EXPECT_EQ(both.config.pipeline.sst.slots(), 6U);
}

LoadedConfiguration with_targets(const std::string& targets) {
  return read_with("sst: { target = (" + targets + "); };");
}

TEST(CheckStages, want_targets_with_names_of_their_own) {
  EXPECT_TRUE(clean(with_targets(R"({ tag = "fan"; x = 0; y = 0; z = 1; })")));
  EXPECT_TRUE(errs(with_targets(R"({ tag = ""; z = 1; })"), "sst.target[0].tag", "is empty"));
  EXPECT_TRUE(errs(with_targets(R"({ z = 1; })"), "sst.target[0].tag", "is empty"));
  EXPECT_TRUE(errs(with_targets(R"({ tag = "dynamic"; })"), "sst.target[0].tag", "take another"));
  EXPECT_TRUE(
      errs(with_targets(R"({ tag = "a"; }, { tag = "a"; })"), "sst.target[1].tag", "name of another target"));
  EXPECT_TRUE(clean(with_targets("{ tag = \"" + std::string(63, 'x') + "\"; }")));
  EXPECT_TRUE(
      errs(with_targets("{ tag = \"" + std::string(64, 'x') + "\"; }"), "sst.target[0].tag", "has 64 bytes"));
}

TEST(CheckStages, want_names_that_can_be_written_as_JSON) {
  EXPECT_TRUE(clean(with_targets("{ tag = \"caf\xC3\xA9\"; }")));
  EXPECT_TRUE(errs(with_targets("{ tag = \"caf\xE9\"; }"), "sst.target[0].tag", "is no UTF-8 text"));
  EXPECT_TRUE(errs(with_targets("{ tag = \"caf\xC3\"; }"), "sst.target[0].tag", "is no UTF-8 text"));
}

TEST(CheckStages, want_targets_that_lie_somewhere) {
  EXPECT_TRUE(
      errs(with_targets(R"({ tag = "a"; x = 0; y = 0; z = 0; })"), "sst.target[0]", "points nowhere"));
}

TEST(CheckStages, doubt_targets_beyond_the_tracks_and_static_tracks_without_targets) {
  EXPECT_TRUE(warns(read_with(R"(sst: { N_inactive = (1); target = ( { tag = "a"; }, { tag = "b"; } ); };)"),
                    "sst.target", "has 2 targets for the 1 tracks"));
  EXPECT_TRUE(warns(read_with(R"(sst: { add = "static"; };)"), "sst.add", "nothing will be followed"));
}

TEST(CheckStages, want_a_prior) {
  EXPECT_TRUE(errs(read_with("sst: { Pfalse = 0; Pnew = 0; Ptrack = 0.0; };"), "sst.Pfalse",
                   "one of them must not be"));
}

TEST(CheckStages, doubt_particles_that_do_not_add_up) {
  EXPECT_TRUE(warns(read_with(R"(sst: { mode = "particle"; particle: { st_ratio = 0.9; }; };)"),
                    "sst.particle", "add up to 1.4"));
}

TEST(CheckStages, want_windows_within_the_frame_of_the_filter_that_is_used) {
  EXPECT_TRUE(errs(read_with(R"(sss: { mode_pf = "ms"; ms: { winSizeFrame = 257; }; };)"),
                   "sss.ms.winSizeFrame", "must be at most general.size.frameSize, which is 256"));
  const auto unused = read_with(R"(sss: { mode_pf = "ss"; ms: { winSizeFrame = 257; }; };)");
  EXPECT_TRUE(unused.ok());
  EXPECT_TRUE(warns(unused, "sss.ms.winSizeFrame", "unused"));
  EXPECT_TRUE(errs(read_with("sne: { b = 131; };"), "sne.b", "more than the 129 bins"));
}

TEST(CheckStages, doubt_a_look_back_that_a_track_does_not_outlive) {
  EXPECT_TRUE(warns(read_with("sst: { N_inactive = (30, 37); }; sss: { lookback = 300; };"), "sss.lookback",
                    "is 38 hops, longer than a track outlives its talker (sst.N_inactive is 30)"));
  EXPECT_TRUE(test::clean(read_with("sst: { N_inactive = (38); }; sss: { lookback = 300; };")));
}

TEST(CheckStages, want_a_range_of_pitch) {
  EXPECT_TRUE(errs(read_with("classify: { tauMin = 300; };"), "classify.tauMin", "must be less than tauMax"));
  EXPECT_TRUE(
      errs(read_with("classify: { tauMax = 2000; };"), "classify.tauMax", "must be less than frameSize"));
}

}  // namespace
}  // namespace odas::check_stages_test
