// SPDX-License-Identifier: MIT
#include "odas/config/checks.hpp"

#include "support/config_faults.hpp"

namespace odas::checks_test {
namespace {

TEST(Checks, find_nothing_in_the_least_configuration) { EXPECT_TRUE(test::clean(test::read_with(""))); }

TEST(Checks, know_what_is_sound) {
  std::vector<Fault> faults{{Fault::Severity::error, "general.mics[1].mu", "", "", 0},
                            {Fault::Severity::warning, "ssl.nPots", "", "", 0}};
  const Locations locations;
  const CheckReport report(locations, faults);
  EXPECT_FALSE(report.sound("general.mics[1].mu"));
  EXPECT_FALSE(report.sound("general.mics")) << "what holds a fault is not sound";
  EXPECT_FALSE(report.sound("general.mics[1].mu[0]")) << "nor what a fault holds";
  EXPECT_TRUE(report.sound("general.mics[0].mu"));
  EXPECT_TRUE(report.sound("general.mic"));
  EXPECT_TRUE(report.sound("ssl.nPots")) << "a warning breaks nothing";
}

TEST(Checks, do_not_add_to_a_fault_what_only_follows_from_it) {
  // The number of channels is not known: nothing can be said of the map.
  const auto loaded = read_configuration_text(
      R"(raw: { fS = 16000; nChannels = "two"; };
mapping: { map = (1, 2); };
general: { mics = ( { mu = (0.1, 0, 0); }, { mu = (0, 0, 0); } ); };)",
      "x.cfg");
  EXPECT_EQ(loaded.faults.size(), 1U) << test::all_of(loaded.faults);
}

TEST(Checks, want_only_what_somebody_listens_to) {
  Configuration config;
  config.separated.interface.type = "file";
  EXPECT_TRUE(wanted_of(config).separated);
  EXPECT_FALSE(wanted_of(config).postfiltered);
  EXPECT_FALSE(wanted_of(config).potentials);
}

}  // namespace
}  // namespace odas::checks_test
