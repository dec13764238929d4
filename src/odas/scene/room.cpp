// SPDX-License-Identifier: MIT
#include "odas/scene/room.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "odas/base/contract.hpp"
#include "odas/scene/impulse_train.hpp"
#include "odas/scene/random.hpp"

namespace odas {
namespace {

constexpr float kNearest = 0.01F;     // m: a source inside of a microphone is not infinitely loud
constexpr double kDecayStep = 0.001;  // s
constexpr std::size_t kTail = DelayFilter::kTaps;
constexpr int kFewWalls = 2;
constexpr float kAllWalls = 12;  // up to here no image is left out

}  // namespace

Room::Room(const Scene& scene)
    : size_(scene.room),
      middle_(scene.array_position),
      rt60_(scene.rt60),
      speed_(scene.speed_of_sound),
      rate_(static_cast<float>(scene.sample_rate)) {
  powers_.assign(1, 1);
  if (rt60_ <= 0) return;
  const Vec3 source = scene.sources.empty() ? Vec3{0.5F, 0.4F, 0.3F}
                                            : scene.sources[0].path[0].distance *
                                                  direction_of(scene.sources[0].path[0].azimuth,
                                                               scene.sources[0].path[0].elevation);
  match_decay(source);
  choose_echoes();
}

std::size_t Room::response_length(float farthest_source) const noexcept {
  // Half a metre over: the microphones are not all in the middle.
  const float direct = (farthest_source + 0.5F) / speed_ * rate_;
  return static_cast<std::size_t>(direct + rt60_ * rate_) + kTail;
}

void Room::images_along(float length, float source, float mic, float radius, Orders orders,
                        std::vector<Image>& images) const {
  images.clear();
  const auto reach = std::min(static_cast<int>(radius / (2 * length)) + 1, orders.last / 2 + 1);
  for (int n = -reach; n <= reach; ++n) {
    const float shift = 2 * static_cast<float>(n) * length;
    images.push_back({shift + source - mic, std::abs(2 * n)});
    images.push_back({shift - source - mic, std::abs(2 * n - 1)});
  }
  std::erase_if(images, [&](const Image& i) { return i.walls > orders.last || std::abs(i.offset) > radius; });
}

template <class Visit>
void Room::for_each_image(Vec3 source, Vec3 mic, Orders orders, float radius, Visit&& visit) const {
  std::vector<Image> xs;
  std::vector<Image> ys;
  std::vector<Image> zs;
  images_along(size_.x, source.x, mic.x, radius, orders, xs);
  images_along(size_.y, source.y, mic.y, radius, orders, ys);
  images_along(size_.z, source.z, mic.z, radius, orders, zs);
  for (const Image& x : xs) {
    for (const Image& y : ys) {
      const float flat = x.offset * x.offset + y.offset * y.offset;
      if (flat > radius * radius || x.walls + y.walls > orders.last) continue;
      for (const Image& z : zs) {
        const float square = flat + z.offset * z.offset;
        const int walls = x.walls + y.walls + z.walls;
        if (square > radius * radius || walls < orders.first || walls > orders.last) continue;
        visit(Vec3{x.offset, y.offset, z.offset}, std::sqrt(square), walls);
      }
    }
  }
}

void Room::add_response(Vec3 source, const SceneMic& mic, Orders orders, std::span<float> response) const {
  const auto deposit = [&](Vec3 from_mic, float distance, int walls) {
    const float far = std::max(distance, kNearest);
    const float pattern = mic.omni + (1 - mic.omni) * dot(mic.axis, from_mic) / far;
    const float gain = powers_[std::min(static_cast<std::size_t>(walls), powers_.size() - 1)] * pattern / far;
    delay_.add(distance / speed_ * rate_, gain, response);
  };
  if (rt60_ <= 0) {
    const Vec3 offset = source - mic.position;
    if (orders.first == 0) deposit(offset, norm(offset), 0);
    return;
  }
  const Orders few{orders.first, std::min(orders.last, kFewWalls)};
  const float radius = static_cast<float>(response.size()) / rate_ * speed_;
  if (few.first <= few.last) {
    for_each_image(middle_ + source, middle_ + mic.position, few, radius, deposit);
  }
  if (orders.last > kFewWalls) {
    add_echoes(source, mic, {std::max(orders.first, kFewWalls + 1), orders.last}, response);
  }
}

void Room::add_echoes(Vec3 source, const SceneMic& mic, Orders orders, std::span<float> response) const {
  constexpr std::size_t kTogether = 256;
  const Vec3 from = middle_ + source;
  const Vec3 to = middle_ + mic.position;
  const float samples_a_metre = rate_ / speed_;
  std::array<float, kTogether> delays, gains;
  ImpulseTrain train(response.size());
  const auto first = std::ranges::lower_bound(echoes_, orders.first, {}, &Echo::walls) - echoes_.begin();
  const auto last = std::ranges::upper_bound(echoes_, orders.last, {}, &Echo::walls) - echoes_.begin();
  for (auto begin = static_cast<std::size_t>(first); begin < static_cast<std::size_t>(last);
       begin += kTogether) {
    const std::size_t count = std::min(kTogether, static_cast<std::size_t>(last) - begin);
    for (std::size_t i = 0; i < count; ++i) {
      const Echo& echo = echoes_[begin + i];
      const float x = echo.side.x * from.x + echo.shift.x - to.x;
      const float y = echo.side.y * from.y + echo.shift.y - to.y;
      const float z = echo.side.z * from.z + echo.shift.z - to.z;
      const float distance = std::max(std::sqrt(x * x + y * y + z * z), kNearest);
      const float cosine = (mic.axis.x * x + mic.axis.y * y + mic.axis.z * z) / distance;
      delays[i] = distance * samples_a_metre;
      gains[i] = echo.gain * (mic.omni + (1 - mic.omni) * cosine) / distance;
    }
    for (std::size_t i = 0; i < count; ++i) train.add(delays[i], gains[i]);
  }
  train.render(response);
}

/// What beta^n and the share of those that are left make of each image of more than a few walls.
void Room::choose_echoes() {
  const auto most = static_cast<int>(powers_.size());
  const float radius = rt60_ * speed_ + 2 * norm(size_);
  Random random(1);
  const auto reach = [&](float length) { return static_cast<int>(radius / (2 * length)) + 1; };
  const auto walls_of = [](int n, int side) { return side > 0 ? std::abs(2 * n) : std::abs(2 * n - 1); };
  for (int nx = -reach(size_.x); nx <= reach(size_.x); ++nx) {
    for (int ny = -reach(size_.y); ny <= reach(size_.y); ++ny) {
      for (int nz = -reach(size_.z); nz <= reach(size_.z); ++nz) {
        const Vec3 shift{2 * static_cast<float>(nx) * size_.x, 2 * static_cast<float>(ny) * size_.y,
                         2 * static_cast<float>(nz) * size_.z};
        if (norm(shift) > radius) continue;
        for (int sides = 0; sides < 8; ++sides) {
          const int sx = (sides & 1) != 0 ? -1 : 1, sy = (sides & 2) != 0 ? -1 : 1,
                    sz = (sides & 4) != 0 ? -1 : 1;
          const int walls = walls_of(nx, sx) + walls_of(ny, sy) + walls_of(nz, sz);
          if (walls <= kFewWalls || walls >= most) continue;
          const float share = std::min(1.F, std::pow(kAllWalls / static_cast<float>(walls), 2.F));
          if (random.share() >= share) continue;
          echoes_.push_back({shift,
                             {static_cast<float>(sx), static_cast<float>(sy), static_cast<float>(sz)},
                             powers_[static_cast<std::size_t>(walls)] / std::sqrt(share),
                             walls});
        }
      }
    }
  }
  std::ranges::stable_sort(echoes_, {}, &Echo::walls);
}

/// `energy`: [ms][walls] of 1 / d^2.
double Room::decay_time(const std::vector<std::vector<double>>& energy, double reflection) const {
  std::vector<double> left(energy.size() + 1);  // Schroeder's backward sum
  for (std::size_t t = energy.size(); t-- > 0;) {
    double sum = 0;
    double power = 1;
    for (const double e : energy[t]) {
      sum += e * power;
      power *= reflection * reflection;
    }
    left[t] = left[t + 1] + sum;
  }
  // A straight line through the decay from -5 to -35 dB.
  double n = 0;
  double st = 0;
  double sl = 0;
  double stt = 0;
  double stl = 0;
  for (std::size_t t = 0; t < energy.size(); ++t) {
    if (left[t] <= 0) break;
    const double level = 10 * std::log10(left[t] / left[0]);
    if (level > -5) continue;
    if (level < -35) break;
    const double time = static_cast<double>(t) * kDecayStep;
    n += 1;
    st += time;
    sl += level;
    stt += time * time;
    stl += time * level;
  }
  const double slope = (n * stl - st * sl) / (n * stt - st * st);  // dB a second
  return n > 2 && slope < 0 ? -60 / slope : 0;
}

void Room::match_decay(Vec3 source) {
  const float radius = 1.1F * rt60_ * speed_ + norm(source);
  std::vector<std::vector<double>> energy(
      static_cast<std::size_t>(static_cast<double>(radius / speed_) / kDecayStep) + 1);
  std::size_t most = 1;
  for_each_image(middle_ + source, middle_, {}, radius, [&](Vec3, float distance, int walls) {
    auto& by_walls = energy[static_cast<std::size_t>(static_cast<double>(distance / speed_) / kDecayStep)];
    const auto w = static_cast<std::size_t>(walls);
    if (by_walls.size() <= w) by_walls.resize(w + 1);
    const double d = std::max(distance, kNearest);
    by_walls[w] += 1 / (d * d);
    most = std::max(most, w);
  });
  double low = 0.01;
  double high = 0.9999;
  for (int step = 0; step < 24; ++step) {
    const double middle = (low + high) / 2;
    (decay_time(energy, middle) < static_cast<double>(rt60_) ? low : high) = middle;
  }
  reflection_ = static_cast<float>((low + high) / 2);
  powers_.resize(most + 64);
  for (std::size_t w = 1; w < powers_.size(); ++w) powers_[w] = powers_[w - 1] * reflection_;
}

}  // namespace odas
