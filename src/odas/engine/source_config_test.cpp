// SPDX-License-Identifier: MIT
#include <algorithm>

#include "support/schema_check.hpp"
#include <gtest/gtest.h>

#include "odas/engine/config.hpp"

namespace odas::source_config_test {
namespace {

TEST(SourceConfig, Has_a_sound_schema_and_defaults_within_it) {
  test::expect_sound_defaults<RawConfig>();
  test::expect_sound_defaults<RecordConfig>();
  test::expect_sound_defaults<InterfaceConfig>();
}

TEST(SourceConfig, Knows_every_kind_of_source_that_ODAS_knows) {
  const Schema schema = InterfaceConfig::schema();
  const auto type =
      std::find_if(schema.begin(), schema.end(), [](const Field& f) { return f.key == "type"; });
  ASSERT_NE(type, schema.end());
  for (const char* kind : {"file", "socket", "soundcard", "soundcard_name", "pulseaudio"}) {
    EXPECT_NE(std::find(type->choices.begin(), type->choices.end(), kind), type->choices.end()) << kind;
  }
}

}  // namespace
}  // namespace odas::source_config_test
