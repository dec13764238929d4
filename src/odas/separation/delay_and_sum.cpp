// SPDX-License-Identifier: MIT
#include "odas/separation/delay_and_sum.hpp"

#include <algorithm>
#include <array>

#include "odas/base/contract.hpp"

namespace odas {
namespace {

// Floats that are summed side by side: a width that stays in the registers of any machine.
constexpr std::size_t kTile = 16;

std::size_t padded(std::size_t bins) noexcept { return (2 * bins + kTile - 1) / kTile * kTile; }

std::span<cfloat> as_complex(std::span<float> floats, std::size_t bins) noexcept {
  return {reinterpret_cast<cfloat*>(floats.data()), bins};
}

}  // namespace

DelayAndSum::DelayAndSum(const GeneralConfig& general, std::size_t slots)
    : epsilon_(general.epsilon),
      steering_(general),
      gains_(steering_.mics()),
      slots_(slots),
      real_(steering_.mics(), padded(steering_.bins())),
      imag_(steering_.mics(), padded(steering_.bins())) {
  for (Slot& slot : slots_) {
    slot.weights = Grid<float>(steering_.mics(), padded(steering_.bins()));
    slot.heard.reserve(steering_.mics());
  }
}

void DelayAndSum::separate(GridView<const cfloat> spectra, std::span<const Track> tracks,
                           GridView<cfloat> beams) noexcept {
  ODAS_EXPECT(spectra.rows() == steering_.mics() && spectra.cols() == steering_.bins());
  ODAS_EXPECT(tracks.size() == slots_.size() && beams.rows() == slots_.size());
  ODAS_EXPECT(beams.cols() == steering_.bins());

  bool anybody = false;
  for (std::size_t s = 0; s < slots_.size(); ++s) {
    Slot& slot = slots_[s];
    if (tracks[s].id == 0) {
      if (slot.steered) slot.weights.fill(0);
      slot.steered = false;
      slot.heard.clear();
    } else if (!slot.steered || slot.direction != tracks[s].direction) {
      steer(slot, tracks[s].direction);
    }
    anybody = anybody || !slot.heard.empty();
  }

  if (anybody) {
    for (std::size_t m = 0; m < spectra.rows(); ++m) {
      const auto* x = reinterpret_cast<const float*>(spectra[m].data());
      float* re = real_[m].data();
      float* im = imag_[m].data();
      for (std::size_t i = 0; i < 2 * steering_.bins(); i += 2) {
        re[i] = re[i + 1] = x[i];
        im[i] = im[i + 1] = x[i + 1];
      }
    }
  }
  for (std::size_t s = 0; s < slots_.size(); ++s) form(slots_[s], beams[s]);
}

void DelayAndSum::steer(Slot& slot, Vec3 direction) noexcept {
  slot.steered = true;
  slot.direction = direction;
  slot.heard.clear();
  steering_.gains(direction, gains_);
  float power = epsilon_;
  for (const float gain : gains_) power += gain * gain;
  for (std::size_t m = 0; m < gains_.size(); ++m) {
    const std::span<cfloat> row = as_complex(slot.weights[m], steering_.bins());
    if (gains_[m] > 0) {
      steering_.row(m, -1.F * direction, gains_[m] / power, row);  // -u: the conjugate
      slot.heard.push_back(m);
    } else {
      std::fill(row.begin(), row.end(), cfloat{});
    }
  }
}

void DelayAndSum::form(const Slot& slot, std::span<cfloat> beam) const noexcept {
  if (slot.heard.empty()) {
    std::fill(beam.begin(), beam.end(), cfloat{});
    return;
  }
  const std::size_t stride = real_.cols();
  for (std::size_t begin = 0; begin < 2 * beam.size(); begin += kTile) {
    // sum W Re x and sum W Im x; y = the first + j the second.
    std::array<float, kTile> by_real{};
    std::array<float, kTile> by_imag{};
    for (const std::size_t m : slot.heard) {
      const float* w = slot.weights.data() + m * stride + begin;
      const float* re = real_.data() + m * stride + begin;
      const float* im = imag_.data() + m * stride + begin;
      for (std::size_t i = 0; i < kTile; ++i) {
        by_real[i] += w[i] * re[i];
        by_imag[i] += w[i] * im[i];
      }
    }
    const std::size_t n = std::min(kTile / 2, beam.size() - begin / 2);
    for (std::size_t k = 0; k < n; ++k) {
      beam[begin / 2 + k] = {by_real[2 * k] - by_imag[2 * k + 1], by_real[2 * k + 1] + by_imag[2 * k]};
    }
  }
}

GridView<const cfloat> DelayAndSum::weights(std::size_t slot) const noexcept {
  const Grid<float>& w = slots_[slot].weights;
  return {reinterpret_cast<const cfloat*>(w.data()), steering_.mics(), steering_.bins(), w.cols() / 2};
}

void DelayAndSum::reset() noexcept {
  for (Slot& slot : slots_) {
    slot.steered = false;
    slot.heard.clear();
    slot.weights.fill(0);
  }
}

}  // namespace odas
