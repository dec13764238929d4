// SPDX-License-Identifier: MIT
#include "odas/engine/hop_record.hpp"

#include "support/allocation_counter.hpp"
#include "support/fake_io.hpp"
#include <gtest/gtest.h>

namespace odas::hop_record_test {
namespace {

test::HopOfHand some_hop(const PipelineConfig& config) {
  const std::size_t slots = config.sst.slots();
  const auto size = static_cast<std::size_t>(config.general.size.hop_size);
  test::HopOfHand hop;
  hop.potentials.resize(static_cast<std::size_t>(config.ssl.n_pots));
  hop.potentials[0].energy = 0.5F;
  hop.tracks.resize(slots);
  hop.tracks[1].id = 42;
  hop.separated = test::noise(slots, size);
  hop.postfiltered = test::noise(slots, size, 2);
  return hop;
}

TEST(HopRecord, holds_a_copy_of_what_is_wanted) {
  const PipelineConfig config = test::small_configuration().pipeline;
  HopRecord record({true, true, true, true}, config);
  test::HopOfHand hop = some_hop(config);
  record.assign(hop.result(9));
  const Grid<float> separated = hop.separated;
  hop.separated.fill(0);
  hop.tracks[1].id = 0;
  const HopResult view = record.view();
  EXPECT_EQ(view.time, 9U);
  EXPECT_EQ(view.potentials[0].energy, 0.5F);
  EXPECT_EQ(view.tracks[1].id, 42U);
  EXPECT_EQ(view.separated[1][5], separated[1][5]);
  EXPECT_EQ(view.postfiltered[1][5], hop.postfiltered[1][5]);
}

TEST(HopRecord, holds_microphones_power_map_and_reports_where_they_are_wanted) {
  const PipelineConfig config = test::small_configuration().pipeline;
  HopRecord record({.mics = true, .power_map = true, .reports = true}, config, 3);
  const Grid<float> mics =
      test::noise(config.general.mics.size(), static_cast<std::size_t>(config.general.size.hop_size));
  const std::vector<float> power{0.1F, 0.2F, 0.3F};
  test::HopOfHand hop = some_hop(config);
  HopResult result = hop.result(1);
  result.mics = mics;
  result.power = power;
  std::vector<BeamReport> reports(config.sst.slots());
  reports[1] = {12, 5, 20, 42};
  result.reports = reports;
  record.assign(result);
  EXPECT_EQ(record.view().mics[1][7], mics[1][7]);
  EXPECT_TRUE(std::equal(power.begin(), power.end(), record.view().power.begin()));
  EXPECT_EQ(record.view().reports[1].id, 42U);
  EXPECT_EQ(record.view().reports[1].snr_db, 12);
}

TEST(HopRecord, has_no_room_for_what_nobody_wants) {
  const PipelineConfig config = test::small_configuration().pipeline;
  HopRecord record({false, true, false, false}, config);
  record.assign(some_hop(config).result(1));
  const HopResult view = record.view();
  EXPECT_TRUE(view.potentials.empty());
  EXPECT_TRUE(view.separated.empty());
  EXPECT_EQ(view.tracks.size(), config.sst.slots());
}

TEST(HopRecord, allocates_nothing_for_a_hop) {
  const PipelineConfig config = test::small_configuration().pipeline;
  HopRecord record({true, true, true, true}, config);
  const test::HopOfHand hop = some_hop(config);
  const auto before = test::allocations();
  record.assign(hop.result(1));
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace odas::hop_record_test
