// SPDX-License-Identifier: MIT
#include "support/server_test.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::http_server_test {
namespace {

using test::http_get;
using test::ServerTest;

TEST_F(ServerTest, makes_a_token_where_a_network_can_come) {
  StudioConfig config = any_port();
  config.ip = "0.0.0.0";
  const StudioServer& open = serve(config);
  EXPECT_NE(open.url().find("?token="), std::string::npos);
  EXPECT_EQ(http_get(open.port(), "/").status, 401);
}

TEST(StudioServer, says_why_it_cannot_listen) {
  RpcRegistry rpc;
  StudioConfig config;
  config.port = 0;
  const StudioServer first(config, rpc, {}, {});
  config.port = first.port();
  try {
    const StudioServer second(config, rpc, {}, {});
    ADD_FAILURE() << "two at one port";
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find("another program is there"), std::string::npos) << error.what();
  }
  config.port = 0;
  config.certificate = config.key = "/nowhere.pem";
  EXPECT_THROW(StudioServer(config, rpc, {}, {}), ConfigError);
}

}  // namespace
}  // namespace odas::http_server_test
