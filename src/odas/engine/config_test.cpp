// SPDX-License-Identifier: MIT
#include "odas/engine/config.hpp"

#include "support/schema_check.hpp"
#include <gtest/gtest.h>

namespace odas::config_test {
namespace {

TEST(EngineConfig, Has_a_sound_schema_and_defaults_within_it) {
  test::expect_sound_defaults<MappingConfig>();
  test::expect_sound_defaults<TextOutputConfig>();
  test::expect_sound_defaults<AudioOutputConfig>();
  test::expect_sound_defaults<ControlConfig>();
}

}  // namespace
}  // namespace odas::config_test
