// SPDX-License-Identifier: MIT
#include "odas/studio/config_commands.hpp"

#include "support/studio_parts.hpp"
#include <gtest/gtest.h>

#include "odas/studio/engine_host.hpp"

namespace odas::config_commands_test {
namespace {

TEST(ConfigCommands, check_and_list) {
  test::HeardMessages heard;
  LogBook log("", heard);
  EngineHost host({}, heard, log, {});
  RpcRegistry rpc;
  add_config_methods(rpc, host);
  const std::string text = test::sample_document().text;
  EXPECT_TRUE(rpc.call("config.check", {{"text", text}}, Role::viewer).contains("plan"));
  const auto bad = rpc.call("config.check", {{"text", "raw: { fS = 5; };"}}, Role::viewer);
  EXPECT_FALSE(bad.at("faults").empty());
  EXPECT_FALSE(rpc.call("config.form", {{"text", text}}, Role::viewer).at("sections").empty());
  EXPECT_THROW(static_cast<void>(rpc.call("config.form", {{"text", "raw: {"}}, Role::viewer)), RpcError);
  const auto edited = rpc.call(
      "config.edit", {{"text", text}, {"changes", {{{"path", "sst.N_prob"}, {"value", 7}}}}}, Role::viewer);
  EXPECT_NE(edited.at("text").get<std::string>().find("N_prob = 7;"), std::string::npos);
  EXPECT_TRUE(edited.at("faults").empty());
  EXPECT_EQ(rpc.call("array.check", {{"text", text}}, Role::viewer).at("pairs"), 6);
  EXPECT_TRUE(rpc.call("devices.list", {}, Role::viewer).is_array());
  EXPECT_FALSE(rpc.call("arrays.list", {}, Role::viewer).empty());
}

}  // namespace
}  // namespace odas::config_commands_test
