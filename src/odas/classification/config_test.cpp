// SPDX-License-Identifier: MIT
#include "odas/classification/config.hpp"

#include "support/schema_check.hpp"
#include <gtest/gtest.h>

namespace odas::config_test {
namespace {

TEST(ClassifyConfigTest, Has_a_sound_schema_and_defaults_within_it) {
  test::expect_sound_defaults<ClassifyConfig>();
}

}  // namespace
}  // namespace odas::config_test
