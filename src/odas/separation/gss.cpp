// SPDX-License-Identifier: MIT
#include "odas/separation/gss.hpp"

#include <algorithm>
#include <cmath>

#include "odas/base/contract.hpp"

namespace odas {
namespace {

// Silence divides by this much at least, also where `general.epsilon` is zero.
constexpr float kSmallest = 1e-30F;

}  // namespace

GeometricSeparation::GeometricSeparation(const GssConfig& config, const GeneralConfig& general,
                                         std::size_t slots)
    : mu_(config.mu),
      lambda_(config.lambda),
      epsilon_(std::max(general.epsilon, kSmallest)),
      steering_(general),
      slots_(slots),
      input_(steering_.mics(), lanes_for(steering_.bins())),
      outputs_(slots),
      response_(slots),
      beam_(lanes_for(steering_.bins())),
      gains_(steering_.mics()),
      row_(steering_.bins()) {
  for (Slot& slot : slots_) {
    slot.gains.resize(steering_.mics());
    slot.steering = Grid<Lanes>(steering_.mics(), beam_.size());
    slot.demixing = Grid<Lanes>(steering_.mics(), beam_.size());
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
  for (std::size_t m = 0; m < spectra.rows() && !live_.empty(); ++m) split(spectra[m], input_[m]);
  for (std::size_t lane = 0; lane < beam_.size() && !live_.empty(); ++lane) adapt(lane);

  for (std::size_t s = 0; s < slots_.size(); ++s) {
    Slot& slot = slots_[s];
    const std::span<cfloat> beam = beams[s];
    if (slot.id == 0) {
      std::fill(beam.begin(), beam.end(), cfloat{});
      continue;
    }
    for (std::size_t lane = 0; lane < beam_.size(); ++lane) beam_[lane] = demix(slot, lane);
    join(beam_, beam);
    for (std::size_t m = 0; m < steering_.mics(); ++m) join(slot.demixing[m], slot.weights[m]);

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
    const std::span<Lanes> a = slot.steering[m];
    const std::span<Lanes> w = slot.demixing[m];
    if (gains_[m] == 0) {
      std::fill(a.begin(), a.end(), Lanes{});
      std::fill(w.begin(), w.end(), Lanes{});
    } else {
      steering_.row(m, direction, gains_[m], row_);
      split(row_, a);
      if (slot.gains[m] == 0) {
        for (std::size_t l = 0; l < w.size(); ++l) w[l] = conjugate(a[l], 1 / power);
      }
    }
    slot.gains[m] = gains_[m];
  }
}

void GeometricSeparation::adapt(std::size_t lane) noexcept {
  // alpha dJ1 = 4 E' y' x'^H with x' = x / (|x|^4 + eps)^(1/4): no overflow on the way.
  std::array<float, Lanes::kSize> unit{};
  for (std::size_t m = 0; m < steering_.mics(); ++m) {
    const auto power = squared(input_[m][lane]);
    for (std::size_t i = 0; i < unit.size(); ++i) unit[i] += power[i];
  }
  for (float& u : unit) u = 1 / std::sqrt(std::sqrt(u * u + epsilon_));

  std::array<float, Lanes::kSize> total{};
  for (std::size_t a = 0; a < live_.size(); ++a) {
    outputs_[a] = demix(*live_[a], lane);
    scale(outputs_[a], unit);
    const auto power = squared(outputs_[a]);
    for (std::size_t i = 0; i < total.size(); ++i) total[i] += power[i];
  }

  for (std::size_t a = 0; a < live_.size(); ++a) {
    Slot& slot = *live_[a];
    // 4 mu E y, for x as it is: the unit of x' twice, once in y.
    Lanes correlation = outputs_[a];
    const auto own = squared(correlation);
    std::array<float, Lanes::kSize> others;
    for (std::size_t i = 0; i < total.size(); ++i) others[i] = 4 * mu_ * (total[i] - own[i]) * unit[i];
    scale(correlation, others);

    // 2 mu (W A - I), the row of this slot.
    for (std::size_t b = 0; b < live_.size(); ++b) {
      Lanes sum;
      for (std::size_t m = 0; m < steering_.mics(); ++m) {
        if (slot.gains[m] > 0) add_product(sum, slot.demixing[m][lane], live_[b]->steering[m][lane]);
      }
      if (a == b) {
        for (float& re : sum.re) re -= 1;
      }
      scale(sum, 2 * mu_);
      response_[b] = sum;
    }

    for (std::size_t m = 0; m < steering_.mics(); ++m) {
      if (slot.gains[m] == 0) continue;
      Lanes w = slot.demixing[m][lane];
      scale(w, 1 - lambda_ * mu_);
      subtract_product_conj(w, correlation, input_[m][lane]);
      for (std::size_t b = 0; b < live_.size(); ++b) {
        subtract_product_conj(w, response_[b], live_[b]->steering[m][lane]);
      }
      slot.demixing[m][lane] = w;
    }
  }
}

Lanes GeometricSeparation::demix(const Slot& slot, std::size_t lane) const noexcept {
  Lanes y;
  for (std::size_t m = 0; m < slot.gains.size(); ++m) {
    if (slot.gains[m] > 0) add_product(y, slot.demixing[m][lane], input_[m][lane]);
  }
  return y;
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
