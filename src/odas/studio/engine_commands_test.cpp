// SPDX-License-Identifier: MIT
#include "odas/studio/engine_commands.hpp"

#include "support/studio_parts.hpp"
#include <gtest/gtest.h>

#include "odas/studio/engine_host.hpp"

namespace odas::engine_commands_test {
namespace {

TEST(EngineCommands, write_targets_and_faults_as_the_protocol_has_them) {
  TargetInbox::Orders orders;
  orders.targets.assign(std::vector<Target>{{"door", {0, 1, 0}}});
  orders.muted.assign(std::vector<Target>{{"fan", {1, 0, 0}}});
  const nlohmann::json targets = targets_json(orders);
  ASSERT_EQ(targets.size(), 2U);
  EXPECT_EQ(targets[0].at("tag"), "door");
  EXPECT_EQ(targets[0].at("mute"), false);
  EXPECT_EQ(targets[1].at("mute"), true);
  const RpcError error = invalid(ConfigError("sst.N_prob", "is too small"));
  EXPECT_EQ(error.code(), "invalid");
  EXPECT_EQ(error.data().at("faults").at(0).at("path"), "sst.N_prob");
}

TEST(EngineCommands, are_for_operators_where_they_change_something) {
  test::HeardMessages heard;
  LogBook log("", heard);
  EngineHost host({}, heard, log, {});
  RpcRegistry rpc;
  add_engine_methods(rpc, host, heard);
  for (const char* method : {"engine.start", "engine.stop", "config.apply", "config.revert", "config.save",
                             "targets.set", "engine.open"}) {
    try {
      static_cast<void>(rpc.call(method, nlohmann::json::object(), Role::viewer));
      ADD_FAILURE() << method;
    } catch (const RpcError& error) { EXPECT_EQ(error.code(), "forbidden") << method; }
  }
}

}  // namespace
}  // namespace odas::engine_commands_test
