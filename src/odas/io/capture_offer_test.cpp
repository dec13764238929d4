// SPDX-License-Identifier: MIT
#include "odas/io/capture_offer.hpp"

#include <gtest/gtest.h>

namespace odas::capture_offer_test {
namespace {

using F = SampleFormat;

const CaptureOffer kEight{{F::s24_3, F::s16}, {}, 8, 8, {8}, 16000, 48000, {16000, 48000}};

RawConfig raw_of(int channels, int rate, int bits, const std::string& format = "") {
  RawConfig raw;
  raw.n_channels = channels;
  raw.fs = rate;
  raw.n_bits = bits;
  raw.format = format;
  return raw;
}

TEST(CaptureOffer, is_taken_by_what_raw_says) {
  EXPECT_EQ(choose_format(raw_of(8, 16000, 16), kEight), F::s16);
  EXPECT_EQ(choose_format(raw_of(8, 16000, 24), kEight), F::s24_3);
  EXPECT_EQ(choose_format(raw_of(8, 16000, 32), kEight), std::nullopt);
  EXPECT_EQ(choose_format(raw_of(8, 16000, 32, "S24_3LE"), kEight), F::s24_3) << "the format rules";
  EXPECT_EQ(choose_format(raw_of(8, 16000, 16, "auto"), kEight), F::s24_3) << "the best";
  EXPECT_EQ(choose_format(raw_of(8, 16000, 24, "S24_LE"), kEight), std::nullopt);
  CaptureOffer bytes = kEight;
  bytes.formats = {F::u8};
  EXPECT_EQ(choose_format(raw_of(8, 16000, 8), bytes), F::u8);
}

TEST(CaptureOffer, names_only_what_does_not_fit) {
  EXPECT_EQ(misfit("hw:1,0", raw_of(8, 48000, 24), kEight), "");
  EXPECT_EQ(misfit("hw:1,0", raw_of(4, 48000, 24), kEight),
            "hw:1,0 offers something else: raw.nChannels is 4, it has 8. In raw, write: nChannels = 8;");
  EXPECT_EQ(misfit("hw:1,0", raw_of(8, 8000, 32), kEight),
            "hw:1,0 offers something else: raw.fS is 8000, it has 16000, 48000 Hz; raw.nBits is 32, it has "
            "S24_3LE, S16_LE. In raw, write: fS = 16000; format = \"S24_3LE\";");
  EXPECT_EQ(
      misfit("hw:1,0", raw_of(8, 16000, 16, "FLOAT_LE"), kEight),
      "hw:1,0 offers something else: raw.format is \"FLOAT_LE\", it has S24_3LE, S16_LE. In raw, write: "
      "format = \"S24_3LE\";");
}

TEST(CaptureOffer, has_gaps_between_the_least_and_the_most) {
  EXPECT_FALSE(kEight.has_rate(44100)) << "it was asked for";
  EXPECT_TRUE(kEight.has_rate(20000)) << "nobody has asked for it: it may be";
  CaptureOffer offer = kEight;
  offer.min_channels = 2;
  offer.channels = {2, 8};
  EXPECT_FALSE(offer.has_channels(4));
  EXPECT_EQ(
      misfit("hw:1,0", raw_of(4, 44100, 16), offer),
      "hw:1,0 offers something else: raw.nChannels is 4, it has 2, 8; raw.fS is 44100, it has 16000, 48000 "
      "Hz. In raw, write: nChannels = 8; fS = 48000;");
}

TEST(CaptureOffer, proposes_a_section_that_fits_it) {
  EXPECT_EQ(propose_raw(kEight, "type = \"soundcard_name\"; devicename = \"hw:CARD=Array,DEV=0\";"),
            "raw: {\n"
            "  fS = 16000;\n"
            "  format = \"S24_3LE\";\n"
            "  nChannels = 8;\n"
            "  interface: { type = \"soundcard_name\"; devicename = \"hw:CARD=Array,DEV=0\"; };\n"
            "};\n");
}

TEST(CaptureOffer, proposes_no_number_of_channels_for_a_plug_in_that_takes_any) {
  CaptureOffer pulse = kEight;
  pulse.channels.clear();
  pulse.min_channels = 1;
  pulse.max_channels = 32;
  pulse.min_rate = 1;
  pulse.max_rate = 384000;
  const std::string raw = propose_raw(pulse, "type = \"soundcard_name\"; devicename = \"pulse\";");
  EXPECT_NE(raw.find("nChannels = 1;  # as many as the microphone behind it has\n"), std::string::npos)
      << raw;
}

TEST(CaptureOffer, tells_of_formats_that_odas_cannot_read) {
  CaptureOffer offer = kEight;
  offer.formats.clear();
  offer.other_formats = {"S16_BE", "DSD_U8"};
  EXPECT_EQ(formats_text(offer), "S16_BE, DSD_U8 (which odas cannot read)");
}

}  // namespace
}  // namespace odas::capture_offer_test
