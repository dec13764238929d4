// SPDX-License-Identifier: MIT
#include "odas/separation/config.hpp"

#include "support/schema_check.hpp"
#include <gtest/gtest.h>

namespace odas::config_test {
namespace {

TEST(SssConfigTest, Has_a_sound_schema_and_defaults_within_it) { test::expect_sound_defaults<SssConfig>(); }

}  // namespace
}  // namespace odas::config_test
