// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "odas/array/types.hpp"

namespace odas {

/// DFT of real signals of one length, in a workspace of its own: fill `time()`, call `forward()`, read
/// `bins()`; or the other way round with `inverse()`.
///
/// Convention: X[k] = sum x[n] e^(-j 2 pi k n / N), unscaled; the inverse carries 1/N.
/// The one place that knows FFTW, so that another library can stand here.
class RealFft {
 public:
  /// `size` is even and at least 2.
  explicit RealFft(std::size_t size);
  ~RealFft();
  RealFft(RealFft&&) noexcept;
  RealFft& operator=(RealFft&&) noexcept;

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] std::span<float> time() noexcept;   // [size]
  [[nodiscard]] std::span<cfloat> bins() noexcept;  // [size / 2 + 1]

  /// time() -> bins(). time() stays.
  void forward() noexcept;
  /// bins() -> time(). The imaginary parts of the first and the last bin count as zero; bins() is spoilt.
  void inverse() noexcept;

 private:
  struct Plan;
  std::size_t size_;
  std::unique_ptr<Plan> plan_;
};

}  // namespace odas
