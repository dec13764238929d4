// SPDX-License-Identifier: MIT
#include "odas/scene/convolver.hpp"

#include <algorithm>
#include <bit>

namespace odas {

Convolver::Convolver(std::size_t mics, std::size_t piece, std::size_t response)
    : fft_(std::max<std::size_t>(2, std::bit_ceil(piece + response))),
      responses_(mics, fft_.bins().size()),
      piece_(fft_.bins().size()) {}

void Convolver::set_responses(GridView<const float> responses) noexcept {
  ODAS_EXPECT(responses.rows() == responses_.rows() && responses.cols() <= fft_.size());
  for (std::size_t m = 0; m < responses.rows(); ++m) {
    const auto end = std::copy(responses[m].begin(), responses[m].end(), fft_.time().begin());
    std::fill(end, fft_.time().end(), 0.F);
    fft_.forward();
    std::copy(fft_.bins().begin(), fft_.bins().end(), responses_[m].begin());
  }
}

void Convolver::add(std::span<const float> piece, std::size_t start, GridView<float> out) noexcept {
  if (start >= out.cols()) return;
  const auto end = std::copy(piece.begin(), piece.end(), fft_.time().begin());
  std::fill(end, fft_.time().end(), 0.F);
  fft_.forward();
  std::copy(fft_.bins().begin(), fft_.bins().end(), piece_.begin());
  for (std::size_t m = 0; m < out.rows(); ++m) {
    const auto response = responses_[m];
    const auto bins = fft_.bins();
    for (std::size_t k = 0; k < bins.size(); ++k) bins[k] = piece_[k] * response[k];
    fft_.inverse();
    const auto to = out[m].subspan(start);
    const std::size_t n = std::min(to.size(), fft_.size());
    for (std::size_t i = 0; i < n; ++i) to[i] += fft_.time()[i];
  }
}

}  // namespace odas
