// SPDX-License-Identifier: MIT
#include "odas/engine/sink_group.hpp"

#include <stdexcept>

#include "support/fake_io.hpp"
#include <gtest/gtest.h>

namespace odas::sink_group_test {
namespace {

HopResult hop(HopIndex time) { return {time, {}, {}, {}, {}}; }
void ignore(const std::string&) {}

TEST(SinkGroup, goes_on_with_the_others_when_one_fails_and_says_so_once) {
  test::KeepingSink good;
  test::KeepingSink bad;
  bad.fail_at = 2;
  const std::vector<Sink*> sinks{&bad, &good};
  SinkGroup group(sinks);
  group.write_all(hop(1));
  EXPECT_FALSE(group.failed());
  group.write_all(hop(2));
  EXPECT_TRUE(group.failed());
  group.write_all(hop(3));
  group.close();
  EXPECT_EQ(good.hops.size(), 3U);
  EXPECT_EQ(bad.hops.size(), 1U);
  EXPECT_EQ(bad.writes_after_failure, 1) << "it is not written to again";
  EXPECT_EQ(bad.closes, 1) << "but it is closed";

  RunSummary summary;
  group.report(summary, ignore);
  EXPECT_EQ(summary.end, RunSummary::End::sink_failed);
  EXPECT_EQ(summary.fault, "kept: no more room");
  EXPECT_EQ(summary.exit_code(), 1);
}

TEST(SinkGroup, reports_a_failure_at_the_close) {
  test::KeepingSink sink;
  sink.close_fault = "no more room";
  const std::vector<Sink*> sinks{&sink};
  SinkGroup group(sinks);
  group.close();
  RunSummary summary;
  group.report(summary, ignore);
  EXPECT_EQ(summary.end, RunSummary::End::sink_failed);
}

TEST(SinkGroup, takes_an_exception_as_a_failure) {
  struct Throwing : test::KeepingSink {
    IoStatus write(const HopResult&) override { throw std::runtime_error("broken"); }
  } sink;
  const std::vector<Sink*> sinks{&sink};
  SinkGroup group(sinks);
  group.write_all(hop(1));
  EXPECT_TRUE(group.failed());
}

TEST(SinkGroup, keeps_the_first_cause_of_an_end) {
  test::KeepingSink sink;
  sink.fail_at = 1;
  const std::vector<Sink*> sinks{&sink};
  SinkGroup group(sinks);
  group.write_all(hop(1));
  RunSummary summary;
  summary.end = RunSummary::End::source_failed;
  summary.fault = "the card was pulled out";
  group.report(summary, ignore);
  EXPECT_EQ(summary.end, RunSummary::End::source_failed);
  EXPECT_EQ(summary.fault, "the card was pulled out");
}

TEST(SinkGroup, warns_of_clipped_samples) {
  test::KeepingSink sink;
  sink.clipped = 7;
  const std::vector<Sink*> sinks{&sink};
  const SinkGroup group(sinks);
  RunSummary summary;
  std::vector<std::string> warnings;
  group.report(summary, [&](std::string warning) { warnings.push_back(std::move(warning)); });
  EXPECT_EQ(summary.metrics.clipped_samples, 7U);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_TRUE(warnings[0].starts_with("kept: 7 samples were louder than full scale"));
}

}  // namespace
}  // namespace odas::sink_group_test
