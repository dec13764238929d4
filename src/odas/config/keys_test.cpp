// SPDX-License-Identifier: MIT
#include "odas/config/keys.hpp"

#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

namespace odas::keys_test {
namespace {

TEST(Keys, are_described_with_default_range_and_meaning) {
  const std::string text = key_reference();
  EXPECT_NE(text.find("| `raw.fS` | **required** | 1000 to 384000 Hz | sample rate of the microphones |"),
            std::string::npos);
  EXPECT_NE(text.find("| `sss.separated.fS` | that of `general.samplerate.mu` |"), std::string::npos);
  EXPECT_NE(text.find("| `general.samplerate.sigma2` | ignored |"), std::string::npos);
  EXPECT_NE(text.find("| `ssl.scans` | `({ level = 2; delta = -1; }, { level = 4; delta = -1; })` |"),
            std::string::npos);
  EXPECT_NE(text.find("| `sst.mode` | `\"kalman\"` | \"kalman\", \"particle\" or \"bernoulli\" |"),
            std::string::npos);
}

TEST(Keys, know_their_home) {
  EXPECT_EQ(home_of_key("nPots"), "ssl.nPots");
  EXPECT_EQ(home_of_key("gainMin"), "general.gainMin");
  EXPECT_EQ(home_of_key("mu"), "") << "many keys have this name";
  EXPECT_EQ(home_of_key("colour"), "");
}

/// `odas check --keys` writes what belongs between the markers.
TEST(Keys, stand_in_the_documentation_as_the_schema_has_them) {
  std::ifstream file(ODAS_SOURCE_DIR "/docs/configuration.md");
  ASSERT_TRUE(file) << "docs/configuration.md is not there";
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  const std::string begin = "<!-- keys: odas check --keys -->\n";
  const std::string end = "<!-- end of keys -->\n";
  const std::size_t from = page.find(begin);
  const std::size_t to = page.find(end);
  ASSERT_NE(from, std::string::npos);
  ASSERT_NE(to, std::string::npos);
  EXPECT_EQ(page.substr(from + begin.size(), to - from - begin.size()), key_reference())
      << "write the output of `odas check --keys` between the markers";
}

}  // namespace
}  // namespace odas::keys_test
