// SPDX-License-Identifier: MIT
#include "odas/studio/config_edit.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace odas {
namespace {

TEST(ConfigEdit, writes_values_as_a_configuration_has_them) {
  const std::string text = setting_text(nlohmann::json::parse(R"({"a":[1,2],"b":true,"c":null})"));
  EXPECT_NE(text.find("a = "), std::string::npos);
  EXPECT_NE(text.find("true"), std::string::npos);
  EXPECT_EQ(text.find("c ="), std::string::npos);
}

}  // namespace
}  // namespace odas
