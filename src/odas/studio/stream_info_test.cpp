// SPDX-License-Identifier: MIT
#include "odas/studio/stream_info.hpp"

#include "support/studio_parts.hpp"
#include <gtest/gtest.h>

namespace odas::stream_info_test {
namespace {

TEST(StreamInfo, says_what_a_document_is_as_a_run) {
  const CheckedDocument checked = check_document(test::sample_document(), Outputs::network);
  const StreamInfo info = stream_info(checked);
  EXPECT_EQ(info.name, "sample");
  EXPECT_EQ(info.sample_rate, checked.config.pipeline.general.samplerate.mu);
  EXPECT_EQ(info.mics.size(), 4U);
  EXPECT_EQ(info.channels.size(), info.mics.size());
  EXPECT_EQ(info.slots, checked.pipeline->slots());
  EXPECT_EQ(info.config_hash, hash_of(checked.document.text));
}

TEST(StreamInfo, names_the_source_in_short) {
  RawConfig raw;
  raw.interface.type = "file";
  raw.interface.path = "recordings/meeting.wav";
  EXPECT_EQ(source_text(raw), "meeting.wav");
}

}  // namespace
}  // namespace odas::stream_info_test
