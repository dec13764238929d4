// SPDX-License-Identifier: MIT
#include "odas/studio/mcap_writer.hpp"

#include "support/program.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"
#include "odas/studio/mcap_reader.hpp"

namespace odas::mcap_writer_test {
namespace {

constexpr int kMessages = 20;

/// Two channels in turn, a chunk every five messages.
void write_some(McapWriter& writer) {
  const std::uint16_t text = writer.add_channel({"hops", "json"});
  const std::uint16_t sound = writer.add_channel({"audio/raw", "odas"});
  writer.add_channel({"never used", "json"});
  for (int i = 0; i < kMessages; ++i) {
    const std::string data = i % 2 == 0 ? "{\"t\":" + std::to_string(i) + "}" : std::string(3, char(i));
    const auto time = static_cast<std::uint64_t>(1000 + i);
    ASSERT_TRUE(writer.write(i % 2 == 0 ? text : sound, time, data).ok());
    if (i % 5 == 4) { ASSERT_TRUE(writer.flush().ok()); }
  }
}

int count(McapReader& reader) {
  int messages = 0;
  while (const auto message = reader.next()) {
    EXPECT_EQ(message->time, static_cast<std::uint64_t>(1000 + messages));
    EXPECT_EQ(message->channel->topic, messages % 2 == 0 ? "hops" : "audio/raw");
    ++messages;
  }
  return messages;
}

TEST(Mcap, what_is_written_is_read) {
  const test::Scratch scratch;
  McapWriter writer(scratch / "a.mcap", "test");
  write_some(writer);
  ASSERT_TRUE(writer.close().ok());
  McapReader reader(scratch / "a.mcap");
  EXPECT_EQ(reader.profile(), "odas");
  const auto all = reader.statistics();
  ASSERT_TRUE(all.has_value());
  EXPECT_EQ(all->messages, kMessages);
  EXPECT_EQ(all->chunks, 4U);
  EXPECT_EQ(all->begin_ns, 1000U);
  EXPECT_EQ(all->end_ns, 1019U);
  EXPECT_EQ(reader.summary_channels().size(), 2U) << "what was never used is not there";
  EXPECT_EQ(count(reader), kMessages);
  EXPECT_EQ(reader.fault(), "");
}

TEST(Mcap, an_independent_reader_finds_messages_indices_and_check_sums) {
  const test::Scratch scratch;
  McapWriter writer(scratch / "a.mcap", "test");
  write_some(writer);
  ASSERT_TRUE(writer.close().ok());
  const std::string script = std::string(ODAS_SOURCE_DIR) + "/tests/support/read_mcap.py";
  const test::ProgramRun run =
      test::run_program({"/usr/bin/env", "python3", script, (scratch / "a.mcap").string()}, {});
  if (run.exit_code == 127) GTEST_SKIP() << "no python3 here";
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, "audio/raw odas 10\nhops json 10\n");
}

TEST(Mcap, a_file_without_messages_is_whole) {
  const test::Scratch scratch;
  ASSERT_TRUE(McapWriter(scratch / "a.mcap", "test").close().ok());
  McapReader reader(scratch / "a.mcap");
  EXPECT_EQ(count(reader), 0);
  EXPECT_EQ(reader.fault(), "");
}

TEST(Mcap, a_long_chunk_is_closed_by_itself) {
  const test::Scratch scratch;
  McapWriter writer(scratch / "a.mcap", "test");
  const std::uint16_t channel = writer.add_channel({"x", "odas"});
  const std::string data(std::size_t{1} << 20, 'x');
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(writer.write(channel, 1, data).ok());
  EXPECT_GT(std::filesystem::file_size(scratch / "a.mcap"), std::size_t{4} << 20);
  ASSERT_TRUE(writer.close().ok());
}

TEST(Mcap, that_cannot_be_written_is_said) {
  const test::Scratch scratch;
  EXPECT_THROW(McapWriter(scratch / "none" / "a.mcap", ""), IoError);
  const test::FileSizeLimit limit(300);
  McapWriter writer(scratch / "a.mcap", "");
  const std::uint16_t channel = writer.add_channel({"x", "odas"});
  IoStatus status = writer.write(channel, 1, std::string(1000, 'x'));
  if (status.ok()) status = writer.flush();
  EXPECT_FALSE(status.ok());
}

}  // namespace
}  // namespace odas::mcap_writer_test
