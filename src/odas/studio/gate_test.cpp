// SPDX-License-Identifier: MIT
#include "odas/studio/gate.hpp"

#include <gtest/gtest.h>

namespace odas::gate_test {
namespace {

int status(const Gate& gate, const Visitor& visitor) { return gate.judge(visitor).status; }

TEST(Gate, lets_everybody_in_who_comes_by_an_address_where_no_token_is_set) {
  const Gate gate({}, {"robot.local"}, false);
  for (const char* host :
       {"127.0.0.1:8080", "localhost:8080", "[::1]:8080", "192.0.2.7", "Robot.local:8080"}) {
    EXPECT_EQ(status(gate, {.host = host}), 200) << host;
  }
  for (const char* host : {"", "evil.example", "127.0.0.1.evil.example:8080", "robot.local.evil.example"}) {
    EXPECT_EQ(status(gate, {.host = host}), 403) << host;
  }
}

TEST(Gate, refuses_requests_of_other_pages) {
  const Gate gate({}, {}, false);
  EXPECT_EQ(status(gate, {.host = "localhost:8080", .origin = "http://localhost:8080"}), 200);
  EXPECT_EQ(status(gate, {.host = "localhost:8080", .origin = "http://localhost:9090"}), 403);
  EXPECT_EQ(status(gate, {.host = "localhost:8080", .origin = "https://localhost:8080"}), 403);
  EXPECT_EQ(status(Gate({}, {}, true), {.host = "localhost:8080", .origin = "https://localhost:8080"}), 200);
}

TEST(Gate, knows_the_tokens_wherever_they_are) {
  const Gate gate({"secret", "looker"}, {}, false);
  EXPECT_EQ(status(gate, {.host = "localhost"}), 401);
  EXPECT_EQ(gate.judge({.host = "localhost", .query = "a=1&token=secret"}).role, Role::operator_);
  EXPECT_EQ(gate.judge({.host = "localhost", .authorization = "Bearer looker"}).role, Role::viewer);
  EXPECT_EQ(gate.judge({.host = "localhost", .cookie = "a=b; odas_token=secret"}).role, Role::operator_);
  for (const char* wrong : {"", "s", "secre", "secrett", "Secret", "lookersecret"}) {
    EXPECT_EQ(gate.role_of(wrong), std::nullopt) << wrong;
  }
  EXPECT_EQ(Gate({"secret", ""}, {}, false).role_of(""), std::nullopt) << "no viewers, no empty token";
}

TEST(Gate, reads_queries_as_browsers_write_them) {
  EXPECT_EQ(query_value("a=1&b=x%20y+z", "b"), "x y z");
  EXPECT_EQ(query_value("a=1", "b"), std::nullopt);
  EXPECT_EQ(query_value("token", "token"), "");
  EXPECT_EQ(percent_decoded("%41%zz"), std::nullopt);
  EXPECT_EQ(percent_decoded("%00"), std::nullopt);
  EXPECT_EQ(percent_decoded("a%2"), std::nullopt);
  EXPECT_EQ(query_items("name=a&name=b").count("name"), 2U);
}

TEST(Gate, makes_tokens_that_differ) {
  EXPECT_EQ(random_token().size(), 32U);
  EXPECT_NE(random_token(), random_token());
}

}  // namespace
}  // namespace odas::gate_test
