// SPDX-License-Identifier: MIT
#include "odas/io/registry.hpp"

#include "support/fake_io.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas {
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

TEST(Registry, says_of_all_outputs_at_once_what_is_not_there_yet) {
  Configuration config = test::small_configuration();
  config.tracked.format = "json";
  config.tracked.interface.type = "socket";
  config.separated.interface.type = "socket";
  config.category.interface.type = "terminal";
  const auto faults = faults_of(config);
  ASSERT_EQ(faults.size(), 3U);
  EXPECT_EQ(faults[0].path, "sst.tracked.interface.type");
  EXPECT_NE(faults[0].what.find("is \"socket\", which this version cannot do yet"), std::string::npos);
  EXPECT_EQ(faults[2].path, "classify.category.interface.type");
}

TEST(Registry, refuses_a_format_that_a_stream_cannot_be) {
  Configuration config = test::small_configuration();
  config.tracked.format = "binary";
  config.tracked.interface.type = "terminal";
  ASSERT_EQ(faults_of(config).size(), 1U);
  EXPECT_EQ(faults_of(config)[0].path, "sst.tracked.format");
}

}  // namespace
}  // namespace odas
