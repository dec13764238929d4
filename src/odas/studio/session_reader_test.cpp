// SPDX-License-Identifier: MIT
#include "odas/studio/session_reader.hpp"

#include "support/hop_maker.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"
#include "odas/studio/session_recorder.hpp"

namespace odas::session_reader_test {
namespace {

std::string a_session(const test::Scratch& scratch) {
  test::HopMaker hops;
  SessionRecorder session(scratch.folder(), {true, false, false});
  EXPECT_TRUE(session.begin(hops.info()).ok());
  for (int i = 0; i < 500; ++i) {
    EXPECT_TRUE(session.hop(hops.next({1, 0})).ok());
    if (i % 125 == 124) { EXPECT_TRUE(session.flush().ok()); }
  }
  EXPECT_TRUE(session.close().ok());
  return session.name();
}

TEST(SessionReader, knows_the_length_the_start_and_the_sound_of_a_whole_session) {
  const test::Scratch scratch;
  const SessionInfo info = SessionReader(scratch / a_session(scratch)).info();
  EXPECT_NEAR(info.seconds, 4, 0.02);
  EXPECT_EQ(info.start_ns, 1769860800000000000U);
  EXPECT_EQ(info.fault, "");
  EXPECT_TRUE(info.ours);
  EXPECT_EQ(info.audio, std::vector<std::string>{"separated"});
}

TEST(SessionReader, says_how_far_one_goes_that_was_cut) {
  const test::Scratch scratch;
  const std::string whole = test::content(scratch / a_session(scratch));
  double last = 0;
  for (const double share : {0.1, 0.5, 0.9}) {
    const auto size = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
    test::write_file(scratch / "cut.mcap", whole.substr(0, size));
    int hops = 0;
    SessionReader::Visitor visitor;
    visitor.hop = [&](const nlohmann::json&, std::uint64_t) { ++hops; };
    const SessionReader reader(scratch / "cut.mcap");
    EXPECT_TRUE(reader.read(visitor).starts_with("was cut off after ")) << share;
    EXPECT_NEAR(reader.info().seconds, 0.008 * hops, 0.2) << share;
    EXPECT_GT(reader.info().seconds, last) << share;
    last = reader.info().seconds;
  }
}

TEST(SessionReader, passes_over_a_message_that_was_damaged_and_says_so) {
  const test::Scratch scratch;
  std::string bytes = test::content(scratch / a_session(scratch));
  const std::size_t at = bytes.find("\"tracks\"");
  bytes[at] = ']';
  test::write_file(scratch / "bad.mcap", bytes);
  int hops = 0;
  SessionReader::Visitor visitor;
  visitor.hop = [&](const nlohmann::json&, std::uint64_t) { ++hops; };
  EXPECT_TRUE(SessionReader(scratch / "bad.mcap").read(visitor).starts_with("is damaged"));
  EXPECT_EQ(hops, 499);
}

TEST(SessionReader, refuses_other_files) { EXPECT_THROW(SessionReader("/nowhere/a.mcap"), IoError); }

}  // namespace
}  // namespace odas::session_reader_test
