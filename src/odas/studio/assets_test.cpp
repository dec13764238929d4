// SPDX-License-Identifier: MIT
#include "odas/studio/assets.hpp"

#include <algorithm>

#include "support/scratch.hpp"
#include <gtest/gtest.h>

namespace odas::assets_test {
namespace {

TEST(Assets, are_the_files_of_the_page) {
  const Asset* page = find_asset("/");
  ASSERT_NE(page, nullptr);
  EXPECT_EQ(page, find_asset("/index.html"));
  EXPECT_EQ(page->bytes, test::content(std::string(ODAS_SOURCE_DIR) + "/web/dist/index.html"));
  for (const Asset& asset : assets()) {
    EXPECT_EQ(asset.gzip.substr(0, 2), "\x1F\x8B") << asset.path;
    EXPECT_FALSE(asset.type.empty() || asset.etag.empty()) << asset.path;
  }
}

TEST(Assets, are_nothing_else) {
  for (const char* path : {"", "/nothing", "index.html", "/../package.json", "/INDEX.HTML"}) {
    EXPECT_EQ(find_asset(path), nullptr) << path;
  }
}

TEST(Assets, weigh_little_enough_for_a_phone) {
  std::size_t bytes = 0;
  for (const Asset& asset : assets()) bytes += asset.gzip.size();
  EXPECT_LE(bytes, 250'000U) << "gzipped, all of them";
}

}  // namespace
}  // namespace odas::assets_test
