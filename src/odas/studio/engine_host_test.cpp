// SPDX-License-Identifier: MIT
#include "odas/studio/engine_host.hpp"

#include "support/fake_io.hpp"
#include "support/studio_parts.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::engine_host_test {
namespace {

using std::chrono::seconds;

class EngineHostTest : public testing::Test {
 protected:
  static EngineHost::Options options() {
    EngineHost::Options made;
    made.open_source = [](const RawConfig&) -> std::unique_ptr<AudioSource> {
      return std::make_unique<test::MemorySource>(test::noise(4, 16000));
    };
    return made;
  }
  test::HeardMessages heard;
  LogBook log{"", heard};
};

TEST_F(EngineHostTest, runs_what_is_opened_to_its_end_and_again) {
  EngineHost host(options(), heard, log, {});
  EXPECT_EQ(host.status().state, EngineState::idle);
  host.open(test::sample_document());
  ASSERT_TRUE(host.wait_for_end(seconds(20)));
  EXPECT_EQ(host.status().state, EngineState::ended);
  host.start();
  ASSERT_TRUE(host.wait_for_end(seconds(20)));
  EXPECT_EQ(host.status().state, EngineState::ended);
  int ends = 0;
  for (const auto& message : heard.messages()) {
    if (message.at("type") == "engine" && message.at("state") == "ended") ++ends;
  }
  EXPECT_EQ(ends, 2);
}

TEST_F(EngineHostTest, outlives_a_source_that_cannot_be_opened_and_faults_of_a_configuration) {
  EngineHost::Options broken;
  broken.open_source = [](const RawConfig&) -> std::unique_ptr<AudioSource> {
    throw IoError("is not there");
  };
  EngineHost host(broken, heard, log, {});
  host.open(test::sample_document());
  ASSERT_TRUE(host.wait_for_end(seconds(20)));
  EXPECT_EQ(host.status().state, EngineState::failed);
  EXPECT_NE(host.status().what.find("is not there"), std::string::npos);
  Document bad = test::sample_document();
  bad.text = "raw: { fS = 1; };";
  EXPECT_THROW(host.open(bad), ConfigError);
  EXPECT_EQ(host.status().document.name, "sample");
}

}  // namespace
}  // namespace odas::engine_host_test
