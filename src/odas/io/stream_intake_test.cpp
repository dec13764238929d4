// SPDX-License-Identifier: MIT
#include "odas/io/stream_intake.hpp"

#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <sndfile.hh>

namespace odas::stream_intake_test {
namespace {

std::string object(int stamp) {
  return "{\n    \"timeStamp\": " + std::to_string(stamp) +
         ",\n    \"src\": [\n        { \"id\": 1, \"tag\": \"dynamic\", \"x\": 0.641, \"y\": 0.688, \"z\": "
         "0.341, "
         "\"activity\": 0.500 }\n    ]\n}\n";
}

class TextIntakeTest : public ::testing::Test {
 protected:
  void take(std::string_view text) { EXPECT_TRUE(intake_.take(text).ok()); }

  std::vector<HopIndex> stamps_;
  std::vector<std::string> said_;
  TextIntake intake_{StreamKind::tracks,
                     [this](const StreamRecord& record, std::string_view) {
                       stamps_.push_back(record.time);
                       return IoStatus();
                     },
                     [this](const std::string& what) { said_.push_back(what); }};
};

TEST_F(TextIntakeTest, takes_every_hop_at_once_and_counts_those_that_are_missing) {
  const std::string stream = object(1) + object(2) + object(5);
  for (const char byte : stream.substr(0, stream.size() - 1)) take({&byte, 1});
  EXPECT_EQ(stamps_, (std::vector<HopIndex>{1, 2, 5})) << "the last one does not wait for the next";
  EXPECT_EQ(intake_.amount(), "3 hops, 2 missing");
  EXPECT_TRUE(said_.empty());
}

TEST_F(TextIntakeTest, says_nonsense_once_and_goes_on) {
  take("GET / HTTP/1.1\r\n\r\n");
  take(object(1) + "\x01\x02\x03" + object(2) + "{\"timeStamp\": 3}" + object(4));
  EXPECT_EQ(stamps_, (std::vector<HopIndex>{1, 2, 4}));
  ASSERT_EQ(said_.size(), 1U);
  EXPECT_TRUE(said_[0].starts_with("what came is no JSON object: \"GET / HTTP/1.1\\x0d\\x0a\\x0d\\x0a\"; "))
      << said_[0];
  EXPECT_EQ(intake_.amount(), "3 hops, 1 missing, 3 pieces of nonsense");
}

TEST_F(TextIntakeTest, knows_the_fault_of_a_fortified_ODAS) {
  take("}\n}\n}\n");
  ASSERT_EQ(said_.size(), 1U);
  EXPECT_NE(said_[0].find("_FORTIFY_SOURCE"), std::string::npos) << said_[0];
}

class AudioIntakeTest : public ::testing::Test {
 protected:
  AudioIntake make(const WavWriter::Format& format) {
    return {
        format,
        [this](const WavWriter::Format& of) { return std::make_unique<WavWriter>(scratch_ / "a.wav", of); },
        [this](const std::string& what) { said_.push_back(what); }};
  }

  test::Scratch scratch_;
  std::vector<std::string> said_;
};

TEST_F(AudioIntakeTest, channels_never_slip_however_the_sound_is_chopped) {
  std::vector<std::int16_t> samples;  // the value says which channel, and which sample
  for (std::int16_t i = 0; i < 500; ++i) {
    for (std::int16_t channel = 0; channel < 3; ++channel)
      samples.push_back(static_cast<std::int16_t>(10 * i + channel));
  }
  const std::span<const char> bytes(reinterpret_cast<const char*>(samples.data()), 2 * samples.size());
  AudioIntake intake = make({16000, 3, 16});
  std::size_t at = 0;
  for (std::size_t size = 1; at < bytes.size(); size = size * 3 % 31 + 1) {
    const std::size_t count = std::min(size, bytes.size() - at);
    EXPECT_TRUE(intake.take(bytes.subspan(at, count)).ok());
    at += count;
  }
  EXPECT_EQ(intake.amount(), "0.0 s");
  EXPECT_TRUE(intake.close().ok());
  EXPECT_TRUE(said_.empty());
  SndfileHandle file((scratch_ / "a.wav").string());
  ASSERT_EQ(file.channels(), 3);
  std::vector<std::int16_t> read(samples.size() + 10);
  ASSERT_EQ(file.readf(read.data(), 600), 500);
  read.resize(samples.size());
  EXPECT_EQ(read, samples);
}

TEST_F(AudioIntakeTest, a_sample_that_was_cut_off_is_left_out_and_said) {
  AudioIntake intake = make({16000, 4, 16});
  EXPECT_TRUE(intake.take(std::vector<char>(8 * 16000 + 3)).ok());
  EXPECT_EQ(intake.amount(), "1.0 s");
  EXPECT_EQ(intake.file(), "a.wav");
  EXPECT_TRUE(intake.close().ok());
  ASSERT_EQ(said_.size(), 1U);
  EXPECT_NE(said_[0].find("last 3 bytes"), std::string::npos) << said_[0];
  EXPECT_EQ(SndfileHandle((scratch_ / "a.wav").string()).frames(), 16000);
}

TEST_F(AudioIntakeTest, eight_bits_become_unsigned_as_WAV_has_them) {
  AudioIntake intake = make({16000, 1, 8});
  const std::array<char, 3> samples{0, 127, -128};
  EXPECT_TRUE(intake.take(samples).ok());
  EXPECT_TRUE(intake.close().ok());
  EXPECT_EQ(test::wav_samples(scratch_ / "a.wav"), std::string("\x80\xFF\x00", 3));
}

TEST_F(AudioIntakeTest, text_is_said_and_makes_no_file) {
  AudioIntake intake = make({16000, 4, 16});
  EXPECT_TRUE(intake.take(object(1)).ok());
  EXPECT_TRUE(intake.take(object(2)).ok());
  EXPECT_TRUE(intake.close().ok());
  ASSERT_EQ(said_.size(), 1U);
  EXPECT_NE(said_[0].find("is text and no sound"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(scratch_ / "a.wav"));
}

TEST_F(AudioIntakeTest, nothing_makes_no_file) {
  AudioIntake intake = make({16000, 4, 16});
  EXPECT_TRUE(intake.flush().ok());
  EXPECT_TRUE(intake.close().ok());
  EXPECT_FALSE(std::filesystem::exists(scratch_ / "a.wav"));
}

}  // namespace
}  // namespace odas::stream_intake_test
