// SPDX-License-Identifier: MIT
#include "odas/io/alsa_devices.hpp"

#include <cerrno>
#include <cstdlib>

#include "support/scratch.hpp"
#include <gtest/gtest.h>

namespace odas::alsa_devices_test {
namespace {

class FakePcm : public AlsaPcm {
 public:
  explicit FakePcm(CaptureOffer offer) : offer_(std::move(offer)) {}
  CaptureOffer offer(std::optional<int>, std::optional<int>) override { return offer_; }
  int configure(SampleFormat, int, int, std::size_t) override { return started(); }
  int start() override { return started(); }
  int wait(int) override { return started(); }
  long read(char*, std::size_t) override { return started(); }
  long available() override { return started(); }
  int recover(int) override { return started(); }

 private:
  static int started() {
    ADD_FAILURE() << "it was only to be asked";
    return -EIO;
  }
  CaptureOffer offer_;
};

TEST(AlsaDevices, are_asked_without_being_started) {
  const CaptureOffer offer{{SampleFormat::s32}, {}, 8, 8, {}, 16000, 48000, {16000, 48000}};
  const CaptureDevice device = ask_alsa_device(
      "hw:CARD=Array,DEV=0", [&](const std::string&, int&) { return std::make_unique<FakePcm>(offer); });
  EXPECT_EQ(device.problem, "");
  EXPECT_EQ(device.offer.max_channels, 8);
  EXPECT_EQ(device.system, "ALSA");
}

TEST(AlsaDevices, say_why_they_cannot_be_asked) {
  const auto failing = [](int number) {
    return ask_alsa_device("hw:1,0", [number](const std::string&, int& error) -> std::unique_ptr<AlsaPcm> {
      error = -number;
      return nullptr;
    });
  };
  EXPECT_NE(failing(EBUSY).problem.find("another program captures from it"), std::string::npos);
  EXPECT_NE(failing(EACCES).problem.find("usermod -aG audio"), std::string::npos);
  EXPECT_NE(failing(ENOENT).problem.find("odas devices"), std::string::npos);
  const CaptureDevice none = ask_alsa_device(
      "hw:1,0", [&](const std::string&, int&) { return std::make_unique<FakePcm>(CaptureOffer()); });
  EXPECT_EQ(none.problem, "it offers nothing that odas can read");
}

TEST(AlsaDevices, name_who_holds_one) {
  EXPECT_NE(alsa_advice(-EBUSY, "hw:1,0", "arecord (process 7)").find("arecord (process 7) captures from it"),
            std::string::npos);
}

TEST(AlsaDevices, are_those_that_show_themselves_and_are_no_converters) {
  const test::Scratch scratch;
  test::write_file(scratch / "asound.conf",
                   "pcm.array8 { type null hint { show on description \"An array\" } }\n"
                   "pcm.samplerate { type null hint { show on description \"A converter\" } }\n"
                   "pcm.hidden { type null }\n");
  ::setenv("ALSA_CONFIG_PATH", (scratch / "asound.conf").c_str(), 1);
  std::string fault;
  std::vector<std::string> names;
  for (const CaptureDevice& device : list_alsa_devices(fault)) {
    EXPECT_EQ(device.system, "ALSA");
    if (device.name.starts_with("hw:")) continue;  // a card of this machine
    EXPECT_EQ(device.description, "An array");
    names.push_back(device.name);
  }
  ::unsetenv("ALSA_CONFIG_PATH");
  EXPECT_EQ(names, std::vector<std::string>{"array8"});
}

}  // namespace
}  // namespace odas::alsa_devices_test
