// SPDX-License-Identifier: MIT
#include "odas/array/config.hpp"

#include "support/schema_check.hpp"
#include <gtest/gtest.h>

namespace odas::config_test {
namespace {

TEST(ArrayConfig, Has_a_sound_schema_and_defaults_within_it) {
  test::expect_sound_defaults<GeneralConfig>();
  test::expect_sound_defaults<MicConfig>();
  test::expect_sound_defaults<SpatialFilterConfig>();
}

}  // namespace
}  // namespace odas::config_test
