// SPDX-License-Identifier: MIT
#include "odas/io/report_audio.hpp"

#include <fstream>
#include <sstream>

#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <sndfile.hh>

#include "odas/base/error.hpp"

namespace odas::report_audio_test {
namespace {

namespace fs = std::filesystem;

std::string base64(const std::string& bytes) {
  const test::Scratch scratch;
  const fs::path file = scratch / "bytes";
  std::ofstream(file, std::ios::binary) << bytes;
  std::ostringstream out;
  write_base64(out, file);
  return out.str();
}

TEST(Base64, agrees_with_the_vectors_of_rfc_4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\x80"), "//6A");
}

TEST(Base64, pads_only_at_the_end_of_a_file_of_many_blocks) {
  const std::string text = base64(std::string(3 * 4096 * 2 + 1, 'x'));
  EXPECT_EQ(text.size(), 4U * (4096 * 2 + 1));
  EXPECT_EQ(text.find('='), text.size() - 2);
}

TEST(Base64, throws_when_the_file_is_missing) {
  std::ostringstream out;
  EXPECT_THROW(write_base64(out, test::Scratch() / "missing"), IoError);
}

TEST(Waveform, holds_the_largest_sample_of_each_stretch) {
  const test::Scratch scratch;
  const fs::path file = scratch / "wave.wav";
  {
    SndfileHandle sound(file.string(), SFM_WRITE, SF_FORMAT_WAV | SF_FORMAT_PCM_16, 1, 8000);
    std::vector<float> samples(8000, 0.0F);
    samples[100] = -0.5F;
    samples[7999] = 0.25F;
    sound.writef(samples.data(), 8000);
  }
  const Waveform w = waveform_of(file, 10);
  EXPECT_DOUBLE_EQ(w.seconds, 1.0);
  EXPECT_NEAR(w.peak, 0.5F, 1e-3F);
  ASSERT_EQ(w.peaks.size(), 10U);
  EXPECT_NEAR(w.peaks[0], 0.5F, 1e-3F);
  EXPECT_EQ(w.peaks[5], 0.0F);
  EXPECT_NEAR(w.peaks[9], 0.25F, 1e-3F);
}

TEST(Waveform, of_no_sound_is_empty) {
  const test::Scratch scratch;
  const fs::path file = scratch / "empty.wav";
  { const SndfileHandle sound(file.string(), SFM_WRITE, SF_FORMAT_WAV | SF_FORMAT_PCM_16, 1, 8000); }
  const Waveform w = waveform_of(file, 10);
  EXPECT_EQ(w.peak, 0.0F);
  EXPECT_TRUE(w.peaks.empty());
}

}  // namespace
}  // namespace odas::report_audio_test
