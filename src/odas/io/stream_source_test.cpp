// SPDX-License-Identifier: MIT
#include "odas/io/stream_source.hpp"

#include <array>
#include <deque>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

namespace odas::stream_source_test {
namespace {

/// Streams that the test has the other ends of.
class FakePort : public StreamPort {
 public:
  [[nodiscard]] std::string where() const override { return "the peer"; }
  [[nodiscard]] std::optional<FileDescriptor> poll(std::string&) override {
    if (streams.empty()) return std::nullopt;
    FileDescriptor stream = std::move(streams.front());
    streams.pop_front();
    return stream;
  }
  [[nodiscard]] bool can_return() const noexcept override { return returns; }

  /// The end that the peer writes to.
  FileDescriptor connect() {
    std::array<int, 2> ends{};
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()), 0);
    streams.emplace_back(ends[0]);
    return FileDescriptor(ends[1]);
  }
  std::deque<FileDescriptor> streams;
  bool returns = true;
};

struct Received {
  std::vector<float> samples;  // of the first channel, in units of 16 bits
  std::uint64_t lost = 0;
  std::string notices, fault;
  bool end = false;
};

struct Reader {
  explicit Reader(bool reconnect = false) {
    raw.n_channels = 2;
    raw.hop_size = 4;
    raw.interface.reconnect = reconnect;
    auto owned = std::make_unique<FakePort>();
    port = owned.get();
    source = std::make_unique<StreamSource>(raw, std::move(owned));
  }
  /// Reads until its end, or until there are so many frames, or a notice has come.
  void read(std::size_t frames, const std::string& notice = "", int most_turns = 200) {
    Grid<float> block(2, 4);
    for (int turns = 0; turns < most_turns && !got.end; ++turns) {
      const ReadResult result = source->read(block);
      for (std::size_t i = 0; i < result.frames; ++i) {
        got.samples.push_back(block[0][i] * 32768);
        EXPECT_EQ(block[1][i], -block[0][i]) << "the channels have slipped";
      }
      got.lost += result.lost;
      got.notices += result.notice;
      got.end = result.end;
      got.fault = result.status.what();
      if (notice.empty() ? got.samples.size() >= frames : got.notices.find(notice) != std::string::npos)
        return;
    }
  }
  RawConfig raw;
  FakePort* port = nullptr;
  std::unique_ptr<StreamSource> source;
  Received got;
};

/// Frames from/-from, from+1/..., of 16 bits.
std::string frames(int from, int count) {
  std::string bytes;
  for (int i = from; i < from + count; ++i) {
    for (const int value : {i, -i}) {
      bytes += static_cast<char>(value & 0xFF);
      bytes += static_cast<char>((value >> 8) & 0xFF);
    }
  }
  return bytes;
}

void send(const FileDescriptor& to, const std::string& bytes) {
  ASSERT_EQ(::write(to.get(), bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
}

std::vector<float> counting(int from, int count) {
  std::vector<float> all;
  for (int i = from; i < from + count; ++i) all.push_back(static_cast<float>(i));
  return all;
}

TEST(StreamSource, ends_when_the_peer_closes_after_it_has_sent_samples) {
  Reader run;
  FileDescriptor peer = run.port->connect();
  send(peer, frames(1, 10));
  peer = FileDescriptor();
  run.read(1000);
  EXPECT_TRUE(run.got.end);
  EXPECT_EQ(run.got.fault, "");
  EXPECT_EQ(run.got.samples, counting(1, 10));
  EXPECT_EQ(run.got.lost, 0U);
  EXPECT_EQ(run.source->warning(), "");
}

TEST(StreamSource, takes_chunks_of_odd_sizes) {
  Reader run;
  const FileDescriptor peer = run.port->connect();
  const std::string bytes = frames(1, 100);
  for (std::size_t at = 0, step = 1; at < bytes.size(); at += step, step = step % 13 + 2) {
    send(peer, bytes.substr(at, step));
    run.read(at / 16 * 4);
  }
  run.read(100);
  EXPECT_EQ(run.got.samples, counting(1, 100));
}

TEST(StreamSource, warns_when_the_peer_dies_in_the_middle_of_a_frame) {
  Reader run;
  FileDescriptor peer = run.port->connect();
  send(peer, frames(1, 6) + "abc");
  peer = FileDescriptor();
  run.read(1000);
  EXPECT_EQ(run.got.samples, counting(1, 6));
  EXPECT_NE(run.source->warning().find("in the middle of a sample (3 bytes are left over)"),
            std::string::npos);
}

TEST(StreamSource, waits_for_a_peer_that_will_be_back_and_counts_the_time_as_lost) {
  Reader run(true);
  FileDescriptor peer = run.port->connect();
  send(peer, frames(1, 6) + "abc");
  peer = FileDescriptor();
  run.read(0, "the peer has closed in the middle of a sample (3 bytes are left over); it is waited for");
  run.read(6);
  EXPECT_EQ(run.got.samples, counting(1, 6));
  run.read(7, "", 3);  // nobody is there
  EXPECT_FALSE(run.got.end);
  const std::uint64_t away = run.got.lost;
  EXPECT_GT(away, 1000U) << "of seconds without a peer";
  peer = run.port->connect();
  send(peer, frames(100, 4));
  run.read(10);
  std::vector<float> expected = counting(1, 6);
  for (const float x : counting(100, 4)) expected.push_back(x);
  EXPECT_EQ(run.got.samples, expected) << "in step again";
  const std::uint64_t lost = run.got.lost;
  send(peer, frames(104, 4));
  run.read(14);
  EXPECT_EQ(run.got.lost, lost) << "nothing more";
}

TEST(StreamSource, goes_on_waiting_when_a_peer_closes_without_a_sample) {
  Reader run;
  run.port->connect() = FileDescriptor();
  run.read(0, "closed without a sample; it is waited for");
  const FileDescriptor peer = run.port->connect();
  send(peer, frames(1, 4));
  run.read(4);
  EXPECT_EQ(run.got.samples, counting(1, 4));
  EXPECT_EQ(run.got.lost, 0U) << "the sound has only begun now";
}

TEST(StreamSource, of_a_pipe_ends_with_it_even_if_it_was_empty) {
  Reader run(true);
  run.port->returns = false;
  run.port->connect() = FileDescriptor();
  run.read(1000);
  EXPECT_TRUE(run.got.end);
}

TEST(StreamSource, fails_when_a_wav_does_not_fit) {
  Reader run(true);
  const FileDescriptor peer = run.port->connect();
  send(peer, "fLaC and what follows");
  run.read(1000);
  EXPECT_TRUE(run.got.end);
  EXPECT_NE(run.got.fault.find("what the peer sends is FLAC"), std::string::npos) << run.got.fault;
}

}  // namespace
}  // namespace odas::stream_source_test
