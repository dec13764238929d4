// SPDX-License-Identifier: MIT
#include "odas/config/defaults.hpp"

#include "support/config_faults.hpp"

namespace odas::defaults_test {
namespace {

TEST(Defaults, of_outputs_are_the_rate_and_hop_of_the_processing) {
  const auto loaded = test::read_changed(
      "general: {", "general: { size: { hopSize = 64; frameSize = 512; }; samplerate: { mu = 8000; };");
  ASSERT_TRUE(test::clean(loaded));
  EXPECT_EQ(loaded.config.separated.fs, 8000);
  EXPECT_EQ(loaded.config.postfiltered.fs, 8000);
  EXPECT_EQ(loaded.config.separated.hop_size, 64);
  EXPECT_EQ(loaded.config.raw.hop_size, 64);
  EXPECT_EQ(loaded.config.pipeline.sss.ms.win_size_frame, 512);
}

TEST(Defaults, give_way_to_what_is_written) {
  const auto loaded = test::read_with("sss: { separated: { fS = 44100; hopSize = 512; }; };");
  ASSERT_TRUE(test::clean(loaded));
  EXPECT_EQ(loaded.config.separated.fs, 44100);
  EXPECT_EQ(loaded.config.separated.hop_size, 512);
  EXPECT_EQ(loaded.config.postfiltered.fs, 16000);
}

TEST(Defaults, name_only_keys_that_are_there) {
  // A wrong path in a schema would leave the default as it is: change all sources and see all change.
  Configuration config;
  config.pipeline.general.size = {77, 1234};
  config.pipeline.general.samplerate.mu = 12345;
  set_derived_defaults(config, Locations{});
  EXPECT_EQ(config.raw.hop_size, 77);
  EXPECT_EQ(config.separated.hop_size, 77);
  EXPECT_EQ(config.postfiltered.hop_size, 77);
  EXPECT_EQ(config.separated.fs, 12345);
  EXPECT_EQ(config.postfiltered.fs, 12345);
  EXPECT_EQ(config.pipeline.sss.ms.win_size_frame, 1234);
}

}  // namespace
}  // namespace odas::defaults_test
