// SPDX-License-Identifier: MIT
#include "odas/pipeline/lookback.hpp"

#include <array>

#include <gtest/gtest.h>

namespace odas::lookback_test {
namespace {

Track track(std::uint64_t id, float x) {
  Track out;
  out.id = id;
  out.direction = {x, 0, 1};
  return out;
}

/// A hop whose only bin is `value`, and what is heard of the hops ago.
float heard(LookBack& lookback, float value) {
  lookback.begin_hop()[0][0] = value;
  return lookback.spectra()[0][0].real();
}

TEST(LookBack, of_no_hops_is_the_hop_itself) {
  LookBack lookback(0, 1, 1, 1);
  for (const float x : {1.F, 2.F, 3.F}) {
    EXPECT_EQ(heard(lookback, x), x);
    EXPECT_EQ(lookback.recall(std::array{track(1, x)})[0].direction.x, x);
  }
}

TEST(LookBack, gives_the_spectra_of_so_many_hops_ago_and_silence_before) {
  LookBack lookback(3, 1, 1, 0);
  for (int hop = 1; hop < 12; ++hop) {
    EXPECT_EQ(heard(lookback, static_cast<float>(hop)), static_cast<float>(std::max(hop - 3, 0)));
  }
}

TEST(LookBack, hears_a_new_track_where_it_was_first_and_then_follows_it) {
  LookBack lookback(2, 1, 1, 1);
  // now:   -    -    5    6    7    8    9   gone
  // then:  -    -    5    5    5    6    7   gone
  const std::array now{track(0, 0), track(0, 0), track(4, 5), track(4, 6), track(4, 7), track(4, 8)};
  const std::array then{0.F, 0.F, 5.F, 5.F, 5.F, 6.F};
  for (std::size_t hop = 0; hop < now.size(); ++hop) {
    lookback.begin_hop();
    const auto tracks = lookback.recall({&now[hop], 1});
    EXPECT_EQ(tracks[0].id, now[hop].id);
    EXPECT_EQ(tracks[0].direction.x, then[hop]) << hop;
  }
  lookback.begin_hop();
  EXPECT_EQ(lookback.recall(std::array{track(0, 0)})[0].id, 0U) << "what is gone now is not heard";
}

TEST(LookBack, does_not_give_a_track_the_place_of_the_one_before_in_its_slot) {
  LookBack lookback(2, 1, 1, 1);
  for (const Track& now : {track(4, 1), track(4, 1), track(5, 9), track(5, 8)}) {
    lookback.begin_hop();
    EXPECT_EQ(lookback.recall({&now, 1})[0].direction.x, now.id == 4 ? 1 : 9);
  }
}

TEST(LookBack, after_reset_is_as_new) {
  LookBack lookback(2, 1, 1, 1);
  for (int hop = 0; hop < 5; ++hop) {
    heard(lookback, 7);
    (void)lookback.recall(std::array{track(4, 7)});
  }
  lookback.reset();
  EXPECT_EQ(heard(lookback, 1), 0);
  EXPECT_EQ(lookback.recall(std::array{track(4, 3)})[0].direction.x, 3);
}

}  // namespace
}  // namespace odas::lookback_test
