// SPDX-License-Identifier: MIT
#include "odas/studio/studio.hpp"

#include "support/scratch.hpp"
#include "support/web_client.hpp"
#include <gtest/gtest.h>

namespace odas::studio_test {
namespace {

TEST(Studio, serves_its_page_with_nothing_configured) {
  const test::Scratch scratch;
  StudioOptions options;
  options.config.port = 0;
  options.config.recordings = scratch.folder();
  options.program = "";
  const Studio studio(options);
  EXPECT_EQ(test::http_get(studio.port(), "/").status, 200);
  EXPECT_NE(test::http_get(studio.port(), "/api/v1/info").body.find("\"run\":null"), std::string::npos);
  EXPECT_FALSE(studio.end());
}

}  // namespace
}  // namespace odas::studio_test
