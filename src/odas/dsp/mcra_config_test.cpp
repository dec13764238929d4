// SPDX-License-Identifier: MIT
#include "odas/dsp/mcra_config.hpp"

#include "support/schema_check.hpp"
#include <gtest/gtest.h>

namespace odas::mcra_config_test {
namespace {

TEST(McraConfigTest, Has_a_sound_schema_and_defaults_within_it) { test::expect_sound_defaults<McraConfig>(); }

}  // namespace
}  // namespace odas::mcra_config_test
