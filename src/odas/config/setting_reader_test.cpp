// SPDX-License-Identifier: MIT
// The type traps of ODAS's reader (fault B11): each is read rightly here, or named.
#include "odas/config/setting_reader.hpp"

#include "support/config_faults.hpp"

namespace odas::setting_reader_test {
namespace {

using test::clean;
using test::errs;
using test::read_changed;
using test::read_with;
using test::warns;

TEST(SettingReader, takes_a_whole_number_for_a_fraction) {
  const auto loaded = read_changed("general: {", "general: { speedofsound: { mu = 343; sigma2 = 25; };");
  ASSERT_TRUE(clean(loaded));
  EXPECT_FLOAT_EQ(loaded.config.pipeline.general.speedofsound.mu, 343);
}

TEST(SettingReader, takes_a_fraction_for_a_whole_number_when_it_is_one) {
  const auto loaded = read_changed("fS = 16000", "fS = 16000.0");
  ASSERT_TRUE(clean(loaded));
  EXPECT_EQ(loaded.config.raw.fs, 16000);
  EXPECT_TRUE(errs(read_changed("fS = 16000", "fS = 16000.5"), "raw.fS", "must be a whole number"));
}

TEST(SettingReader, mixes_whole_numbers_and_fractions_in_lists_and_arrays) {
  for (const char* mu : {"(0.05, 0, 0.0)", "[0.05, 0, 0.0]", "[5e-2, 0x0, 0L]"}) {
    const auto loaded = read_changed("(0.05, 0.0, 0.0)", mu);
    ASSERT_TRUE(clean(loaded)) << mu;
    EXPECT_FLOAT_EQ(loaded.config.pipeline.general.mics[0].mu[0], 0.05F) << mu;
  }
}

TEST(SettingReader, names_a_number_where_a_text_is_wanted_and_the_other_way_round) {
  EXPECT_TRUE(
      errs(read_with("sst: { mode = 3; };"), "sst.mode", "is the number 3, must be a text in quotes"));
  EXPECT_TRUE(errs(read_changed("fS = 16000", "fS = \"16000\""), "raw.fS",
                   "is the text \"16000\", must be a whole number"));
  EXPECT_TRUE(errs(read_with("sst: { Pnew = true; };"), "sst.Pnew", "is true, must be a number"));
}

TEST(SettingReader, names_groups_and_lists_that_are_in_the_wrong_place) {
  EXPECT_TRUE(errs(read_with("ssl: 3;"), "ssl", "must be a group { }"));
  EXPECT_TRUE(
      errs(read_with("sst: { kalman = (1, 2); };"), "sst.kalman", "is a list ( ), must be a group { }"));
  EXPECT_TRUE(errs(read_with("sst: { N_inactive = 250; };"), "sst.N_inactive",
                   "must be a list ( ) of whole numbers"));
  EXPECT_TRUE(errs(read_with("sst: { target = { }; };"), "sst.target", "must be a list ( ) of groups { }"));
  EXPECT_TRUE(errs(read_with("sst: { target = (1); };"), "sst.target[0]", "must be a group { }"));
}

TEST(SettingReader, wants_vectors_of_the_right_length) {
  EXPECT_TRUE(errs(read_changed("(0.05, 0.0, 0.0)", "(0.05, 0.0)"), "general.mics[0].mu",
                   "has 2 numbers, must have 3"));
}

TEST(SettingReader, refuses_numbers_without_end_and_numbers_that_vanish) {
  EXPECT_TRUE(
      errs(read_changed("0.05, 0.0, 0.0", "1e999, 0.0, 0.0"), "general.mics[0].mu[0]", "is not finite"));
  EXPECT_TRUE(
      errs(read_changed("0.05, 0.0, 0.0", "1e50, 0.0, 0.0"), "general.mics[0].mu[0]", "is not finite"));
  EXPECT_TRUE(errs(read_changed("general: {", "general: { epsilon = 1e-60;"), "general.epsilon",
                   "must be more than 0"));
}

TEST(SettingReader, says_what_is_allowed_where_a_number_is_out_of_range) {
  EXPECT_TRUE(errs(read_with("ssl: { nPots = -3; };"), "ssl.nPots", "is -3, must be 1 to 64"));
  EXPECT_TRUE(errs(read_changed("fS = 16000", "fS = 99999999999"), "raw.fS",
                   "is 99999999999 Hz, must be 1000 to 384000 Hz"));
}

TEST(SettingReader, lists_the_choices_and_the_one_that_was_meant) {
  EXPECT_TRUE(
      errs(read_with("sst: { mode = \"kalmann\"; };"), "sst.mode",
           "is \"kalmann\", must be \"kalman\", \"particle\" or \"bernoulli\"; did you mean \"kalman\"?"));
}

TEST(SettingReader, warns_of_unknown_keys_with_the_nearest_known_one) {
  EXPECT_TRUE(warns(read_with("sst: { theta_nwe = 0.5; };"), "sst.theta_nwe", "did you mean \"theta_new\"?"));
  EXPECT_TRUE(warns(read_with("sst: { nPots = 4; };"), "sst.nPots", "it belongs to ssl.nPots"));
  EXPECT_TRUE(warns(read_with("sstt: { };"), "sstt", "did you mean \"sst\"?"));
  EXPECT_TRUE(warns(read_with("sst: { colour = \"red\"; };"), "sst.colour", "unknown key, ignored"));
}

TEST(SettingReader, knows_the_keys_that_ODAS_ignores) {
  EXPECT_TRUE(
      clean(read_with("version = \"2.1\"; sss: { dds: { }; dmvdr: { }; separated: { gain = 10; }; };")));
}

TEST(SettingReader, wants_what_describes_the_hardware) {
  const auto loaded = read_configuration_text("", "empty.cfg");
  EXPECT_TRUE(errs(loaded, "raw.fS", "is missing"));
  EXPECT_TRUE(errs(loaded, "raw.nChannels", "is missing"));
  EXPECT_TRUE(errs(loaded, "general.mics", "is missing"));
  EXPECT_TRUE(errs(read_changed("mu = (0.05, 0.0, 0.0);", ""), "general.mics[0].mu", "is missing"));
}

TEST(SettingReader, reads_the_single_group_of_old_files_as_a_list_of_one) {
  const auto loaded =
      read_changed("general: {", "general: { spatialfilter: { direction = (0, 0, 2); angle = (80, 90); };");
  ASSERT_TRUE(loaded.ok());
  EXPECT_TRUE(warns(loaded, "general.spatialfilter", "read as spatialfilters"));
  ASSERT_TRUE(loaded.config.pipeline.general.spatialfilters.has_value());
  ASSERT_EQ(loaded.config.pipeline.general.spatialfilters->size(), 1U);
  EXPECT_FLOAT_EQ(loaded.config.pipeline.general.spatialfilters->front().angle[1], 90);
}

TEST(SettingReader, tells_an_absent_list_of_filters_from_an_empty_one) {
  EXPECT_FALSE(read_with("").config.pipeline.general.spatialfilters.has_value());
  const auto empty = read_changed("general: {", "general: { spatialfilters = ();");
  ASSERT_TRUE(empty.config.pipeline.general.spatialfilters.has_value());
  EXPECT_TRUE(empty.config.pipeline.general.spatialfilters->empty());
}

TEST(SettingReader, lets_no_default_shine_through_a_list_that_is_written) {
  const auto loaded = read_with("ssl: { scans = ( { level = 1; }, { delta = 3; }, { level = 5; } ); };");
  EXPECT_EQ(loaded.config.pipeline.ssl.scans.at(1).level, ScanConfig{}.level)
      << "not that of the default's second";
  EXPECT_EQ(loaded.config.pipeline.ssl.scans.size(), 3U);
}

TEST(SettingReader, carries_every_kind_of_value) {
  const auto loaded = read_with(R"(
mapping: { map = (2, 1); };
sst: { N_inactive = [10, 20]; target = ( { tag = "fan"; x = 0; y = 0.5; z = 1.0; } );
       tracked: { format = "json"; interface: { type = "socket"; ip = "127.0.0.1"; port = 9000; }; }; };)");
  ASSERT_TRUE(clean(loaded));
  EXPECT_EQ(loaded.config.mapping.map, (std::vector{2, 1}));
  EXPECT_EQ(loaded.config.pipeline.sst.n_inactive, (std::vector{10, 20}));
  EXPECT_EQ(loaded.config.pipeline.sst.target.at(0).tag, "fan");
  EXPECT_FLOAT_EQ(loaded.config.pipeline.sst.target.at(0).y, 0.5F);
  EXPECT_EQ(loaded.config.tracked.interface.port, 9000);
}

}  // namespace
}  // namespace odas::setting_reader_test
