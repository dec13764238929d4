// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "odas/base/error.hpp"
#include "odas/io/registry.hpp"

namespace odas::source_registry_test {
namespace {

TEST(SourceRegistry, says_which_sources_are_not_there) {
  RawConfig raw;
  for (const char* type : {"blackhole"}) {
    raw.interface.type = type;
    try {
      static_cast<void>(make_source(raw));
      ADD_FAILURE() << type;
    } catch (const ConfigError& error) {
      EXPECT_EQ(error.faults()[0].path, "raw.interface.type");
      EXPECT_NE(error.faults()[0].what.find(type), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace odas::source_registry_test
