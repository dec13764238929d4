// SPDX-License-Identifier: MIT
#include "odas/dsp/noise_model.hpp"

#include <algorithm>
#include <cmath>

#include "odas/dsp/cholesky.hpp"
#include "odas/dsp/tiny_power.hpp"

namespace odas {
namespace {

constexpr float kDeepest = 1e-3F;  // of the trace: no null is deeper than 30 dB

}  // namespace

BinRange telling_bins(int sample_rate, std::size_t frame_size) noexcept {
  const double hz = static_cast<double>(sample_rate) / static_cast<double>(frame_size);
  const std::size_t nyquist = frame_size / 2;
  const auto first = static_cast<std::size_t>(std::ceil(200 / hz));
  const auto last = static_cast<std::size_t>(7000 / hz);
  return {std::min(std::max<std::size_t>(first, 1), nyquist),
          std::max<std::size_t>(std::min(last, nyquist), 1)};
}

NoiseModel::NoiseModel(std::span<const cfloat> scm, std::size_t mics, BinRange bins)
    : mics_(mics), bins_(bins), inverses_(scm.size()) {
  const std::size_t size = mics * mics;
  std::vector<cfloat> factor(size);
  Grid<cfloat> columns(mics, mics);  // of L^-1
  for (std::size_t k = 0; k < scm.size() / size; ++k) {
    std::copy_n(scm.begin() + static_cast<std::ptrdiff_t>(k * size), size, factor.begin());
    float trace = kTinyPower;
    for (std::size_t m = 0; m < mics; ++m) trace += factor[m * mics + m].real();
    for (std::size_t m = 0; m < mics; ++m) factor[m * mics + m] += kDeepest * trace;
    cholesky(factor, mics, 1e-6F * trace);
    double log_determinant = 0;  // of L: the product of its diagonal
    columns.fill({});
    for (std::size_t m = 0; m < mics; ++m) {
      log_determinant += std::log(static_cast<double>(factor[m * mics + m].real()));
      columns[m][m] = 1;
      whiten(factor, columns[m]);
    }
    const auto scale = static_cast<float>(std::exp(2 * log_determinant / static_cast<double>(mics)));
    for (std::size_t i = 0; i < mics; ++i) {
      for (std::size_t j = 0; j < mics; ++j) {
        cfloat sum{};
        for (std::size_t m = 0; m < mics; ++m) sum += std::conj(columns[i][m]) * columns[j][m];
        inverses_[k * size + i * mics + j] = scale * sum;
      }
    }
  }
}

float NoiseModel::likeness(GridView<const cfloat> spectra) const noexcept {
  double sum = 0;
  for (std::size_t k = bins_.first; k <= bins_.last; ++k) {
    const cfloat* inverse = inverses_.data() + k * mics_ * mics_;
    float power = kTinyPower;
    float white = kTinyPower;
    for (std::size_t i = 0; i < mics_; ++i) {
      const cfloat x = spectra[i][k];
      cfloat others{};
      for (std::size_t j = 0; j < i; ++j) others += inverse[i * mics_ + j] * spectra[j][k];
      power += std::norm(x);
      white += inverse[i * mics_ + i].real() * std::norm(x) + 2 * (std::conj(x) * others).real();
    }
    sum += static_cast<double>(std::log(power / std::max(white, kTinyPower)));
  }
  return static_cast<float>(sum / static_cast<double>(bins_.last - bins_.first + 1));
}

float NoiseModel::likeness(std::span<const cfloat> scm) const noexcept {
  double sum = 0;
  const std::size_t size = mics_ * mics_;
  for (std::size_t k = bins_.first; k <= bins_.last; ++k) {
    const cfloat* inverse = inverses_.data() + k * size;
    const cfloat* r = scm.data() + k * size;
    float power = kTinyPower;
    float white = kTinyPower;  // tr(D^-1 R), of two Hermitian matrices
    for (std::size_t i = 0; i < size; ++i) white += (inverse[i] * std::conj(r[i])).real();
    for (std::size_t m = 0; m < mics_; ++m) power += r[m * mics_ + m].real();
    sum += static_cast<double>(std::log(power / std::max(white, kTinyPower)));
  }
  return static_cast<float>(sum / static_cast<double>(bins_.last - bins_.first + 1));
}

}  // namespace odas
