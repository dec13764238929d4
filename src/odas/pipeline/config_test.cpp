// SPDX-License-Identifier: MIT
#include "odas/pipeline/config.hpp"

#include <gtest/gtest.h>

namespace odas::config_test {
namespace {

TEST(PipelineConfigTest, counts_the_look_back_in_whole_hops) {
  PipelineConfig config;
  EXPECT_EQ(lookback_hops(config), 0U) << "as ODAS, where the file says nothing";
  config.sss.lookback = 300;
  EXPECT_EQ(lookback_hops(config), 38U) << "304 ms in hops of 8";
  config.general.size = {512, 1024};
  EXPECT_EQ(lookback_hops(config), 9U);
}

TEST(PipelineConfigTest, delays_the_voices_by_the_overlap_and_the_look_back) {
  PipelineConfig config;
  EXPECT_DOUBLE_EQ(voice_delay_s(config), 0.008);
  config.sss.lookback = 100;
  EXPECT_DOUBLE_EQ(voice_delay_s(config), 0.008 + 0.104);
}

}  // namespace
}  // namespace odas::config_test
