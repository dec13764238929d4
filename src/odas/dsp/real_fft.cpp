// SPDX-License-Identifier: MIT
#include "odas/dsp/real_fft.hpp"

#include <atomic>
#include <new>

#include <fftw3.h>

namespace odas {
namespace {

/// FFTW's planner keeps what it knows in global variables: one thread at a time. Never on the hop's path.
class PlannerTurn {
 public:
  PlannerTurn() noexcept {
    while (taken_.test_and_set(std::memory_order_acquire)) taken_.wait(true);
  }
  ~PlannerTurn() {
    taken_.clear(std::memory_order_release);
    taken_.notify_one();
  }
  PlannerTurn(const PlannerTurn&) = delete;
  PlannerTurn& operator=(const PlannerTurn&) = delete;

 private:
  static inline std::atomic_flag taken_;
};

}  // namespace

struct RealFft::Plan {
  explicit Plan(std::size_t size)
      : time(fftwf_alloc_real(size)), bins(reinterpret_cast<cfloat*>(fftwf_alloc_complex(size / 2 + 1))) {
    if (time == nullptr || bins == nullptr) throw std::bad_alloc();
    auto* spectrum = reinterpret_cast<fftwf_complex*>(bins);
    const PlannerTurn turn;
    // ESTIMATE chooses the same algorithm in every run, so that equal input gives equal bits.
    forward = fftwf_plan_dft_r2c_1d(static_cast<int>(size), time, spectrum, FFTW_ESTIMATE);
    inverse = fftwf_plan_dft_c2r_1d(static_cast<int>(size), spectrum, time, FFTW_ESTIMATE);
    std::fill_n(time, size, 0.F);
    std::fill_n(bins, size / 2 + 1, cfloat{});
  }
  ~Plan() {
    const PlannerTurn turn;
    fftwf_destroy_plan(forward);
    fftwf_destroy_plan(inverse);
    fftwf_free(time);
    fftwf_free(bins);
  }
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;

  float* time;
  cfloat* bins;
  fftwf_plan forward = nullptr;
  fftwf_plan inverse = nullptr;
};

RealFft::RealFft(std::size_t size) : size_(size), plan_(std::make_unique<Plan>(size)) {
  ODAS_EXPECT(size >= 2 && size % 2 == 0);
}
RealFft::~RealFft() = default;
RealFft::RealFft(RealFft&&) noexcept = default;
RealFft& RealFft::operator=(RealFft&&) noexcept = default;

std::span<float> RealFft::time() noexcept { return {plan_->time, size_}; }
std::span<cfloat> RealFft::bins() noexcept { return {plan_->bins, size_ / 2 + 1}; }

void RealFft::forward() noexcept { fftwf_execute(plan_->forward); }

void RealFft::inverse() noexcept {
  fftwf_execute(plan_->inverse);
  const float scale = 1.F / static_cast<float>(size_);
  for (float& x : time()) x *= scale;
}

}  // namespace odas
