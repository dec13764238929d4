// SPDX-License-Identifier: MIT
#include "odas/studio/web_policy.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "odas/studio/own_address.hpp"

namespace odas::web_policy_test {
namespace {

StudioConfig at(const std::string& ip) {
  StudioConfig config;
  config.ip = ip;
  return config;
}

TEST(WebPolicy, wants_a_token_where_a_network_can_reach_it) {
  EXPECT_EQ(operator_token(at("127.0.0.1")), "");
  EXPECT_GE(operator_token(at("0.0.0.0")).size(), 16U);
  EXPECT_NE(operator_token(at("0.0.0.0")), operator_token(at("0.0.0.0")));
  StudioConfig config = at("0.0.0.0");
  config.token = "of-my-own";
  EXPECT_EQ(operator_token(config), "of-my-own");
}

TEST(WebPolicy, links_to_an_address_that_another_machine_can_go_to) {
  EXPECT_EQ(link_host(at("")), "127.0.0.1");
  EXPECT_EQ(link_host(at("192.0.2.7")), "192.0.2.7");
  EXPECT_EQ(link_host(at("::1")), "[::1]");
  for (const char* all : {"0.0.0.0", "::"}) {
    EXPECT_EQ(link_host(at(all)), own_address().empty() ? "127.0.0.1" : own_address());
  }
}

TEST(WebPolicy, knows_its_names) {
  StudioConfig config = at("192.0.2.7");
  config.hosts = {"robot.example"};
  const auto names = server_names(config);
  for (const char* name : {"robot.example", "192.0.2.7"}) {
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  }
}

TEST(WebPolicy, lets_pictures_come_from_the_camera_and_nothing_else_from_elsewhere) {
  StudioConfig config = at("");
  EXPECT_EQ(content_policy(config).find("http"), std::string::npos);
  config.camera.url = "http://camera:8081/?action=stream";
  const std::string policy = content_policy(config);
  EXPECT_NE(policy.find("img-src 'self' data: blob: http://camera:8081;"), std::string::npos) << policy;
  EXPECT_EQ(policy.find("http", policy.find("http://camera") + 1), std::string::npos) << policy;
  config.camera.url = "http://camera; script-src *";
  EXPECT_EQ(content_policy(config).find("script-src *"), std::string::npos);
}

}  // namespace
}  // namespace odas::web_policy_test
