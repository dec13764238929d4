// SPDX-License-Identifier: MIT
#include "odas/io/registry.hpp"

#include "support/fake_io.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::registry_test {
namespace {

std::vector<Fault> faults_of(const Configuration& config) {
  try {
    static_cast<void>(make_sinks(config));
    return {};
  } catch (const ConfigError& error) { return error.faults(); }
}

TEST(Registry, makes_no_sink_for_a_blackhole) {
  EXPECT_TRUE(make_sinks(test::small_configuration()).empty());
}

TEST(Registry, makes_a_sink_for_each_output_that_somebody_listens_to) {
  const test::Scratch scratch;
  Configuration config = test::small_configuration();
  const auto to = [&](InterfaceConfig& interface, const char* name) {
    interface.type = "file";
    interface.path = scratch / name;
  };
  config.potential.format = "binary";
  to(config.potential.interface, "pots.bin");
  config.tracked.format = "jsonl";
  to(config.tracked.interface, "tracks.jsonl");
  to(config.separated.interface, "sep.raw");
  to(config.postfiltered.interface, "pf.wav");
  const auto sinks = make_sinks(config);
  ASSERT_EQ(sinks.size(), 4U);
  EXPECT_TRUE(sinks[0]->name().starts_with("ssl.potential"));
  EXPECT_TRUE(sinks[1]->name().starts_with("sst.tracked"));
  EXPECT_TRUE(sinks[2]->name().starts_with("sss.separated"));
  EXPECT_TRUE(sinks[3]->name().starts_with("sss.postfiltered"));
  EXPECT_EQ(test::content(scratch / "pf.wav").substr(0, 4), "RIFF");
  EXPECT_EQ(test::content(scratch / "sep.raw"), "") << "raw has no header";
}

TEST(Registry, makes_a_sink_for_each_place_of_a_stream) {
  const test::Scratch scratch;
  Configuration config = test::small_configuration();
  config.tracked.format = "json";
  config.tracked.interfaces.resize(3);
  config.tracked.interfaces[0].type = "socket";
  config.tracked.interfaces[0].ip = "127.0.0.1";
  config.tracked.interfaces[0].port = 9;
  config.tracked.interfaces[1].type = "file";
  config.tracked.interfaces[1].path = scratch / "tracks.jsonl";
  config.tracked.interfaces[1].format = "jsonl";
  config.tracked.interfaces[2].type = "socket_listen";
  config.category.format = "json";
  config.category.interface.type = "terminal";
  config.separated.interface.type = "voices";
  config.separated.interface.path = scratch / "voices";
  const auto sinks = make_sinks(config);
  ASSERT_EQ(sinks.size(), 5U);
  EXPECT_EQ(sinks[0]->name(), "sst.tracked (127.0.0.1:9)");
  EXPECT_TRUE(sinks[1]->name().ends_with("tracks.jsonl)"));
  EXPECT_TRUE(sinks[2]->name().starts_with("sst.tracked (127.0.0.1:"));
  EXPECT_EQ(sinks[3]->name(), "classify.category (standard output)");
  EXPECT_TRUE(sinks[4]->name().ends_with("voices)"));
}

TEST(Registry, opens_nothing_where_one_of_them_is_wrong) {
  const test::Scratch scratch;
  Configuration config = test::small_configuration();
  config.potential.format = "json";
  config.potential.interface.type = "file";
  config.potential.interface.path = scratch / "pots.json";
  config.tracked.interface.type = "file";
  config.category.interface.type = "soundcard";
  const auto faults = faults_of(config);
  ASSERT_EQ(faults.size(), 2U);
  EXPECT_EQ(faults[0].path, "sst.tracked.interface");
  EXPECT_NE(faults[1].what.find("has the type \"soundcard\""), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(scratch / "pots.json"));
}

TEST(Registry, refuses_a_format_that_a_stream_cannot_be) {
  Configuration config = test::small_configuration();
  config.tracked.format = "binary";
  config.tracked.interface.type = "terminal";
  ASSERT_EQ(faults_of(config).size(), 1U);
  EXPECT_EQ(faults_of(config)[0].path, "sst.tracked.interface");
}

}  // namespace
}  // namespace odas::registry_test
