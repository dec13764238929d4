// SPDX-License-Identifier: MIT
#include "odas/io/terminal_writer.hpp"

#include <array>
#include <csignal>
#include <thread>

#include <gtest/gtest.h>

#include "odas/io/file_descriptor.hpp"

namespace odas::terminal_writer_test {
namespace {

struct Pipe {
  Pipe() {
    std::array<int, 2> ends{};
    EXPECT_EQ(::pipe(ends.data()), 0);
    reader = FileDescriptor(ends[0]);
    writer = FileDescriptor(ends[1]);
    std::signal(SIGPIPE, SIG_IGN);
  }
  FileDescriptor reader, writer;
};

TEST(TerminalWriter, sends_each_record_at_once) {
  Pipe pipe;
  TerminalWriter writer(nullptr, pipe.writer.get());
  EXPECT_TRUE(writer.write(std::string("hop\n")).ok());
  std::array<char, 16> got{};
  EXPECT_EQ(::read(pipe.reader.get(), got.data(), got.size()), 4);
  EXPECT_STREQ(got.data(), "hop\n");
}

TEST(TerminalWriter, sends_all_of_a_large_record_to_a_slow_reader) {
  Pipe pipe;
  std::string got;
  std::thread reader([&] {
    std::array<char, 1000> part{};
    for (ssize_t n = 0; (n = ::read(pipe.reader.get(), part.data(), part.size())) > 0;) {
      got.append(part.data(), static_cast<std::size_t>(n));
    }
  });
  const std::string record(300000, 'x');
  EXPECT_TRUE(TerminalWriter(nullptr, pipe.writer.get()).write(record).ok());
  pipe.writer = FileDescriptor();
  reader.join();
  EXPECT_EQ(got.size(), record.size());
}

TEST(TerminalWriter, says_that_the_reader_is_gone) {
  Pipe pipe;
  pipe.reader = FileDescriptor();
  const IoStatus status = TerminalWriter(nullptr, pipe.writer.get()).write(std::string("hop\n"));
  EXPECT_NE(status.what().find("nobody reads it any more"), std::string::npos) << status.what();
}

TEST(TerminalWriter, does_not_wait_for_a_reader_that_sleeps_once_asked_to_stop) {
  Pipe pipe;
  const std::atomic<bool> stop{true};
  TerminalWriter writer(&stop, pipe.writer.get());
  EXPECT_TRUE(writer.write(std::string(300000, 'x')).ok()) << "returns at all";
}

TEST(TerminalWriter, for_a_live_source_a_reader_that_sleeps_loses_whole_records_and_delays_nobody) {
  Pipe pipe;
  TerminalWriter writer(nullptr, pipe.writer.get(), false);
  const std::string record = std::string(999, 'x') + "\n";
  constexpr std::size_t kSent = 3000;
  for (std::size_t i = 0; i < kSent; ++i) ASSERT_TRUE(writer.write(record).ok());
  EXPECT_GT(writer.lost_records(), 0U);
  std::string got;
  std::thread reader([&] {
    std::array<char, 10000> part{};
    for (ssize_t n = 0; (n = ::read(pipe.reader.get(), part.data(), part.size())) > 0;) {
      got.append(part.data(), static_cast<std::size_t>(n));
    }
  });
  EXPECT_TRUE(writer.close().ok());
  pipe.writer = FileDescriptor();
  reader.join();
  EXPECT_EQ(got.size() % record.size(), 0U);
  EXPECT_EQ(got.size() / record.size() + writer.lost_records(), kSent);
}

}  // namespace
}  // namespace odas::terminal_writer_test
