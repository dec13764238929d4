// SPDX-License-Identifier: MIT
#include "odas/scene/heard_voices.hpp"

#include <fstream>

#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <sndfile.hh>

#include "odas/base/error.hpp"

namespace odas::heard_voices_test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kHop = 4;

class HeardVoices : public ::testing::Test {
 protected:
  /// Hops of 4 samples; each sample says hop, place in the hop and channel: 1000 h + 10 n + c.
  [[nodiscard]] fs::path raw(std::size_t hops, std::size_t channels) const {
    std::ofstream out(folder_ / "separated.raw", std::ios::binary);
    for (std::size_t h = 0; h < hops; ++h) {
      for (std::size_t n = 0; n < kHop; ++n) {
        for (std::size_t c = 0; c < channels; ++c) {
          const auto value = static_cast<std::uint16_t>(-static_cast<int>(1000 * h + 10 * n + c));
          out.put(static_cast<char>(value & 255U)).put(static_cast<char>(value >> 8U));
        }
      }
    }
    return folder_ / "separated.raw";
  }

  static float sample(const VoiceOf& voice, std::size_t hop, const HeardTrack& track, std::size_t n) {
    std::vector<float> out(kHop, 99.F);
    voice(hop, track, out);
    return out[n] * 32768;
  }

  test::Scratch scratch_;
  fs::path folder_ = scratch_.folder();
};

TEST_F(HeardVoices, of_raw_files_are_the_channel_of_the_slot) {
  const auto voice = raw_voices(raw(6, 4), {kHop, 4, 6});
  EXPECT_EQ(sample(voice, 5, {2, 9, {}}, 3), -5032);
  EXPECT_EQ(sample(voice, 0, {0, 9, {}}, 1), -10);
}

TEST_F(HeardVoices, know_the_channels_of_a_raw_file_though_the_tracks_show_one_slot_alone) {
  const auto voice = raw_voices(raw(6, 4), {kHop, 1, 6});
  EXPECT_EQ(sample(voice, 5, {0, 9, {}}, 3), -5030);
}

TEST_F(HeardVoices, are_silent_beyond_the_end_of_a_raw_file_and_in_slots_that_it_has_not) {
  const auto voice = raw_voices(raw(5, 2), {kHop, 2, 6});
  EXPECT_EQ(sample(voice, 4, {1, 9, {}}, 0), -4001);
  EXPECT_EQ(sample(voice, 5, {1, 9, {}}, 0), 0);
  EXPECT_EQ(sample(voice, 1, {2, 9, {}}, 0), 0);
}

TEST_F(HeardVoices, of_an_empty_raw_file_are_none) { EXPECT_FALSE(raw_voices(raw(0, 4), {kHop, 4, 6})); }

TEST_F(HeardVoices, of_a_folder_begin_where_its_index_says) {
  KnownScene scene;
  scene.hop_size = kHop;
  SndfileHandle wav((folder_ / "source_7.wav").string(), SFM_WRITE, SF_FORMAT_WAV | SF_FORMAT_PCM_16, 1,
                    16000);
  std::vector<short> samples(400);
  for (std::size_t n = 0; n < samples.size(); ++n) samples[n] = static_cast<short>(n);
  wav.write(samples.data(), 400);
  wav = SndfileHandle();
  std::ofstream(folder_ / "index.json") << R"([{"id": 7, "file": "source_7.wav", "start": 0.001}])";
  const auto voice = voices_by_id(folder_, scene);
  // It begins with sample 16: hop 10 is samples 40 .. 43 of the recording.
  EXPECT_NEAR(sample(voice, 10, {0, 7, {}}, 3), 43 - 16, 0.01);
  EXPECT_EQ(sample(voice, 3, {0, 7, {}}, 3), 0);
  EXPECT_EQ(sample(voice, 200, {0, 7, {}}, 0), 0);
  EXPECT_EQ(sample(voice, 10, {0, 8, {}}, 3), 0);
}

TEST_F(HeardVoices, need_an_index_that_can_be_read_and_the_files_it_names) {
  EXPECT_THROW(static_cast<void>(voices_by_id(folder_, {})), IoError);
  std::ofstream(folder_ / "index.json") << "[{\"id\": 7";
  EXPECT_THROW(static_cast<void>(voices_by_id(folder_, {})), IoError);
  std::ofstream(folder_ / "index.json") << R"([{"id": 7, "file": "gone.wav", "start": 0}])";
  EXPECT_THROW(static_cast<void>(voices_by_id(folder_, {})), IoError);
}

}  // namespace
}  // namespace odas::heard_voices_test
