// SPDX-License-Identifier: MIT
#include "odas/io/device_list.hpp"

#include <cstdlib>

#include <gtest/gtest.h>

namespace odas {
namespace {

// With devices it is tested in tests/capture_test.cpp.
TEST(DeviceList, says_why_there_is_nothing) {
  ::setenv("PULSE_SERVER", "unix:/no/such/socket", 1);
  const DeviceList list = list_devices();
  std::string notes;
  for (const std::string& note : list.notes) notes += note + "\n";
  EXPECT_NE(notes.find("PulseAudio"), std::string::npos) << notes;
  EXPECT_EQ(list.devices.empty(), notes.find("no microphone is there") != std::string::npos) << notes;
}

TEST(DeviceList, asks_for_one_that_is_not_there) {
  EXPECT_NE(ask_device("hw:CARD=NoSuchCard,DEV=0").problem, "");
}

}  // namespace
}  // namespace odas
