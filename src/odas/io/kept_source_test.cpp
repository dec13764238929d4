// SPDX-License-Identifier: MIT
#include "odas/io/kept_source.hpp"

#include <cmath>

#include "support/fake_io.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <sndfile.hh>

#include "odas/base/error.hpp"

namespace odas::kept_source_test {
namespace {

RawConfig raw_to(const std::filesystem::path& file, int bits = 16) {
  RawConfig raw;
  raw.n_channels = 3;
  raw.n_bits = bits;
  raw.record.interface.type = "file";
  raw.record.interface.path = file;
  return raw;
}

/// Samples that bits hold exactly.
Grid<float> exact(std::size_t frames, int bits) {
  Grid<float> samples = test::noise(3, frames);
  const float scale = std::ldexp(1.0F, bits - 1);
  for (std::size_t c = 0; c < 3; ++c) {
    for (float& x : samples[c]) x = std::round(x * scale) / scale;
  }
  return samples;
}

void read_all(AudioSource& source) {
  Grid<float> block(source.channels(), 128);
  while (!source.read(block).end) {}
}

/// [channel][frame] of a sound file.
Grid<float> sound_of(const std::filesystem::path& file) {
  SndfileHandle sound(file.string());
  std::vector<float> all(static_cast<std::size_t>(sound.frames() * sound.channels()));
  sound.readf(all.data(), sound.frames());
  Grid<float> grid(static_cast<std::size_t>(sound.channels()), static_cast<std::size_t>(sound.frames()));
  for (std::size_t i = 0; i < all.size(); ++i) grid[i % grid.rows()][i / grid.rows()] = all[i];
  return grid;
}

void expect_equal(const Grid<float>& a, const Grid<float>& b) {
  ASSERT_EQ(a.rows(), b.rows());
  ASSERT_EQ(a.cols(), b.cols());
  for (std::size_t c = 0; c < a.rows(); ++c) {
    for (std::size_t i = 0; i < a.cols(); ++i) ASSERT_EQ(a[c][i], b[c][i]) << c << ' ' << i;
  }
}

TEST(KeptSource, keeps_every_sample_as_it_came) {
  for (const int bits : {8, 16, 24}) {
    const test::Scratch scratch;
    const Grid<float> samples = exact(100000, bits);
    const RawConfig raw = raw_to(scratch / "mics.wav", bits);
    const auto source = keep_source(std::make_unique<test::MemorySource>(samples), raw);
    read_all(*source);
    EXPECT_TRUE(source->finish().ok());
    expect_equal(sound_of(scratch / "mics.wav"), samples);
  }
}

TEST(KeptSource, keeps_headerless_samples_where_the_name_does_not_end_in_wav) {
  const test::Scratch scratch;
  const auto source =
      keep_source(std::make_unique<test::MemorySource>(exact(1000, 16)), raw_to(scratch / "mics.raw"));
  read_all(*source);
  EXPECT_TRUE(source->finish().ok());
  EXPECT_EQ(test::content(scratch / "mics.raw").size(), 1000U * 3 * 2);
}

TEST(KeptSource, fills_what_was_lost_with_silence) {
  const test::Scratch scratch;
  Grid<float> samples = exact(5000, 16);
  const auto source =
      keep_source(std::make_unique<test::GappySource>(
                      samples, std::vector<test::GappySource::Gap>{{1000, 700}, {3000, 2000}}),
                  raw_to(scratch / "mics.wav"));
  read_all(*source);
  EXPECT_TRUE(source->finish().ok());
  for (std::size_t c = 0; c < 3; ++c) {
    std::fill_n(samples[c].data() + 1000, 700, 0.0F);
    std::fill_n(samples[c].data() + 3000, 2000, 0.0F);
  }
  expect_equal(sound_of(scratch / "mics.wav"), samples);
}

/// Writes nothing until it is let go.
class StuckWriter : public ByteWriter {
 public:
  explicit StuckWriter(std::atomic<bool>& go, std::string& bytes) : go_(go), bytes_(bytes) {}
  [[nodiscard]] std::string where() const override { return "stuck"; }
  IoStatus write(std::span<const char> record) override {
    while (!go_) std::this_thread::yield();
    bytes_.append(record.data(), record.size());
    return {};
  }
  IoStatus flush() override { return {}; }
  IoStatus close() override { return {}; }

 private:
  std::atomic<bool>& go_;
  std::string& bytes_;
};

TEST(KeptSource, never_makes_a_live_source_wait_for_the_disk) {
  std::atomic<bool> go{false};
  std::string bytes;
  auto live = std::make_unique<test::MemorySource>(exact(128000, 16));
  live->live_source = true;
  KeptSource source(std::move(live), raw_to(""), std::make_unique<StuckWriter>(go, bytes), false);
  Grid<float> block(3, 128);
  std::string notices;
  for (int i = 0; i < 999; ++i) notices += source.read(block).notice;
  EXPECT_GT(source.unkept_frames(), 128 * 500U);
  EXPECT_NE(notices.find("raw.record: stuck is too slow"), std::string::npos);
  go = true;
  EXPECT_TRUE(source.finish().ok());
  EXPECT_EQ(bytes.size(), 999U * 128 * 3 * 2) << "with silence for what was lost: time does not slip";
}

TEST(KeptSource, ends_the_run_when_the_disk_is_full) {
  const test::Scratch scratch;
  auto source =
      keep_source(std::make_unique<test::MemorySource>(exact(1000000, 16)), raw_to(scratch / "mics.wav"));
  const test::FileSizeLimit limit(100000);
  Grid<float> block(3, 128);
  ReadResult result;
  while (!result.end) result = source->read(block);
  EXPECT_NE(result.status.what().find("raw.record: cannot write"), std::string::npos) << result.status.what();
  EXPECT_FALSE(source->finish().ok());
}

TEST(KeptSource, is_the_source_itself_where_nothing_is_kept) {
  RawConfig raw;
  auto memory = std::make_unique<test::MemorySource>(exact(10, 16));
  AudioSource* const address = memory.get();
  EXPECT_EQ(keep_source(std::move(memory), raw).get(), address);
  EXPECT_THROW(static_cast<void>(keep_source(std::make_unique<test::MemorySource>(exact(10, 16)),
                                             raw_to("/no/such/folder/mics.wav"))),
               IoError);
}

}  // namespace
}  // namespace odas::kept_source_test
