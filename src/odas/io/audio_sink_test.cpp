// SPDX-License-Identifier: MIT
#include "odas/io/audio_sink.hpp"

#include <cmath>
#include <cstring>

#include "support/allocation_counter.hpp"
#include "support/fake_io.hpp"
#include <gtest/gtest.h>

namespace odas::audio_sink_test {
namespace {

/// Keeps the records that it is given, elsewhere than in the sink that owns it.
struct Kept {
  std::vector<std::string> records;
  bool closed = false;
};
class KeepingWriter : public ByteWriter {
 public:
  explicit KeepingWriter(Kept& kept) : kept_(kept) {}
  [[nodiscard]] std::string where() const override { return "memory"; }
  IoStatus write(std::span<const char> record) override {
    kept_.records.emplace_back(record.begin(), record.end());
    return fail ? IoStatus::failed("no more room") : IoStatus();
  }
  IoStatus flush() override { return {}; }
  IoStatus close() override {
    kept_.closed = true;
    return {};
  }
  bool fail = false;

 private:
  Kept& kept_;
};

AudioSink::Format format_of(std::size_t slots) {
  AudioSink::Format format;
  format.slots = slots;
  format.hop = 128;
  return format;
}

AudioSink sink_of(const AudioSink::Format& format, const AudioOutputConfig& output, Kept& kept) {
  return {format, output, std::make_unique<KeepingWriter>(kept)};
}

std::vector<std::int16_t> samples_of(const Kept& kept) {
  std::string all;
  for (const std::string& record : kept.records) all += record;
  std::vector<std::int16_t> samples(all.size() / 2);
  std::memcpy(samples.data(), all.data(), all.size());
  return samples;
}

/// Both slots hold the number of their sample, the second one negative, in 16-bit steps.
test::HopOfHand ramp(HopIndex time) {
  test::HopOfHand hop;
  hop.separated = Grid<float>(2, 128);
  for (std::size_t i = 0; i < 128; ++i) {
    const auto number = static_cast<float>(128 * (time - 1) + i);
    hop.separated[0][i] = number / 32768;
    hop.separated[1][i] = -number / 32768;
  }
  hop.postfiltered = Grid<float>(2, 128);
  return hop;
}

TEST(AudioSink, writes_the_slots_interleaved_in_blocks_of_its_size) {
  Kept kept;
  AudioOutputConfig output;
  output.hop_size = 100;
  AudioSink sink = sink_of(format_of(2), output, kept);
  for (HopIndex t = 1; t <= 4; ++t) EXPECT_TRUE(sink.write(ramp(t).result(t)).ok());
  EXPECT_EQ(kept.records.size(), 5U);
  for (const std::string& record : kept.records) EXPECT_EQ(record.size(), 100U * 2 * 2);
  EXPECT_TRUE(sink.close().ok());
  const auto samples = samples_of(kept);
  ASSERT_EQ(samples.size(), 2U * 4 * 128) << "the rest too, at the end";
  for (std::size_t i = 0; i < 4 * 128; ++i) {
    EXPECT_EQ(samples[2 * i], static_cast<int>(i));
    EXPECT_EQ(samples[2 * i + 1], -static_cast<int>(i));
  }
}

TEST(AudioSink, fills_dropped_hops_with_silence_so_that_channels_never_slip) {
  Kept kept;
  AudioSink sink = sink_of(format_of(2), {}, kept);
  EXPECT_TRUE(sink.write(ramp(1).result(1)).ok());
  EXPECT_TRUE(sink.write(ramp(4).result(4)).ok());
  const auto samples = samples_of(kept);
  ASSERT_EQ(samples.size(), 2U * 4 * 128);
  for (std::size_t i = 0; i < 4 * 128; ++i) {
    const bool dropped = i >= 128 && i < 3 * 128;
    EXPECT_EQ(samples[2 * i], dropped ? 0 : static_cast<int>(i));
  }
}

TEST(AudioSink, applies_its_gain_and_holds_and_counts_what_is_too_loud) {
  Kept kept;
  AudioSink::Format format = format_of(2);
  format.gain = 1000;
  AudioSink sink = sink_of(format, {}, kept);
  EXPECT_TRUE(sink.write(ramp(1).result(1)).ok());
  const auto samples = samples_of(kept);
  EXPECT_EQ(samples[2 * 5], 5000);
  EXPECT_EQ(samples[2 * 100], 32767) << "ODAS wrapped";
  EXPECT_EQ(samples[2 * 100 + 1], -32768);
  EXPECT_EQ(sink.clipped_samples(), 2U * (128 - 33));
}

TEST(AudioSink, brings_the_voices_to_its_rate) {
  Kept kept;
  AudioOutputConfig output;
  output.fs = 44100;
  output.hop_size = 512;
  AudioSink::Format format = format_of(1);
  AudioSink sink = sink_of(format, output, kept);
  test::HopOfHand hop;
  hop.separated = Grid<float>(1, 128);
  for (HopIndex t = 1; t <= 125; ++t) {
    for (std::size_t i = 0; i < 128; ++i) {
      hop.separated[0][i] = 0.5F * std::sin(0.3F * static_cast<float>(128 * (t - 1) + i));
    }
    EXPECT_TRUE(sink.write(hop.result(t)).ok());
  }
  EXPECT_TRUE(sink.close().ok());
  const auto samples = samples_of(kept);
  ASSERT_EQ(samples.size(), 44100U);
  for (std::size_t i = 1000; i < 43000; ++i) {
    EXPECT_NEAR(samples[i], 16384 * std::sin(0.3 * static_cast<double>(i) * 16000 / 44100), 20) << i;
  }
}

TEST(AudioSink, takes_the_stream_that_it_is_for) {
  Kept kept;
  AudioSink::Format format = format_of(2);
  format.stream = AudioSink::Stream::postfiltered;
  AudioSink sink = sink_of(format, {}, kept);
  test::HopOfHand hop = ramp(1);
  hop.postfiltered.fill(0.25F);
  EXPECT_TRUE(sink.write(hop.result(1)).ok());
  EXPECT_EQ(samples_of(kept)[7], 8192);
  EXPECT_TRUE(sink.wanted().postfiltered);
  EXPECT_FALSE(sink.wanted().separated);
  EXPECT_EQ(sink.name(), "sss.postfiltered (memory)");
}

TEST(AudioSink, writes_8_bits_unsigned_where_wav_has_them_so) {
  Kept kept;
  AudioSink::Format format = format_of(2);
  format.unsigned_bytes = true;
  AudioOutputConfig output;
  output.n_bits = 8;
  AudioSink sink = sink_of(format, output, kept);
  test::HopOfHand hop = ramp(1);
  hop.separated.fill(-1);
  EXPECT_TRUE(sink.write(hop.result(1)).ok());
  EXPECT_EQ(kept.records[0][0], 0);
}

TEST(AudioSink, writes_nothing_after_a_failure_but_closes) {
  Kept kept;
  auto writer = std::make_unique<KeepingWriter>(kept);
  writer->fail = true;
  AudioOutputConfig output;
  output.hop_size = 100;
  AudioSink sink(format_of(2), output, std::move(writer));
  EXPECT_FALSE(sink.write(ramp(1).result(1)).ok());
  EXPECT_TRUE(sink.close().ok()) << "it is said once";
  EXPECT_EQ(kept.records.size(), 1U);
  EXPECT_TRUE(kept.closed);
}

TEST(AudioSink, allocates_nothing_for_a_hop) {
  for (const int rate : {16000, 44100}) {
    Kept kept;
    AudioOutputConfig output;
    output.fs = rate;
    output.hop_size = 4096;  // no block is full, so that only the sink is measured
    AudioSink sink = sink_of(format_of(2), output, kept);
    const test::HopOfHand hop = ramp(1);
    const auto before = test::allocations();
    for (HopIndex t = 1; t <= 8; ++t) EXPECT_TRUE(sink.write(hop.result(t)).ok());
    EXPECT_EQ(test::allocations(), before) << rate;
  }
}

}  // namespace
}  // namespace odas::audio_sink_test
