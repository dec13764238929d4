// SPDX-License-Identifier: MIT
#include "odas/separation/gss.hpp"

#include <algorithm>
#include <cmath>

#include "odas/base/contract.hpp"

namespace odas {
namespace {

// Silence divides by this much at least, also where `general.epsilon` is zero.
constexpr float kSmallest = 1e-30F;

/// sum over mics of a b
Lanes product(std::span<const Lanes> a, std::span<const Lanes> b) noexcept {
  Lanes sum;
  for (std::size_t m = 0; m < a.size(); ++m) add_product(sum, a[m], b[m]);
  return sum;
}

}  // namespace

GeometricSeparation::GeometricSeparation(const GssConfig& config, const GeneralConfig& general,
                                         std::size_t slots)
    : mu_(config.mu),
      lambda_(config.lambda),
      epsilon_(std::max(general.epsilon, kSmallest)),
      steering_(general),
      slots_(slots),
      input_(lanes_for(steering_.bins()), steering_.mics()),
      outputs_(slots),
      response_(slots),
      beam_(lanes_for(steering_.bins())),
      gains_(steering_.mics()),
      row_(steering_.bins()) {
  for (Slot& slot : slots_) {
    slot.gains.resize(steering_.mics());
    slot.steering = Grid<Lanes>(beam_.size(), steering_.mics());
    slot.demixing = Grid<Lanes>(beam_.size(), steering_.mics());
    slot.weights = Grid<cfloat>(steering_.mics(), steering_.bins());
  }
  live_.reserve(slots);
}

void GeometricSeparation::separate(GridView<const cfloat> spectra, std::span<const Track> tracks,
                                   GridView<cfloat> beams) noexcept {
  ODAS_EXPECT(spectra.rows() == steering_.mics() && spectra.cols() == steering_.bins());
  ODAS_EXPECT(tracks.size() == slots_.size() && beams.rows() == slots_.size());
  ODAS_EXPECT(beams.cols() == steering_.bins());

  live_.clear();
  for (std::size_t s = 0; s < slots_.size(); ++s) {
    follow(slots_[s], tracks[s]);
    if (slots_[s].id != 0) live_.push_back(&slots_[s]);
  }
  for (std::size_t m = 0; m < spectra.rows() && !live_.empty(); ++m) {
    split(spectra[m], input_.data() + m, steering_.mics());
  }
  for (std::size_t lane = 0; lane < beam_.size() && !live_.empty(); ++lane) adapt(lane);

  for (std::size_t s = 0; s < slots_.size(); ++s) {
    Slot& slot = slots_[s];
    const std::span<cfloat> beam = beams[s];
    if (slot.id == 0) {
      std::fill(beam.begin(), beam.end(), cfloat{});
      continue;
    }
    for (std::size_t lane = 0; lane < beam_.size(); ++lane)
      beam_[lane] = product(slot.demixing[lane], input_[lane]);
    join(beam_.data(), 1, beam);
    for (std::size_t m = 0; m < steering_.mics(); ++m) {
      join(slot.demixing.data() + m, steering_.mics(), slot.weights[m]);
    }

    // A weight that is not finite makes the beam so: whatever the cause, the row starts afresh.
    float sum = 0;
    for (const cfloat y : beam) sum += std::abs(y.real()) + std::abs(y.imag());
    if (!std::isfinite(sum)) forget(slot);
  }
}

void GeometricSeparation::follow(Slot& slot, const Track& track) noexcept {
  if (track.id != slot.id) {
    forget(slot);
    slot.id = track.id;
    if (slot.id == 0) slot.weights.fill({});
  }
  if (slot.id != 0 && (!slot.steered || slot.direction != track.direction)) steer(slot, track.direction);
}

void GeometricSeparation::forget(Slot& slot) noexcept {
  slot.steered = false;
  std::fill(slot.gains.begin(), slot.gains.end(), 0.F);  // every microphone is new to it
}

void GeometricSeparation::steer(Slot& slot, Vec3 direction) noexcept {
  slot.steered = true;
  slot.direction = direction;
  steering_.gains(direction, gains_);
  float power = epsilon_;
  for (const float gain : gains_) power += gain * gain;
  for (std::size_t m = 0; m < gains_.size(); ++m) {
    Lanes* a = slot.steering.data() + m;
    Lanes* w = slot.demixing.data() + m;
    const bool hears = gains_[m] > 0;
    if (hears) {
      steering_.row(m, direction, gains_[m], row_);
    } else {
      std::fill(row_.begin(), row_.end(), cfloat{});
    }
    split(row_, a, gains_.size());
    if (!hears || slot.gains[m] == 0) {
      for (std::size_t i = 0; i < slot.steering.rows() * gains_.size(); i += gains_.size()) {
        w[i] = scaled(conjugate(a[i]), all(1 / power));
      }
    }
    slot.gains[m] = gains_[m];
  }
}

void GeometricSeparation::adapt(std::size_t lane) noexcept {
  // alpha dJ1 = 4 E' y' x'^H with x' = x / (|x|^4 + eps)^(1/4): no overflow on the way.
  const std::span<const Lanes> x = input_[lane];
  Floats power{};
  for (const Lanes& x_m : x) power += squared(x_m);
  Floats unit{};
  for (std::size_t i = 0; i < Lanes::kSize; ++i) {
    unit[i] = 1 / std::sqrt(std::sqrt(power[i] * power[i] + epsilon_));
  }

  Floats total{};
  for (std::size_t a = 0; a < live_.size(); ++a) {
    outputs_[a] = scaled(product(live_[a]->demixing[lane], x), unit);
    total += squared(outputs_[a]);
  }

  for (std::size_t a = 0; a < live_.size(); ++a) {
    const std::span<Lanes> w = live_[a]->demixing[lane];
    // 4 mu E y, for x as it is: the unit of x' twice, once in y.
    const Lanes correlation = scaled(outputs_[a], 4 * mu_ * (total - squared(outputs_[a])) * unit);
    // 2 mu (W A - I), the row of this slot.
    for (std::size_t b = 0; b < live_.size(); ++b) {
      Lanes response = product(w, live_[b]->steering[lane]);
      if (a == b) response.re -= all(1);
      response_[b] = scaled(response, all(2 * mu_));
    }
    for (std::size_t m = 0; m < w.size(); ++m) {
      if (live_[a]->gains[m] == 0) continue;
      Lanes w_m = scaled(w[m], all(1 - lambda_ * mu_));
      subtract_product_conj(w_m, correlation, x[m]);
      for (std::size_t b = 0; b < live_.size(); ++b) {
        subtract_product_conj(w_m, response_[b], live_[b]->steering[lane][m]);
      }
      w[m] = w_m;
    }
  }
}

GridView<const cfloat> GeometricSeparation::weights(std::size_t slot) const noexcept {
  return slots_[slot].weights;
}

void GeometricSeparation::reset() noexcept {
  for (Slot& slot : slots_) {
    forget(slot);
    slot.id = 0;
    slot.weights.fill({});
  }
}

}  // namespace odas
