// SPDX-License-Identifier: MIT
// What ODAS does not check (fault B11b): each of these crashed it, or went wrong silently.
#include "support/config_faults.hpp"

#include "odas/config/checks.hpp"

namespace odas::check_array_test {
namespace {

using test::clean;
using test::errs;
using test::read_changed;
using test::read_with;
using test::warns;

TEST(CheckArray, wants_map_entries_within_the_channels) {
  EXPECT_TRUE(errs(read_with("mapping: { map = (1, 3); };"), "mapping.map[1]",
                   "is channel 3, but raw.nChannels is 2"));
}

TEST(CheckArray, wants_one_map_entry_for_each_microphone) {
  EXPECT_TRUE(
      errs(read_with("mapping: { map = (1); };"), "mapping.map", "has 1 entries for the 2 microphones"));
  EXPECT_TRUE(errs(read_changed("nChannels = 2", "nChannels = 1"), "raw.nChannels",
                   "fewer than the 2 microphones of general.mics"));
}

TEST(CheckArray, doubts_maps_that_leave_microphones_without_a_channel_of_their_own) {
  EXPECT_TRUE(
      warns(read_with("mapping: { map = (2, 2); };"), "mapping.map[1]", "channel 2 stands for another"));
  EXPECT_TRUE(errs(read_with("mapping: { map = (1, 0); };"), "mapping.map", "fewer than two microphones"));
}

TEST(CheckArray, wants_a_reference_that_is_there_and_is_no_microphone) {
  EXPECT_TRUE(errs(read_with("mapping: { reference = (3); };"), "mapping.reference[0]",
                   "is channel 3, but raw.nChannels is 2"));
  EXPECT_TRUE(warns(read_with("mapping: { reference = (2); };"), "mapping.reference[0]",
                    "channel 2 is a microphone, too"));
  const auto four = [](std::string_view mapping) {
    std::string text(test::kLeast);
    text.replace(text.find("nChannels = 2"), 13, "nChannels = 4");
    return read_configuration_text(text + std::string(mapping), "test.cfg");
  };
  EXPECT_TRUE(warns(four("mapping: { map = (3, 4); reference = (4); };"), "mapping.reference[0]",
                    "channel 4 is a microphone, too"));
  EXPECT_TRUE(warns(four("mapping: { reference = (3, 3); };"), "mapping.reference[1]",
                    "channel 3 is a reference already"));
  EXPECT_TRUE(warns(read_with("mapping: { echoLength = 200.0; };"), "mapping.echoLength", "has no effect"));
  EXPECT_TRUE(clean(four("mapping: { reference = (3, 4); echoLength = 200.0; };")));
}

TEST(CheckArray, wants_the_hop_within_the_frame) {
  EXPECT_TRUE(errs(read_changed("general: {", "general: { size: { hopSize = 512; frameSize = 256; };"),
                   "general.size.hopSize", "is 512, must be at most frameSize, which is 256"));
  EXPECT_TRUE(errs(read_changed("general: {", "general: { size: { hopSize = 257; frameSize = 257; };"),
                   "general.size.hopSize", "must be at most"));
  EXPECT_TRUE(warns(read_changed("general: {", "general: { size: { hopSize = 200; frameSize = 256; };"),
                    "general.size.hopSize", "more than half"));
}

TEST(CheckArray, wants_a_raw_rate_that_is_not_below_the_processing_rate) {
  EXPECT_TRUE(errs(read_changed("fS = 16000", "fS = 8000"), "raw.fS",
                   "is 8000 Hz, must be at least general.samplerate.mu, which is 16000 Hz"));
}

TEST(CheckArray, wants_sample_sizes_that_there_are) {
  EXPECT_TRUE(errs(read_changed("nChannels", "nBits = 12; nChannels"), "raw.nBits",
                   "is 12, must be 8, 16, 24 or 32"));
  EXPECT_TRUE(errs(read_with("sss: { separated: { nBits = 20; }; };"), "sss.separated.nBits",
                   "must be 8, 16, 24 or 32"));
}

TEST(CheckArray, wants_two_microphones_at_two_places) {
  EXPECT_TRUE(
      errs(read_changed("{ mu = (0.05, 0.0, 0.0); },", ""), "general.mics", "has 1 microphone, must have"));
  const auto same = read_changed("-0.05", "0.05");
  EXPECT_TRUE(errs(same, "general.mics", "all microphones are at the same place"));
  EXPECT_TRUE(warns(same, "general.mics[1].mu", "is the place of general.mics[0] too"));
}

TEST(CheckArray, takes_at_most_128_microphones) {
  std::string mics;
  for (int i = 0; i < 129; ++i) mics += "{ mu = (" + std::to_string(i) + "e-3, 0.0, 0.0); }, ";
  EXPECT_TRUE(errs(read_changed("mics = (", "mics = (" + mics), "general.mics", "can have at most 128"));
}

TEST(CheckArray, doubts_millimetres_where_metres_are_meant) {
  EXPECT_TRUE(
      warns(read_changed("0.05, 0.0, 0.0", "50, 0.0, 0.0"), "general.mics", "are the positions in metres?"));
  EXPECT_TRUE(warns(read_changed("-0.05", "0.0499"), "general.mics", "too close"));
}

TEST(CheckArray, wants_directions_that_point_somewhere) {
  EXPECT_TRUE(errs(read_changed("mu = (0.05, 0.0, 0.0);", "mu = (0.05, 0.0, 0.0); direction = (0, 0, 0);"),
                   "general.mics[0].direction", "must point somewhere"));
  EXPECT_TRUE(errs(read_changed("general: {", "general: { spatialfilters = ( { direction = (0, 0, 0); } );"),
                   "general.spatialfilters[0].direction", "must point somewhere"));
}

TEST(CheckArray, wants_the_full_pass_within_the_no_pass) {
  EXPECT_TRUE(errs(read_changed("mu = (0.05, 0.0, 0.0);", "mu = (0.05, 0.0, 0.0); angle = (90, 80);"),
                   "general.mics[0].angle", "the first must not be larger than the second"));
  EXPECT_TRUE(clean(read_changed("mu = (0.05, 0.0, 0.0);", "mu = (0.05, 0.0, 0.0); angle = (180, 180);")));
}

TEST(CheckArray, wants_covariances_that_are_some) {
  const auto with = [](const std::string& sigma2) {
    return read_changed("mu = (0.05, 0.0, 0.0);", "mu = (0.05, 0.0, 0.0); sigma2 = (" + sigma2 + ");");
  };
  EXPECT_TRUE(clean(with("1e-6, 0, 0, 0, 1e-6, 0, 0, 0, 1e-6")));
  EXPECT_TRUE(clean(with("1e-6, 1e-6, 0, 1e-6, 1e-6, 0, 0, 0, 0"))) << "variance along one diagonal only";
  EXPECT_TRUE(
      errs(with("-1e-6, 0, 0, 0, 1e-6, 0, 0, 0, 1e-6"), "general.mics[0].sigma2", "is no covariance"));
  EXPECT_TRUE(
      errs(with("1e-6, 2e-6, 0, 2e-6, 1e-6, 0, 0, 0, 1e-6"), "general.mics[0].sigma2", "is no covariance"));
}

}  // namespace
}  // namespace odas::check_array_test
