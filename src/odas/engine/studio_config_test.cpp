// SPDX-License-Identifier: MIT
#include "odas/engine/studio_config.hpp"

#include "support/schema_check.hpp"
#include <gtest/gtest.h>

namespace odas::studio_config_test {
namespace {

TEST(StudioConfig, Has_a_sound_schema_and_defaults_within_it) {
  test::expect_sound_defaults<StudioConfig>();
  test::expect_sound_defaults<CameraConfig>();
  test::expect_sound_defaults<EventsConfig>();
  test::expect_sound_defaults<SpeechConfig>();
}

}  // namespace
}  // namespace odas::studio_config_test
