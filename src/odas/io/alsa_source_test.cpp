// SPDX-License-Identifier: MIT
#include "odas/io/alsa_source.hpp"

#include <cerrno>
#include <cstring>
#include <deque>

#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::alsa_source_test {
namespace {

using std::chrono::milliseconds;

/// A card of two channels whose samples count its frames: n, -n. Time passes by what the test plays.
struct FakeCard {
  struct Event {
    long read;   // frames, or an error
    int ms = 0;  // that pass before
  };
  std::deque<Event> events;
  AlsaSource::Clock::time_point now{};
  CaptureOffer offer{{SampleFormat::s16}, {}, 2, 2, {}, 16000, 16000, {16000}};
  int open_error = 0;  // while it is away
  int recover_error = 0;
  int opens = 0, starts = 0, recoveries = 0;
  long waiting = 0;  // frames that could be read already
  SampleFormat configured = SampleFormat::u8;
  int next = 0;  // frame

  void pass(int ms) {
    now += milliseconds(ms);
    next += 16 * ms;
  }
};

class FakePcm : public AlsaPcm {
 public:
  explicit FakePcm(FakeCard& card) : card_(card) {}
  CaptureOffer offer(std::optional<int>, std::optional<int>) override { return card_.offer; }
  int configure(SampleFormat format, int, int, std::size_t) override {
    card_.configured = format;
    return 0;
  }
  int start() override {
    ++card_.starts;
    return 0;
  }
  int wait(int ms) override {
    if (!card_.events.empty()) return 1;
    card_.pass(ms);
    return 0;
  }
  long read(char* bytes, std::size_t frames) override {
    if (card_.events.empty()) return -EAGAIN;
    const FakeCard::Event event = card_.events.front();
    card_.events.pop_front();
    card_.now += milliseconds(event.ms);
    if (event.read < 0) {
      card_.next += 16 * event.ms;
      return event.read;
    }
    const long n = std::min(event.read, static_cast<long>(frames));
    for (long i = 0; i < n; ++i) {
      const auto value = static_cast<std::int16_t>((card_.next++) % 30000);
      const auto other = static_cast<std::int16_t>(-value);
      std::memcpy(bytes + 4 * i, &value, 2);
      std::memcpy(bytes + 4 * i + 2, &other, 2);
    }
    return n;
  }
  long available() override { return card_.waiting; }
  int recover(int) override {
    ++card_.recoveries;
    return card_.recover_error;
  }

