// SPDX-License-Identifier: MIT
#include "odas/io/record_sink.hpp"

#include "support/fake_io.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "odas/io/file_writer.hpp"

namespace odas::record_sink_test {
namespace {

TEST(RecordSink, writes_a_record_for_each_hop) {
  const test::Scratch scratch;
  RecordSink sink("ssl.potential", make_odas_json_potentials(),
                  std::make_unique<FileWriter>(scratch / "pots"));
  const test::HopOfHand hop;
  EXPECT_TRUE(sink.write(hop.result(1)).ok());
  EXPECT_TRUE(sink.flush().ok());
  const std::string first = test::content(scratch / "pots");
  EXPECT_TRUE(sink.write(hop.result(2)).ok());
  EXPECT_TRUE(sink.close().ok());
  EXPECT_EQ(first, "{\n    \"timeStamp\": 1,\n    \"src\": [\n    ]\n}\n");
  EXPECT_EQ(test::content(scratch / "pots"), first + "{\n    \"timeStamp\": 2,\n    \"src\": [\n    ]\n}\n");
}

TEST(RecordSink, says_its_name_and_wants_what_its_encoder_reads) {
  const test::Scratch scratch;
  const RecordSink sink("sst.tracked", make_odas_json_tracks(), std::make_unique<FileWriter>(scratch / "t"));
  EXPECT_EQ(sink.name(), "sst.tracked (" + (scratch / "t").string() + ")");
  EXPECT_TRUE(sink.wanted().tracks);
  EXPECT_FALSE(sink.wanted().potentials || sink.wanted().separated || sink.wanted().postfiltered);
}

}  // namespace
}  // namespace odas::record_sink_test
