// SPDX-License-Identifier: MIT
#include "odas/studio/config_values.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace odas::config_values_test {
namespace {

TEST(ConfigValues, are_those_of_the_configuration_by_its_keys) {
  Configuration config;
  config.raw.fs = 48000;
  config.studio.camera.fx = 321;
  const nlohmann::json values = values_of(config);
  EXPECT_EQ(values.at("raw").at("fS"), 48000);
  EXPECT_EQ(values.at("studio").at("camera").at("fx"), 321);
  EXPECT_EQ(values.at("general").at("mics").size(), config.pipeline.general.mics.size());
}

}  // namespace
}  // namespace odas::config_values_test
