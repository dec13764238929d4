// SPDX-License-Identifier: MIT
#include "odas/dsp/echo_canceller.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "support/allocation_counter.hpp"
#include <gtest/gtest.h>

namespace odas::echo_canceller_test {
namespace {

constexpr int kRate = 16000;
constexpr std::size_t kHop = 128;
constexpr std::size_t kMics = 2;
constexpr std::size_t kLength = 4800;  // 300 ms

using Signal = std::vector<float>;

/// Coloured noise in syllables of a quarter of a second, with pauses: as uneven as speech.
Signal babble(double seconds, unsigned seed, float level = 0.1F) {
  std::mt19937 random(seed);
  std::normal_distribution<float> normal;
  Signal x(static_cast<std::size_t>(seconds * kRate));
  float loudness = 0;
  float low = 0;
  for (std::size_t n = 0; n < x.size(); ++n) {
    if (n % 4000 == 0) loudness = level * std::abs(normal(random));
    low = 0.8F * low + 0.6F * normal(random);
    x[n] = loudness * low;
  }
  return x;
}

/// The echo of a room with a reverberation time of 0.3 s, 0 dB in all. Of the taps of 150 ms every 48th is
/// there: more make no other room, but a slow test.
Signal through_room(const Signal& x, std::size_t delay, unsigned seed) {
  constexpr std::size_t kStep = 48;
  std::mt19937 random(seed);
  std::normal_distribution<float> normal;
  Signal taps(50);
  float power = 0;
  for (std::size_t n = 0; n < taps.size(); ++n) {
    taps[n] = normal(random) * std::exp(-6.9F * static_cast<float>(kStep * n) / 4800);
    power += taps[n] * taps[n];
  }
  Signal y(x.size());
  for (std::size_t t = 0; t < taps.size(); ++t) {
    const float tap = taps[t] / std::sqrt(power);
    for (std::size_t n = delay + kStep * t; n < y.size(); ++n) y[n] += tap * x[n - delay - kStep * t];
  }
  return y;
}

struct Room {
  Signal played;
  std::vector<Signal> echo = std::vector<Signal>(kMics);
  std::vector<Signal> others = std::vector<Signal>(kMics);
  std::vector<Signal> left = std::vector<Signal>(kMics);  // what comes out

  explicit Room(double seconds, std::size_t delay = 0, unsigned path = 10) : played(babble(seconds, 1)) {
    for (std::size_t m = 0; m < kMics; ++m) {
      echo[m] = through_room(played, delay, path + static_cast<unsigned>(m));
      others[m].resize(played.size());
      left[m].resize(played.size());
    }
  }

  void run(EchoCanceller& canceller) {
    Grid<float> reference(1, kHop);
    Grid<float> mics(kMics, kHop);
    for (std::size_t at = 0; at + kHop <= played.size(); at += kHop) {
      for (std::size_t i = 0; i < kHop; ++i) {
        reference[0][i] = played[at + i];
        for (std::size_t m = 0; m < kMics; ++m) mics[m][i] = echo[m][at + i] + others[m][at + i];
      }
      canceller.cancel(reference, mics);
      for (std::size_t m = 0; m < kMics; ++m) std::copy_n(mics[m].data(), kHop, left[m].data() + at);
    }
  }

