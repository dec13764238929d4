// SPDX-License-Identifier: MIT
#include "odas/studio/config_commands.hpp"

#include "support/studio_parts.hpp"
#include <gtest/gtest.h>

#include "odas/studio/engine_host.hpp"

namespace odas {
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
  EXPECT_FALSE(rpc.call("arrays.list", {}, Role::viewer).empty());
}

}  // namespace
}  // namespace odas
