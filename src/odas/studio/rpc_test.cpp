// SPDX-License-Identifier: MIT
#include "odas/studio/rpc.hpp"

#include <gtest/gtest.h>

namespace odas::rpc_test {
namespace {

using nlohmann::json;

RpcRegistry some_methods() {
  RpcRegistry rpc;
  rpc.add("double", Role::viewer, "twice a number", [](const json& p) { return 2 * p.at("n").get<int>(); });
  rpc.add("stop", Role::operator_, "stops", [](const json&) { return json::object(); });
  rpc.add("break", Role::viewer, "breaks", [](const json&) -> json { throw std::runtime_error("broken"); });
  return rpc;
}

std::string code_of(const std::string& method, const json& params, Role role) {
  try {
    static_cast<void>(some_methods().call(method, params, role));
  } catch (const RpcError& error) { return error.code(); }
  return "";
}

TEST(RpcRegistry, gives_the_result_of_the_method) {
  EXPECT_EQ(some_methods().call("double", {{"n", 21}}, Role::viewer), 42);
}

TEST(RpcRegistry, says_what_is_wrong_with_a_call) {
  EXPECT_EQ(code_of("doubel", {}, Role::operator_), "unknown_method");
  EXPECT_EQ(code_of("double", json::object(), Role::viewer), "bad_request");
  EXPECT_EQ(code_of("double", {{"n", "x"}}, Role::viewer), "bad_request");
  EXPECT_EQ(code_of("double", nullptr, Role::viewer), "bad_request");
  EXPECT_EQ(code_of("break", {}, Role::viewer), "failed");
}

TEST(RpcRegistry, lets_a_viewer_change_nothing) {
  EXPECT_EQ(code_of("stop", {}, Role::viewer), "forbidden");
  EXPECT_EQ(code_of("stop", {}, Role::operator_), "");
}

TEST(RpcRegistry, lists_its_methods) {
  const json all = some_methods().call("methods", {}, Role::viewer);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[2], (json{{"name", "stop"}, {"operator", true}, {"meaning", "stops"}}));
}

}  // namespace
}  // namespace odas::rpc_test
