// SPDX-License-Identifier: MIT
#include "odas/base/error.hpp"

#include <gtest/gtest.h>

namespace odas::error_test {
namespace {

TEST(Fault, Reads_as_compilers_say_it) {
  EXPECT_EQ(to_string({Fault::Severity::error, "ssl.nPots", "is 0; allowed is 1 to 64", "my.cfg", 12}),
            "my.cfg:12: error: ssl.nPots: is 0; allowed is 1 to 64");
  EXPECT_EQ(to_string({Fault::Severity::warning, "", "nothing to hear", "", 0}), "warning: nothing to hear");
}

TEST(ConfigError, Carries_and_says_every_fault) {
  const ConfigError error(
      {{Fault::Severity::error, "a", "first", "", 0}, {Fault::Severity::error, "b", "second", "", 0}});
  EXPECT_EQ(error.faults().size(), 2U);
  EXPECT_STREQ(error.what(), "error: a: first\nerror: b: second");
}

}  // namespace
}  // namespace odas::error_test
