// SPDX-License-Identifier: MIT
#include "odas/studio/effect.hpp"

#include <gtest/gtest.h>

namespace odas::effect_test {
namespace {

TEST(Effect, is_as_gentle_as_can_be) {
  const Configuration before;
  EXPECT_EQ(effect_of(before, before, true), Effect::none);
  Configuration after = before;
  after.pipeline.sst.theta_new += 0.01F;
  EXPECT_EQ(effect_of(before, after, true), Effect::live);
  EXPECT_EQ(effect_of(before, after, false), Effect::restart);
  after.raw.fs += 1000;
  EXPECT_EQ(effect_of(before, after, true), Effect::reopen);
}

TEST(Effect, has_the_names_of_the_protocol) {
  EXPECT_STREQ(name_of(Effect::none), "none");
  EXPECT_STREQ(name_of(Effect::live), "live");
  EXPECT_STREQ(name_of(Effect::restart), "restart");
  EXPECT_STREQ(name_of(Effect::reopen), "reopen");
}

}  // namespace
}  // namespace odas::effect_test