  /// Of the echo alone, whatever others say: echo to what is left of it, dB, from second `from` to `to`.
  [[nodiscard]] double return_loss_db(double from, double to) const {
    double before = 0;
    double after = 0;
    for (std::size_t m = 0; m < kMics; ++m) {
      for (auto n = static_cast<std::size_t>(from * kRate); n < static_cast<std::size_t>(to * kRate); ++n) {
        before += std::pow(echo[m][n], 2);
        after += std::pow(left[m][n] - others[m][n], 2);
      }
    }
    return 10 * std::log10(before / after);
  }
};

EchoCanceller canceller() { return {kMics, 1, kHop, kLength, kRate}; }

void speak(Room& room, double from, double to) {
  for (std::size_t m = 0; m < kMics; ++m) {
    const Signal talk = babble(to - from, 77 + static_cast<unsigned>(m));
    std::copy(talk.begin(), talk.end(), room.others[m].begin() + static_cast<std::ptrdiff_t>(from * kRate));
  }
}

TEST(EchoCanceller, takes_out_the_echo_of_a_room) {
  Room room(8);
  EchoCanceller echo = canceller();
  room.run(echo);
  EXPECT_GT(room.return_loss_db(1, 2), 8);
  EXPECT_GT(room.return_loss_db(5, 8), 20);
  EXPECT_GT(echo.return_loss_db(), 15) << "over the last seconds";
}

TEST(EchoCanceller, takes_out_an_echo_that_comes_late) {
  for (const unsigned path : {10U, 14U, 18U}) {
    Room room(4, 2400, path);  // 150 ms, and 150 ms of reverberation
    EchoCanceller echo = canceller();
    room.run(echo);
    EXPECT_GT(room.return_loss_db(0, 1), -1) << path;
    EXPECT_GT(room.return_loss_db(1, 2), 8) << path;
    EXPECT_GT(room.return_loss_db(3, 4), 20) << path;
  }
}

TEST(EchoCanceller, takes_out_a_tone_for_as_long_as_it_sounds) {
  Room room(8);
  for (std::size_t n = 0; n < room.played.size(); ++n) {
    const auto t = static_cast<float>(n % kRate) / kRate;
    room.played[n] = 0.1F * std::sin(2 * std::numbers::pi_v<float> * 440 * t);
  }
  for (std::size_t m = 0; m < kMics; ++m) {
    room.echo[m] = through_room(room.played, 2400, 14 + static_cast<unsigned>(m));
    room.others[m] = babble(8, 5, 1e-5F);
  }
  EchoCanceller echo = canceller();
  room.run(echo);
  for (const double from : {1., 3., 5.}) EXPECT_GT(room.return_loss_db(from, from + 3), 5) << from;
}

TEST(EchoCanceller, holds_still_while_somebody_else_speaks) {
  Room room(12);
  speak(room, 6, 9);
  EchoCanceller echo = canceller();
  room.run(echo);
  EXPECT_GT(room.return_loss_db(6.2, 9), 10) << "while both speak equally loud";
  EXPECT_GT(room.return_loss_db(9, 10), 13) << "right after";
}

TEST(EchoCanceller, follows_a_path_that_changes) {
  Room room(14);
  const Room other(14, 40, 20);
  const auto change = static_cast<std::ptrdiff_t>(7 * kRate);
  for (std::size_t m = 0; m < kMics; ++m) {
    std::copy(other.echo[m].begin() + change, other.echo[m].end(), room.echo[m].begin() + change);
  }
  EchoCanceller echo = canceller();
  room.run(echo);
  EXPECT_GT(room.return_loss_db(8, 9), 9);
  EXPECT_GT(room.return_loss_db(12, 14), 30);
}

TEST(EchoCanceller, harms_nobody_where_the_microphones_do_not_hear_the_machine) {
  Room room(6);
  for (Signal& echo : room.echo) std::fill(echo.begin(), echo.end(), 0.F);
  speak(room, 0, 6);
  EchoCanceller echo = canceller();
  room.run(echo);
  double talk = 0;
  double harm = 0;
  for (std::size_t n = kRate; n < room.played.size() / kHop * kHop; ++n) {
    talk += std::pow(room.others[0][n], 2);
    harm += std::pow(room.left[0][n] - room.others[0][n], 2);
  }
  EXPECT_LT(10 * std::log10(harm / talk), -15);
}

TEST(EchoCanceller, changes_no_bit_where_the_machine_is_silent) {
  Room room(2);
  speak(room, 0, 2);
  for (const float dead : {0.F, 1.F / 32768, std::numeric_limits<float>::quiet_NaN()}) {
    std::fill(room.played.begin(), room.played.end(), dead);
    EchoCanceller echo = canceller();
    room.run(echo);
    for (std::size_t n = 0; n < room.played.size() / kHop * kHop; ++n) {
      ASSERT_EQ(room.left[0][n], room.echo[0][n] + room.others[0][n]) << n << ", " << dead;
    }
    EXPECT_EQ(echo.return_loss_db(), 0);
  }
}

TEST(EchoCanceller, changes_no_bit_once_the_machine_has_been_silent_for_the_length_of_the_echo) {
  Room room(4);
  std::fill(room.played.begin() + 2 * kRate, room.played.end(), 0.F);
  speak(room, 0, 4);
  EchoCanceller echo = canceller();
  room.run(echo);
  const std::size_t end = 2 * kRate + kLength + 2 * kHop;
  for (std::size_t n = end; n < room.played.size() / kHop * kHop; ++n) {
    ASSERT_EQ(room.left[0][n], room.echo[0][n] + room.others[0][n]) << n;
  }
}

TEST(EchoCanceller, forgets_nothing_for_samples_that_are_not_finite) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float most = std::numeric_limits<float>::max();
  Room room(8);
  const Room sound = room;
  for (const std::size_t at : {std::size_t{4} * kRate, std::size_t{4} * kRate + 1000}) {
    room.echo[0][at] = nan;
    room.echo[1][at] = most;
    room.played[at] = std::numeric_limits<float>::infinity();
    room.played[at + 1] = most;
  }
  EchoCanceller echo = canceller();
  room.run(echo);
  EXPECT_TRUE(std::isnan(room.left[0][4 * kRate]));
  EXPECT_EQ(room.left[1][4 * kRate], most);
  EXPECT_GT(room.return_loss_db(6, 8), 18);
}

TEST(EchoCanceller, is_new_after_a_reset_and_the_same_each_time) {
  Room room(2);
  EchoCanceller echo = canceller();
  room.run(echo);
  const auto first = room.left;
  echo.reset();
  EXPECT_EQ(echo.return_loss_db(), 0);
  room.run(echo);
  EXPECT_EQ(room.left, first);
  EchoCanceller other = canceller();
  room.run(other);
  EXPECT_EQ(room.left, first);
}

TEST(EchoCanceller, takes_hops_and_lengths_of_any_size_and_two_references) {
  constexpr std::size_t kOddHop = 75;
  EchoCanceller echo(1, 2, kOddHop, 1, kRate);
  const Signal left = babble(4, 3);
  const Signal right = babble(4, 4);
  Grid<float> references(2, kOddHop);
  Grid<float> mic(1, kOddHop);
  double before = 0;
  double after = 0;
  for (std::size_t at = 0; at + kOddHop <= left.size(); at += kOddHop) {
    for (std::size_t i = 0; i < kOddHop; ++i) {
      references[0][i] = left[at + i];
      references[1][i] = right[at + i];
      mic[0][i] = 0.5F * left[at + i] - 0.2F * right[at + i];
      if (at > left.size() / 2) before += std::pow(mic[0][i], 2);
    }
    echo.cancel(references, mic);
    for (std::size_t i = 0; i < kOddHop && at > left.size() / 2; ++i) after += std::pow(mic[0][i], 2);
  }
  EXPECT_GT(10 * std::log10(before / after), 25);
}

TEST(EchoCanceller, allocates_nothing) {
  EchoCanceller echo = canceller();
  Grid<float> reference(1, kHop);
  Grid<float> mics(kMics, kHop);
  reference.fill(0.1F);
  mics.fill(0.1F);
  const auto before = test::allocations();
  for (int i = 0; i < 100; ++i) echo.cancel(reference, mics);
  echo.reset();
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace odas::echo_canceller_test
