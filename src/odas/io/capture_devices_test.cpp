// SPDX-License-Identifier: MIT
#include "odas/io/capture_devices.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace odas::capture_devices_test {
namespace {

std::vector<CaptureDevice> three() {
  CaptureDevice card{"ALSA", "hw:CARD=Array,DEV=0", "ReSpeaker 4 Mic Array\nUSB Audio", "", {}, false};
  card.offer = {{SampleFormat::s16}, {}, 6, 6, {}, 16000, 16000, {16000}};
  CaptureDevice busy{"ALSA", "hw:CARD=PCH,DEV=0", "HDA Intel", "arecord (process 7) captures from it", {},
                     false};
  CaptureDevice source{"PulseAudio", "alsa_output.monitor", "Monitor", "", card.offer, true};
  return {card, busy, source};
}

TEST(CaptureDevices, are_told_with_the_section_to_paste) {
  EXPECT_EQ(describe_devices(three()),
            "ALSA\n"
            "  hw:CARD=Array,DEV=0\n"
            "      ReSpeaker 4 Mic Array\n"
            "      USB Audio\n"
            "      channels 6; 16000 Hz; S16_LE\n"
            "          raw: {\n"
            "            fS = 16000;\n"
            "            nBits = 16;\n"
            "            nChannels = 6;\n"
            "            interface: { type = \"soundcard_name\"; devicename = \"hw:CARD=Array,DEV=0\"; };\n"
            "          };\n"
            "  hw:CARD=PCH,DEV=0\n"
            "      HDA Intel\n"
            "      arecord (process 7) captures from it\n"
            "\n"
            "PulseAudio\n"
            "  alsa_output.monitor\n"
            "      Monitor\n"
            "      channels 6; 16000 Hz; S16_LE\n"
            "      plays what a loudspeaker plays: it is no microphone\n");
}

TEST(CaptureDevices, are_JSON_for_programs) {
  std::vector<CaptureDevice> devices = three();
  devices[1].description = "\xFF no UTF-8";
  const auto json = nlohmann::json::parse(devices_json(devices));
  ASSERT_EQ(json.size(), 3U);
  EXPECT_EQ(json[0]["name"], "hw:CARD=Array,DEV=0");
  EXPECT_EQ(json[0]["channels"]["max"], 6);
  EXPECT_EQ(json[0]["rate"]["usual"], std::vector<int>{16000});
  EXPECT_EQ(json[0]["formats"], std::vector<std::string>{"S16_LE"});
  EXPECT_TRUE(json[0]["raw"].get<std::string>().starts_with("raw: {"));
  EXPECT_EQ(json[1]["problem"], "arecord (process 7) captures from it");
  EXPECT_FALSE(json[1].contains("channels"));
  EXPECT_EQ(json[2]["microphone"], false);
  EXPECT_EQ(nlohmann::json::parse(devices_json({})).size(), 0U);
}

}  // namespace
}  // namespace odas::capture_devices_test
