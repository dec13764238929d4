// SPDX-License-Identifier: MIT
#include "odas/tracking/particle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace odas {
namespace {

constexpr std::uint32_t kSeed = 20190101;
constexpr float kLeastFit = 2.0611536e-9F;  // exp(-20)

constexpr auto kPerGroup = static_cast<std::size_t>(kLanes);

Floats all(float x) noexcept { return Floats{} + x; }

float greatest(Floats x) noexcept { return std::max(std::max(x[0], x[1]), std::max(x[2], x[3])); }

}  // namespace

Particle::Particle(const ParticleConfig& config, double hop_seconds)
    : dt_(static_cast<float>(hop_seconds)),
      noise_(kSeed),
      groups_((static_cast<std::size_t>(config.n_particles) + kPerGroup - 1) / kPerGroup),
      drawn_(groups_.size()) {
  const std::size_t n = kPerGroup * groups_.size();
  fewest_ = config.n_min * static_cast<float>(n);
  const double ratios[]{static_cast<double>(config.st_ratio), static_cast<double>(config.ve_ratio),
                        static_cast<double>(config.ac_ratio)};
  const double alphas[]{static_cast<double>(config.st_alpha), static_cast<double>(config.ve_alpha),
                        static_cast<double>(config.ac_alpha)};
  const double betas[]{static_cast<double>(config.st_beta), static_cast<double>(config.ve_beta),
                       static_cast<double>(config.ac_beta)};
  const double whole = ratios[0] + ratios[1] + ratios[2];
  double share = 0;
  for (std::size_t m = 0; m < 3; ++m) {
    share += ratios[m];
    const double damping = std::exp(-alphas[m] * hop_seconds);
    const double end = whole > 0 ? std::round(share / whole * static_cast<double>(groups_.size())) : 0;
    motions_[m] = {static_cast<float>(damping),
                   static_cast<float>(betas[m] * std::sqrt(1 - damping * damping)),
                   static_cast<std::size_t>(end)};
  }
  motions_[2].end = groups_.size();
  // Neighbours among the drawn are copies of one particle: a stride of about the golden section spreads
  // them over the kinds of motion in proportion, and one without a common divisor reaches every place.
  stride_ = std::max<std::size_t>(1, static_cast<std::size_t>(0.618 * static_cast<double>(n)));
  while (std::gcd(stride_, n) != 1) ++stride_;
  start(direction_);
}

void Particle::start(Vec3 direction) noexcept {
  noise_ = NormalNoise(kSeed);
  Group group{};
  group.x = all(direction.x);
  group.y = all(direction.y);
  group.z = all(direction.z);
  group.weight = all(1 / static_cast<float>(kPerGroup * groups_.size()));
  std::fill(groups_.begin(), groups_.end(), group);
  direction_ = direction;
  radius_ = 0;
  pace_ = 1;
}

void Particle::predict() noexcept {
  Floats farthest{};
  const float dt = dt_ * pace_;
  std::size_t i = 0;
  for (const Motion& motion : motions_) {
    const Floats a = all(motion.damping);
    const Floats b = all(motion.excitation);
    for (; i < motion.end; ++i) {
      Group& g = groups_[i];
      g.vx = a * g.vx + b * noise_();
      g.vy = a * g.vy + b * noise_();
      g.vz = a * g.vz + b * noise_();
      g.x += dt * g.vx;
      g.y += dt * g.vy;
      g.z += dt * g.vz;
      // Back onto the sphere: 1 / |p| by one step of Newton's, as |p| is next to 1 already.
      const Floats inverse = 1.5F - 0.5F * (g.x * g.x + g.y * g.y + g.z * g.z);
      g.x *= inverse;
      g.y *= inverse;
      g.z *= inverse;
      const Floats outwards = g.x * g.vx + g.y * g.vy + g.z * g.vz;
      g.vx -= outwards * g.x;
      g.vy -= outwards * g.y;
      g.vz -= outwards * g.z;
      const Floats dx = g.x - direction_.x;
      const Floats dy = g.y - direction_.y;
      const Floats dz = g.z - direction_.z;
      const Floats d2 = dx * dx + dy * dy + dz * dz;
      farthest = d2 > farthest ? d2 : farthest;
    }
  }
  radius_ = std::sqrt(greatest(farthest));
}