 private:
  FakeCard& card_;
};

AlsaSource::World world_of(FakeCard& card) {
  AlsaSource::World world;
  world.open = [&card](const std::string&, int& error) -> std::unique_ptr<AlsaPcm> {
    ++card.opens;
    error = card.open_error;
    if (error < 0) return nullptr;
    return std::make_unique<FakePcm>(card);
  };
  world.error_text = [](int error) { return std::string(std::strerror(-error)); };
  world.owner = [](const std::string&) { return "arecord (process 7)"; };
  world.now = [&card] { return card.now; };
  world.sleep = [&card](AlsaSource::Clock::duration time) {
    card.pass(static_cast<int>(std::chrono::duration_cast<milliseconds>(time).count()));
  };
  return world;
}

RawConfig raw_config() {
  RawConfig raw;
  raw.n_channels = 2;
  return raw;
}

struct Capture {
  explicit Capture(FakeCard& c) : card(c), source("hw:1,0", raw_config(), world_of(c)) {}
  /// Reads so many times; checks that the stamp of each frame is the frame of the card.
  void read(int times, int tolerance = 0) {
    Grid<float> block(2, 128);
    for (int i = 0; i < times; ++i) {
      const ReadResult result = source.read(block);
      time += result.lost;
      lost += result.lost;
      if (!result.notice.empty()) notices.push_back(result.notice);
      EXPECT_FALSE(result.end);
      for (std::size_t k = 0; k < result.frames; ++k) {
        const auto frame = static_cast<long>(block[0][k] * 32768);
        EXPECT_NEAR(static_cast<double>(frame), static_cast<double>(time % 30000), tolerance);
        EXPECT_EQ(block[1][k], -block[0][k]);
        ++time;
      }
      frames += result.frames;
    }
  }
  FakeCard& card;
  AlsaSource source;
  std::uint64_t time = 0, lost = 0, frames = 0;
  std::vector<std::string> notices;
};

TEST(AlsaSource, reads_short_blocks_as_they_come) {
  FakeCard card;
  card.events = {{128, 8}, {100, 6}, {1, 1}, {-EAGAIN, 0}, {-EINTR, 0}, {128, 9}};
  Capture capture(card);
  capture.read(6);
  EXPECT_EQ(capture.frames, 128U + 100 + 1 + 128);
  EXPECT_EQ(capture.lost, 0U);
  EXPECT_TRUE(capture.notices.empty());
}

TEST(AlsaSource, recovers_from_an_overrun_and_counts_what_was_lost) {
  FakeCard card;
  card.events = {{128, 8}, {128, 8}, {-EPIPE, 600}, {128, 8}, {128, 8}};
  Capture capture(card);
  capture.read(4);
  EXPECT_EQ(card.recoveries, 1);
  EXPECT_EQ(card.starts, 2);
  EXPECT_EQ(capture.source.overruns(), 1U);
  EXPECT_EQ(capture.lost, 9600U) << "600 ms";
  EXPECT_EQ(capture.frames, 4 * 128U);
  ASSERT_EQ(capture.notices.size(), 1U);
  EXPECT_NE(capture.notices[0].find("hw:1,0 has overrun"), std::string::npos);
  EXPECT_NE(capture.notices[0].find("1 time, 9600 frames lost"), std::string::npos);
}

TEST(AlsaSource, counts_the_frames_that_waited_in_the_buffer_of_an_overrun_card) {
  FakeCard card;
  card.waiting = 1600;
  card.events = {{128, 8}, {-EPIPE, 500}, {128, 8}};
  Capture capture(card);
  card.next = 0;
  Grid<float> block(2, 128);
  EXPECT_EQ(capture.source.read(block).lost, 0U);
  EXPECT_EQ(capture.source.read(block).lost, 8000U + 1600U);
}

TEST(AlsaSource, does_not_fill_a_log_when_overruns_come_in_flocks) {
  FakeCard card;
  for (int i = 0; i < 50; ++i) {
    card.events.push_back({-EPIPE, 10});
    card.events.push_back({128, 8});
  }
  Capture capture(card);
  capture.read(50);
  EXPECT_EQ(capture.source.overruns(), 50U);
  EXPECT_EQ(capture.notices.size(), 1U);
  EXPECT_EQ(capture.lost, 50 * 160U);
}

TEST(AlsaSource, wakes_up_with_the_machine) {
  FakeCard card;
  card.events = {{128, 8}, {-ESTRPIPE, 1000}, {128, 8}};
  card.recover_error = -EAGAIN;
  Capture capture(card);
  capture.read(3);
  EXPECT_EQ(capture.frames, 128U) << "it is waking up";
  card.recover_error = 0;
  capture.read(2);
  EXPECT_EQ(capture.frames, 256U);
  EXPECT_GE(capture.lost, 16000U);
}

TEST(AlsaSource, waits_for_a_card_that_was_pulled_out) {
  FakeCard card;
  card.events = {{128, 8}, {-ENODEV, 2}};
  Capture capture(card);
  card.open_error = -ENOENT;
  capture.read(100);
  EXPECT_GT(card.opens, 3);
  EXPECT_LT(card.opens, 20) << "with longer and longer pauses";
  EXPECT_GT(capture.lost, 16000U) << "time goes on";
  card.open_error = 0;
  card.events = {{128, 8}, {128, 8}};
  capture.read(40, 16);
  EXPECT_EQ(capture.frames, 3 * 128U);
  ASSERT_EQ(capture.notices.size(), 2U);
  EXPECT_EQ(capture.notices[0], "hw:1,0 was pulled out; waiting until it is back");
  EXPECT_EQ(capture.notices[1], "hw:1,0 is back");
}

TEST(AlsaSource, opens_a_card_again_that_hangs) {
  FakeCard card;
  card.events = {{128, 8}};
  Capture capture(card);
  capture.read(60);
  EXPECT_GE(card.opens, 2);
  EXPECT_NE(capture.notices.at(0).find("gives no sound any more"), std::string::npos);
  EXPECT_NEAR(static_cast<double>(capture.lost), 16.0 * 5000, 16 * 1200.0);
}

TEST(AlsaSource, tries_both_packings_of_24_bits_and_takes_the_best_on_request) {
  FakeCard card;
  RawConfig raw = raw_config();
  raw.n_bits = 24;
  card.offer.formats = {SampleFormat::s24, SampleFormat::s16};
  EXPECT_EQ(AlsaSource("hw:1,0", raw, world_of(card)).format(), SampleFormat::s24);
  card.offer.formats = {SampleFormat::s24_3, SampleFormat::s24};
  EXPECT_EQ(AlsaSource("hw:1,0", raw, world_of(card)).format(), SampleFormat::s24_3);
  raw.format = "auto";
  card.offer.formats = {SampleFormat::s32, SampleFormat::s24_3, SampleFormat::s16};
  EXPECT_EQ(AlsaSource("hw:1,0", raw, world_of(card)).format(), SampleFormat::s32);
  EXPECT_EQ(card.configured, SampleFormat::s32);
}

std::string failure(FakeCard& card, const RawConfig& raw = raw_config()) {
  try {
    const AlsaSource source("hw:1,0", raw, world_of(card));
  } catch (const std::runtime_error& error) { return error.what(); }
  return "";
}

TEST(AlsaSource, says_what_the_card_offers_instead_as_lines_to_paste) {
  FakeCard card;
  card.offer = {{SampleFormat::s32, SampleFormat::s24_3}, {}, 6, 8, {}, 44100, 48000, {44100, 48000}};
  EXPECT_EQ(
      failure(card),
      "error: raw: hw:1,0 offers something else: raw.nChannels is 2, it has 6 to 8; raw.fS is 16000, it "
      "has 44100, 48000 Hz; raw.nBits is 16, it has S32_LE, S24_3LE. In raw, write: nChannels = 6; "
      "fS = 44100; nBits = 32;");
}

TEST(AlsaSource, says_who_holds_the_card_what_is_missing_and_what_is_forbidden) {
  FakeCard card;
  card.open_error = -EBUSY;
  EXPECT_NE(failure(card).find("arecord (process 7) captures from it"), std::string::npos);
  card.open_error = -ENOENT;
  EXPECT_NE(failure(card).find("hw:1,0: No such file or directory; 'odas devices' lists"), std::string::npos);
  card.open_error = -EACCES;
  EXPECT_NE(failure(card).find("usermod -aG audio"), std::string::npos);
}

}  // namespace
}  // namespace odas::alsa_source_test
