// SPDX-License-Identifier: MIT
#include "odas/io/pulse_source.hpp"

#include <cstdlib>

#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::pulse_source_test {
namespace {

// With a server it is tested in tests/capture_test.cpp.
TEST(PulseSource, says_that_there_is_no_server) {
  ::setenv("PULSE_SERVER", "unix:/no/such/socket", 1);
  RawConfig raw;
  raw.n_channels = 8;
  raw.interface.source = "mic";
  try {
    const PulseSource source(raw);
    ADD_FAILURE() << "it has heard something";
  } catch (const IoError& error) {
    EXPECT_STREQ(
        error.what(),
        "cannot open the source mic of PulseAudio: Connection refused; does a server run for this user? "
        "pactl info says");
  }
}

TEST(PulseSource, has_no_more_channels_than_the_server_can_have) {
  RawConfig raw;
  raw.n_channels = 33;
  EXPECT_THROW(const PulseSource source(raw), ConfigError);
}

}  // namespace
}  // namespace odas::pulse_source_test
