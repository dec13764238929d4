// SPDX-License-Identifier: MIT
#include "odas/io/alsa_pcm.hpp"

#include <cerrno>

#include <gtest/gtest.h>

namespace odas::alsa_pcm_test {
namespace {

TEST(AlsaPcm, says_why_it_cannot_be_opened) {
  int error = 0;
  EXPECT_EQ(open_alsa("hw:CARD=NoSuchCard,DEV=0", error), nullptr);
  EXPECT_LT(error, 0);
  EXPECT_NE(alsa_error(error), "");
}

// ALSA's own "null" is a card that always hears silence.
TEST(AlsaPcm, captures_in_any_format_and_number_of_channels) {
  for (const SampleFormat format : {SampleFormat::s16, SampleFormat::s24, SampleFormat::s24_3,
                                    SampleFormat::s32, SampleFormat::f32, SampleFormat::s8}) {
    int error = 0;
    const auto pcm = open_alsa("null", error);
    if (!pcm) GTEST_SKIP() << "no configuration of ALSA here: " << alsa_error(error);
    const CaptureOffer offer = pcm->offer(8, 16000);
    EXPECT_TRUE(offer.has_channels(8));
    EXPECT_TRUE(offer.has_rate(16000));
    ASSERT_EQ(offer.formats.size(), kSampleFormats);
    EXPECT_EQ(offer.formats.front(), SampleFormat::s32) << "the best first";
    ASSERT_EQ(pcm->configure(format, 8, 16000, 128), 0) << name_of(format);
    ASSERT_EQ(pcm->start(), 0);
    std::vector<char> bytes(std::size_t{128} * 8 * bytes_of(format), 'x');
    EXPECT_EQ(pcm->read(bytes.data(), 128), 128);
    EXPECT_EQ(pcm->recover(-EPIPE), 0);
    EXPECT_EQ(pcm->start(), 0);
  }
}

}  // namespace
}  // namespace odas::alsa_pcm_test
