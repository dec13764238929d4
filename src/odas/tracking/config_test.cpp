// SPDX-License-Identifier: MIT
#include "odas/tracking/config.hpp"

#include "support/schema_check.hpp"
#include <gtest/gtest.h>

namespace odas::config_test {
namespace {

TEST(SstConfigTest, Has_a_sound_schema_and_defaults_within_it) {
  test::expect_sound_defaults<SstConfig>();
  test::expect_sound_defaults<GaussianConfig>();
  test::expect_sound_defaults<TargetConfig>();
}

}  // namespace
}  // namespace odas::config_test