Floats Particle::fit_of(const Group& g, Vec3 z, float precision) noexcept {
  const Floats dx = g.x - z.x;
  const Floats dy = g.y - z.y;
  const Floats dz = g.z - z.z;
  return exp_minus(precision * (dx * dx + dy * dy + dz * dz));
}

double Particle::log_likelihood(Vec3 z, double sigma2) const noexcept {
  const auto precision = static_cast<float>(0.5 / sigma2);
  const double log_scale = -1.5 * std::log(2 * std::numbers::pi * sigma2);
  const float gap = norm(z - direction_) - radius_;
  float fit = 0;
  if (!(gap > 0 && gap * gap * precision > 20)) {
    Floats sum{};
    for (const Group& g : groups_) sum += g.weight * fit_of(g, z, precision);
    fit = sum_of(sum);
  }
  return log_scale + std::log(static_cast<double>(std::max(fit, kLeastFit)));
}

void Particle::update(std::span<const Potential> potentials, std::span<const double> probability,
                      double activity, double sigma2) noexcept {
  pace_ = static_cast<float>(activity);
  if (!(activity > 0)) return;
  const auto best = std::max_element(probability.begin(), probability.end()) - probability.begin();
  const Vec3 z = potentials[static_cast<std::size_t>(best)].direction;
  const auto precision = static_cast<float>(0.5 / sigma2);
  Floats sum{};
  for (Group& g : groups_) {
    g.fit = fit_of(g, z, precision);
    sum += g.fit;
  }
  const float total = sum_of(sum);
  if (total > kLeastFit) {
    const Floats quiet = all((1 - pace_) / static_cast<float>(kPerGroup * groups_.size()));
    const Floats heard = all(pace_ / total);
    for (Group& g : groups_) g.weight *= quiet + heard * g.fit;
  }
  estimate();
  if (effective_ < fewest_) draw_anew();
}

void Particle::estimate() noexcept {
  Floats sum{};
  for (const Group& g : groups_) sum += g.weight;
  const float total = sum_of(sum);
  if (!(total > kLeastFit * kLeastFit)) {  // nobody explains what was heard: all are alike again
    for (Group& g : groups_) g.weight = all(1 / static_cast<float>(kPerGroup * groups_.size()));
  }
  const Floats scale = all(total > kLeastFit * kLeastFit ? 1 / total : 1);
  Floats squares{}, x{}, y{}, z{};
  for (Group& g : groups_) {
    g.weight *= scale;
    squares += g.weight * g.weight;
    x += g.weight * g.x;
    y += g.weight * g.y;
    z += g.weight * g.z;
  }
  effective_ = 1 / sum_of(squares);
  const Vec3 mean{sum_of(x), sum_of(y), sum_of(z)};
  if (norm(mean) > 0) direction_ = normalized(mean);
}

void Particle::draw_anew() noexcept {
  const std::size_t n = kPerGroup * groups_.size();
  const float share = 1 / static_cast<float>(n);
  const float offset = noise_.uniform();
  std::size_t parent = 0;
  std::size_t place = 0;
  float below = groups_[0].weight[0];  // weight of the particles up to the parent
  for (std::size_t i = 0; i < n; ++i) {
    const float mark = (static_cast<float>(i) + offset) * share;
    while (below < mark && parent + 1 < n) {
      ++parent;
      below += groups_[parent / kPerGroup].weight[parent % kPerGroup];
    }
    const Group& from = groups_[parent / kPerGroup];
    Group& to = drawn_[place / kPerGroup];
    const std::size_t a = parent % kPerGroup;
    const std::size_t b = place % kPerGroup;
    to.x[b] = from.x[a];
    to.y[b] = from.y[a];
    to.z[b] = from.z[a];
    to.vx[b] = from.vx[a];
    to.vy[b] = from.vy[a];
    to.vz[b] = from.vz[a];
    to.weight[b] = share;
    place += stride_;
    if (place >= n) place -= n;
  }
  std::swap(groups_, drawn_);
}

}  // namespace odas
