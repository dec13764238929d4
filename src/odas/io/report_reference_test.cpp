// SPDX-License-Identifier: MIT
#include "odas/io/report_reference.hpp"

#include <limits>

#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <sndfile.hh>

#include "odas/base/error.hpp"

namespace odas::report_reference_test {
namespace {

namespace fs = std::filesystem;

/// Three channels; frame n of channel c is c/10 + n/1000; the second frame of channel 1 is not a number.
class Ramp final : public AudioSource {
 public:
  [[nodiscard]] std::size_t channels() const noexcept override { return 3; }
  [[nodiscard]] int sample_rate() const noexcept override { return 8000; }
  [[nodiscard]] bool live() const noexcept override { return false; }
  [[nodiscard]] std::optional<std::uint64_t> total_frames() const noexcept override { return 10; }
  [[nodiscard]] ReadResult read(GridView<float> block) override {
    ReadResult result;
    while (at_ < 10 && result.frames < block.cols()) {
      for (std::size_t c = 0; c < 3; ++c) {
        block[c][result.frames] = static_cast<float>(c) / 10 + static_cast<float>(at_) / 1000;
      }
      if (at_ == 1) block[1][result.frames] = std::numeric_limits<float>::quiet_NaN();
      ++at_;
      ++result.frames;
    }
    result.end = at_ == 10;
    return result;
  }
  [[nodiscard]] std::string warning() const override { return "odd"; }

 private:
  std::size_t at_ = 0;
};

TEST(ReferenceTap, keeps_its_channel_and_passes_all_on) {
  const test::Scratch scratch;
  const fs::path file = scratch / "reference.wav";
  Ramp ramp;
  ReferenceTap tap(ramp, 1, file);
  EXPECT_EQ(tap.channels(), 3U);
  EXPECT_EQ(tap.sample_rate(), 8000);
  EXPECT_EQ(tap.total_frames(), 10U);
  EXPECT_EQ(tap.warning(), "odd");
  Grid<float> block(3, 4);
  std::size_t frames = 0;
  for (bool end = false; !end;) {
    const ReadResult result = tap.read(block);
    frames += result.frames;
    end = result.end;
  }
  ASSERT_TRUE(tap.close().ok());
  EXPECT_EQ(frames, 10U);
  EXPECT_FLOAT_EQ(block[2][1], 0.209F);  // the last frame, in the source's own channel

  SndfileHandle sound(file.string());
  ASSERT_EQ(sound.frames(), 10);
  std::array<float, 10> heard{};
  sound.readf(heard.data(), 10);
  EXPECT_NEAR(heard[0], 0.1F, 1e-4F);
  EXPECT_EQ(heard[1], 0.0F);
  EXPECT_NEAR(heard[9], 0.109F, 1e-4F);
}

TEST(ReferenceTap, ends_the_recording_when_the_disk_is_full) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  class Endless final : public AudioSource {
   public:
    [[nodiscard]] std::size_t channels() const noexcept override { return 1; }
    [[nodiscard]] int sample_rate() const noexcept override { return 8000; }
    [[nodiscard]] bool live() const noexcept override { return false; }
    [[nodiscard]] ReadResult read(GridView<float> block) override { return {block.cols(), false, {}}; }
  } source;
  Grid<float> block(1, 8000);
  std::string fault;
  try {
    ReferenceTap tap(source, 0, "/dev/full");
    for (int i = 0; i < 100 && fault.empty(); ++i) fault = tap.read(block).status.what();
  } catch (const IoError& error) { fault = error.what(); }
  EXPECT_NE(fault.find("/dev/full"), std::string::npos) << fault;
}

}  // namespace
}  // namespace odas::report_reference_test
