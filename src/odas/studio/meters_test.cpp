// SPDX-License-Identifier: MIT
#include "odas/studio/meters.hpp"

#include "support/fake_io.hpp"
#include <gtest/gtest.h>

namespace odas::meters_test {
namespace {

/// A second and a bit of three microphones, of which `spoil` makes what it likes of each hop of 160.
template <class Spoil>
MeterReading last_reading(Spoil&& spoil) {
  MicMeters meters(3, 16000);
  MeterReading reading;
  for (unsigned h = 0; h < 120; ++h) {
    Grid<float> mics = test::noise(3, 160, h + 1);
    spoil(mics);
    if (meters.add(mics)) reading = meters.take(h);
  }
  return reading;
}

TEST(MicMeters, measure_levels) {
  const MeterReading reading = last_reading([](Grid<float>& mics) {
    for (std::size_t n = 0; n < mics.cols(); ++n) mics[1][n] = n % 2 == 0 ? 0.5F : -0.5F;
  });
  ASSERT_EQ(reading.mics.size(), 3U);
  EXPECT_NEAR(reading.mics[1].rms_db, -6.02F, 0.01F);
  EXPECT_NEAR(reading.mics[1].peak_db, -6.02F, 0.01F);
  for (const auto& mic : reading.mics) EXPECT_EQ(mic.flags, 0);
}

TEST(MicMeters, know_a_dead_a_duplicate_and_a_clipped_microphone) {
  const MeterReading reading = last_reading([](Grid<float>& mics) {
    std::copy(mics[0].begin(), mics[0].end(), mics[1].begin());
    mics[0][3] = mics[1][3] = 1;
    std::fill(mics[2].begin(), mics[2].end(), 0.25F);
  });
  EXPECT_EQ(reading.mics[0].flags, MeterReading::clipped);
  EXPECT_EQ(reading.mics[1].flags, MeterReading::clipped | MeterReading::duplicate);
  EXPECT_EQ(reading.mics[1].same_as, 1);
  EXPECT_EQ(reading.mics[2].flags, MeterReading::dead);
}

TEST(MicMeters, call_nothing_dead_where_all_are_still) {
  const MeterReading reading = last_reading([](Grid<float>& mics) { mics.fill(0); });
  for (const auto& mic : reading.mics) {
    EXPECT_EQ(mic.flags, 0);
    EXPECT_EQ(mic.rms_db, -120);
  }
}

}  // namespace
}  // namespace odas::meters_test
