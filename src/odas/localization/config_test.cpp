// SPDX-License-Identifier: MIT
#include "odas/localization/config.hpp"

#include "support/schema_check.hpp"
#include <gtest/gtest.h>

namespace odas::config_test {
namespace {

TEST(SslConfigTest, Has_a_sound_schema_and_defaults_within_it) {
  test::expect_sound_defaults<SslConfig>();
  test::expect_sound_defaults<ScanConfig>();
}

}  // namespace
}  // namespace odas::config_test
