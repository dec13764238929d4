// SPDX-License-Identifier: MIT
#include "odas/studio/mcap_reader.hpp"

#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"
#include "odas/studio/mcap_writer.hpp"

namespace odas::mcap_reader_test {
namespace {

/// Three chunks of four messages.
std::string a_session(const test::Scratch& scratch, bool closed) {
  McapWriter writer(scratch / "whole.mcap", "test");
  const std::uint16_t channel = writer.add_channel({"hops", "json"});
  for (std::uint64_t i = 0; i < 12; ++i) {
    EXPECT_TRUE(writer.write(channel, i, "{\"t\":1}").ok());
    if (i % 4 == 3) { EXPECT_TRUE(writer.flush().ok()); }
  }
  if (closed) { EXPECT_TRUE(writer.close().ok()); }
  return test::content(scratch / "whole.mcap");
}

struct Read {
  int messages = 0;
  std::string fault;
};
Read read(const test::Scratch& scratch, const std::string& bytes) {
  test::write_file(scratch / "part.mcap", bytes);
  McapReader reader(scratch / "part.mcap");
  Read result;
  while (const auto message = reader.next()) {
    EXPECT_EQ(message->channel->topic, "hops");
    ++result.messages;
  }
  result.fault = reader.fault();
  return result;
}

TEST(McapReader, reads_a_file_that_was_cut_anywhere_as_far_as_it_goes) {
  const test::Scratch scratch;
  const std::string whole = a_session(scratch, true);
  int last = 0;
  for (std::size_t size = 8; size < whole.size(); ++size) {
    const Read part = read(scratch, whole.substr(0, size));
    EXPECT_GE(part.messages, last) << "of " << size << " bytes";
    last = part.messages;
    // All data and their end are there: nothing is missing but the summary.
    if (part.messages < 12) { EXPECT_EQ(part.fault, "was cut off") << size; }
  }
  EXPECT_EQ(last, 12);
}

TEST(McapReader, reads_what_a_killed_writer_has_flushed) {
  const test::Scratch scratch;
  const Read part = read(scratch, a_session(scratch, false));
  EXPECT_EQ(part.messages, 12);
  EXPECT_EQ(part.fault, "was cut off");
}

TEST(McapReader, notices_damage_and_survives_it) {
  const test::Scratch scratch;
  const std::string whole = a_session(scratch, true);
  const std::size_t end = whole.rfind("{\"t\":1}");
  int noticed = 0;
  for (std::size_t at = 8; at < end; ++at) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x55);
    test::write_file(scratch / "bad.mcap", bytes);
    McapReader reader(scratch / "bad.mcap");
    while (reader.next()) {}
    noticed += reader.fault().empty() ? 0 : 1;
  }
  EXPECT_GT(noticed, static_cast<int>(end) / 3);
  std::string bytes = whole;
  bytes[end + 2] = 'u';
  EXPECT_EQ(read(scratch, bytes).fault, "is damaged") << "a message has another byte";
}

TEST(McapReader, refuses_what_is_no_mcap) {
  const test::Scratch scratch;
  EXPECT_THROW(McapReader(scratch / "none.mcap"), IoError);
  test::write_file(scratch / "text.mcap", "RIFF and so on");
  EXPECT_THROW(McapReader(scratch / "text.mcap"), IoError);
  test::write_file(scratch / "empty.mcap", "");
  EXPECT_THROW(McapReader(scratch / "empty.mcap"), IoError);
}

}  // namespace
}  // namespace odas::mcap_reader_test
