// SPDX-License-Identifier: MIT
#include "odas/scene/room.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>

namespace odas::room_test {
namespace {

Scene scene_of(float rt60) {
  Scene scene;
  scene.room = {6.2F, 5.1F, 2.9F};
  scene.array_position = {2.9F, 2.4F, 1.1F};
  scene.rt60 = rt60;
  return scene;
}

std::vector<float> response(const Room& room, Vec3 source, const SceneMic& mic, Orders orders = {}) {
  std::vector<float> h(room.response_length(norm(source)));
  room.add_response(source, mic, orders, h);
  return h;
}

/// Delay in samples and gain of what is one impulse, from its spectrum at a low and a higher frequency.
struct Arrival {
  double delay, gain;
};
Arrival arrival(const std::vector<float>& h, double near) {
  const double omega = 0.3 * std::numbers::pi;
  std::complex<double> sum = 0;
  for (std::size_t n = 0; n < h.size(); ++n) {
    sum += static_cast<double>(h[n]) * std::polar(1.0, -omega * (static_cast<double>(n) - near));
  }
  return {near - std::arg(sum) / omega, std::abs(sum)};
}

TEST(Room, Free_field_is_a_delay_of_d_over_c_and_a_gain_of_one_over_d) {
  const Room room(scene_of(0));
  for (const float distance : {0.5F, 1.F, 1.7321F, 3.3F}) {
    const SceneMic mic{{0.032F, -0.01F, 0.005F}, {0, 0, 1}, 1};
    const Vec3 source = distance * direction_of(33, 12);
    const double d = static_cast<double>(norm(source - mic.position));
    const Arrival found = arrival(response(room, source, mic), std::round(d / 343 * 16000));
    EXPECT_NEAR(found.delay, d / 343 * 16000, 1e-3);
    EXPECT_NEAR(found.gain * d, 1, 1e-3);
  }
}

TEST(Room, Cardioid_hears_all_from_its_front_half_from_aside_and_nothing_from_behind) {
  const Room room(scene_of(0));
  const SceneMic mic{{0, 0, 0}, {1, 0, 0}, 0.5F};
  const double near = std::round(1.5 / 343 * 16000);
  EXPECT_NEAR(arrival(response(room, {1.5F, 0, 0}, mic), near).gain * 1.5, 1, 1e-3);
  EXPECT_NEAR(arrival(response(room, {0, 1.5F, 0}, mic), near).gain * 1.5, 0.5, 1e-3);
  EXPECT_NEAR(arrival(response(room, {-1.5F, 0, 0}, mic), near).gain, 0, 1e-4);
}

TEST(Room, First_reflections_come_from_the_mirrored_source_and_lose_beta) {
  const Scene scene = scene_of(0.3F);
  const Room room(scene);
  const Vec3 source{1.2F, 0.4F, 0.3F};
  // The six walls, one image each; the sum of six impulses is known at every frequency.
  const Vec3 s = scene.array_position + source;
  const std::vector<Vec3> images{{-s.x, s.y, s.z}, {2 * scene.room.x - s.x, s.y, s.z},
                                 {s.x, -s.y, s.z}, {s.x, 2 * scene.room.y - s.y, s.z},
                                 {s.x, s.y, -s.z}, {s.x, s.y, 2 * scene.room.z - s.z}};
  const auto h = response(room, source, {}, {1, 1});
  for (const double omega : {0.1, 0.7, 1.9, 2.5}) {
    std::complex<double> expected = 0;
    std::complex<double> found = 0;
    for (const Vec3 image : images) {
      const double d = static_cast<double>(norm(image - scene.array_position));
      expected += std::polar(static_cast<double>(room.reflection()) / d, -omega * d / 343 * 16000);
    }
    for (std::size_t n = 0; n < h.size(); ++n) {
      found += static_cast<double>(h[n]) * std::polar(1.0, -omega * static_cast<double>(n));
    }
    EXPECT_LT(std::abs(found - expected), 2e-3 * std::abs(expected) + 1e-3) << omega;
  }
}

TEST(Room, Early_and_late_orders_sum_to_the_whole) {
  const Room room(scene_of(0.2F));
  const Vec3 source{0.9F, -0.7F, 0.2F};
  const auto whole = response(room, source, {});
  auto parts = response(room, source, {}, {0, 2});
  room.add_response(source, {}, {3, 1 << 20}, parts);
  for (std::size_t n = 0; n < whole.size(); ++n) EXPECT_NEAR(parts[n], whole[n], 1e-5);
}

TEST(Room, Microphones_close_to_each_other_hear_the_same_late_echoes) {
  const Room room(scene_of(0.6F));
  const Vec3 source{0.9F, -0.7F, 0.2F};
  const auto late = [&](float x) { return response(room, source, {{x, 0, 0}, {0, 0, 1}, 1}, {13, 1 << 20}); };
  const auto a = late(0), b = late(0.002F), far = late(0.8F);
  const auto correlation = [](const std::vector<float>& x, const std::vector<float>& y) {
    // Differences: what lies near 0 Hz is alike everywhere.
    double xy = 0, xx = 0, yy = 0;
    for (std::size_t n = 1; n < x.size(); ++n) {
      const double dx = static_cast<double>(x[n] - x[n - 1]), dy = static_cast<double>(y[n] - y[n - 1]);
      xy += dx * dy;
      xx += dx * dx;
      yy += dy * dy;
    }
    return xy / std::sqrt(xx * yy);
  };
  EXPECT_GT(correlation(a, b), 0.95);
  EXPECT_LT(std::abs(correlation(a, far)), 0.3);
}

/// Decay of the response by Schroeder's backward integration, without what lies under 100 Hz (a one-pole high
/// pass, twice): a line from -5 to -35 dB.
double measured_rt60(std::vector<float> h, double rate) {
  for (int pass = 0; pass < 2; ++pass) {
    const double pole = std::exp(-2 * std::numbers::pi * 100 / rate);
    double in = 0;
    double out = 0;
    for (float& x : h) {
      out = static_cast<double>(x) - in + pole * out;
      in = static_cast<double>(x);
      x = static_cast<float>(out);
    }
  }
  std::vector<double> left(h.size() + 1);
  for (std::size_t n = h.size(); n-- > 0;) left[n] = left[n + 1] + static_cast<double>(h[n]) * h[n];
  double n = 0, st = 0, sl = 0, stt = 0, stl = 0;
  for (std::size_t k = 0; k < h.size(); ++k) {
    const double level = 10 * std::log10(left[k] / left[0]);
    if (level > -5) continue;
    if (level < -35) break;
    const double t = static_cast<double>(k) / rate;
    n += 1;
    st += t;
    sl += level;
    stt += t * t;
    stl += t * level;
  }
  return -60 / ((n * stl - st * sl) / (n * stt - st * st));
}

TEST(Room, Rt60_measured_by_Schroeder_is_within_15_percent_of_the_one_asked_for) {
  for (const float rt60 : {0.2F, 0.4F, 0.7F}) {
    Scene scene = scene_of(rt60);
    for (const Vec3 size : {Vec3{6.2F, 5.1F, 2.9F}, Vec3{9, 4, 3}, Vec3{3.5F, 3, 2.5F}}) {
      scene.room = size;
      scene.array_position = {0.47F * size.x, 0.46F * size.y, 1.1F};
      const Room room(scene);
      const auto h = response(room, {0.9F, 0.6F, 0.4F}, {});
      EXPECT_NEAR(measured_rt60(h, 16000) / static_cast<double>(rt60), 1, 0.15)
          << rt60 << " s in a room of " << size.x << " m";
    }
  }
}

TEST(Room, Longer_decay_needs_harder_walls) {
  EXPECT_EQ(Room(scene_of(0)).reflection(), 0);
  const float dead = Room(scene_of(0.15F)).reflection();
  const float live = Room(scene_of(0.6F)).reflection();
  EXPECT_GT(dead, 0);
  EXPECT_GT(live, dead);
  EXPECT_LT(live, 1);
}

}  // namespace
}  // namespace odas::room_test
