// SPDX-License-Identifier: MIT
#include "odas/studio/odas_view.hpp"

#include "support/kept_hops.hpp"
#include "support/net_peer.hpp"
#include "support/studio_parts.hpp"
#include <gtest/gtest.h>

namespace odas::odas_view_test {
namespace {

TEST(OdasSender, is_as_its_configuration_says) {
  Configuration config;
  config.pipeline.general.samplerate.mu = 44100;
  config.pipeline.general.size.hop_size = 256;
  config.pipeline.general.mics.resize(7);
  config.separated.fs = 16000;
  config.separated.n_bits = 24;
  config.tracked.interface.type = "socket";
  config.tracked.interface.port = 9500;
  config.potential.interface.type = "file";
  config.potential.interface.port = 9501;
  const OdasSender sender = odas_sender(config, "seven");
  EXPECT_EQ(sender.name, "seven");
  EXPECT_EQ(sender.mics.size(), 7U);
  EXPECT_EQ(sender.intake.rate, 44100);
  EXPECT_EQ(sender.intake.hop, 256);
  EXPECT_EQ(sender.intake.sound_rate, 16000);
  EXPECT_EQ(sender.intake.bits, 24);
  EXPECT_EQ(sender.intake.tracked, 9500);
  EXPECT_EQ(sender.intake.potential, 9001) << "it dials nobody there";
  EXPECT_EQ(sender.intake.postfiltered, 10010);
}

TEST(OdasView, shows_who_comes_with_the_microphones_that_are_known_and_says_when_he_goes) {
  test::HeardMessages heard;
  LogBook log("", heard);
  test::KeptHops kept;
  OdasSender sender;
  sender.name = "pepper";
  sender.mics.resize(4);
  OdasIntakeConfig& ports = sender.intake;
  ports.tracked = ports.potential = ports.separated = ports.postfiltered = 0;
  const OdasView view(sender, {&kept}, heard, log);
  const auto states = [&] {
    std::string all;
    for (const auto& message : heard.messages()) {
      if (message.at("type") == "engine") all += message.at("state").get<std::string>() + " ";
    }
    return all;
  };
  EXPECT_EQ(states(), "waiting ");
  test::NetPeer odas = test::NetPeer::dial(view.intake().port("tracked"));
  for (int t = 1; t <= 3; ++t) {
    odas.send("{\n    \"timeStamp\": " + std::to_string(t) +
              ",\n    \"src\": [\n        { \"id\": 5, \"tag\": \"dynamic\", \"x\": 1.000, \"y\": 0.000, "
              "\"z\": 0.000, "
              "\"activity\": 0.900 }\n    ]\n}\n");
  }
  odas.close();
  ASSERT_TRUE(test::eventually([&] { return states() == "waiting running waiting "; })) << states();
  EXPECT_EQ(kept.infos().at(0).name, "pepper");
  EXPECT_EQ(kept.infos().at(0).mics.size(), 4U);
  EXPECT_EQ(kept.count(), 3U);
}

}  // namespace
}  // namespace odas::odas_view_test
