// SPDX-License-Identifier: MIT
#include "odas/io/device_list.hpp"

#include <cstdlib>

#include "support/scratch.hpp"
#include <gtest/gtest.h>

namespace odas::device_list_test {
namespace {

// With devices it is tested in tests/capture_test.cpp.
TEST(DeviceList, says_why_there_is_nothing) {
  const test::Scratch scratch;
  test::write_file(scratch / "asound.conf", "pcm.null { type null }\n");
  ::setenv("ALSA_CONFIG_PATH", (scratch / "asound.conf").c_str(), 1);
  ::setenv("PULSE_SERVER", "unix:/no/such/socket", 1);
  const DeviceList list = list_devices();
  ::unsetenv("ALSA_CONFIG_PATH");
  std::string notes;
  for (const std::string& note : list.notes) notes += note + "\n";
  EXPECT_NE(notes.find("PulseAudio"), std::string::npos) << notes;
  EXPECT_EQ(list.devices.empty(), notes.find("no microphone is there") != std::string::npos) << notes;
}

TEST(DeviceList, asks_for_one_that_is_not_there) {
  EXPECT_NE(ask_device("hw:CARD=NoSuchCard,DEV=0").problem, "");
}

}  // namespace
}  // namespace odas::device_list_test
