// SPDX-License-Identifier: MIT
#include "odas/dsp/echo_canceller.hpp"

#include <algorithm>
#include <cmath>

#include "odas/base/contract.hpp"

namespace odas {
namespace {

constexpr float kSilence = 1.F / 16384;  // of full scale: quieter is not played
constexpr float kLoudest = 1000;         // of full scale: what no converter gives counts as not finite
constexpr float kFirstVariance = 0.01F;  // of a partition: together an echo half as loud as what is played
constexpr float kTinyEcho = 1e-12F;
constexpr double kDriftTime = 15;        // s, in which a path becomes another one
constexpr double kNearTime = 0.05;       // s, over which the power of others is followed
constexpr double kLossTime = 3;          // s, over which the return loss is told
constexpr std::size_t kConstraints = 8;  // partitions cut back in each hop
// Of the variance in D. With 1/2, which the window alone asks for, an echo that comes late or of one tone
// makes the filter swing, for of what is cut back a part is learned again: docs/decisions.md.
constexpr float kCaution = 1.3F;
constexpr double kHarmTime = 0.1;  // s; louder by this for so long: what was learned is worse than nothing
constexpr double kHarm = 1.5, kMostHarm = 4;  // of the power; a hop louder than that is not touched

double memory(double hop_seconds, double seconds) { return std::exp(-hop_seconds / seconds); }

bool is_sound(float x) noexcept { return std::abs(x) < kLoudest; }  // false for NaN, too

double power(std::span<const float> x) noexcept {
  double sum = 0;
  for (const float v : x) sum += static_cast<double>(v) * static_cast<double>(v);
  return sum;
}

}  // namespace

EchoCanceller::EchoCanceller(std::size_t mics, std::size_t references, std::size_t hop_size,
                             std::size_t length, int sample_rate)
    : hop_size_(hop_size),
      references_(references),
      blocks_((length + hop_size - 1) / hop_size),
      fft_(2 * hop_size),
      frames_(references, 2 * hop_size),
      spectra_(references * blocks_, hop_size + 1),
      silent_for_(blocks_ + 1),
      variance_(references * blocks_, hop_size + 1),
      path_power_(references * blocks_, hop_size + 1),
      echoes_(mics, hop_size + 1),
      errors_(mics, hop_size + 1),
      gain_(hop_size + 1),
      spread_(hop_size + 1),
      error_power_(hop_size + 1),
      echo_power_(hop_size + 1),
      near_(hop_size + 1),
      cross_(hop_size + 1),
      sum_(hop_size + 1),
      usable_(mics),
      error_(hop_size) {
  ODAS_EXPECT(references > 0 && length > 0 && hop_size > 0);
  const double hop = static_cast<double>(hop_size) / sample_rate;
  drift_ = static_cast<float>(memory(hop, kDriftTime / 2));
  near_memory_ = static_cast<float>(memory(hop, kNearTime));
  loss_memory_ = memory(hop, kLossTime);
  harm_memory_ = memory(hop, kHarmTime);
  for (std::size_t m = 0; m < mics; ++m) filters_.emplace_back(references * blocks_, hop_size + 1);
  variance_.fill(kFirstVariance);
}

void EchoCanceller::cancel(GridView<const float> references, GridView<float> mics) noexcept {
  ODAS_EXPECT(references.rows() == references_ && references.cols() == hop_size_);
  ODAS_EXPECT(mics.rows() == filters_.size() && mics.cols() == hop_size_);
  if (!listen(references)) return;
  predict();
  fade();
  for (std::size_t m = 0; m < mics.rows(); ++m) subtract(mics[m], m);
  if (does_harm()) return forget();
  judge();
  learn();
  for (std::size_t n = 0; n < std::min(kConstraints, variance_.rows()); ++n) {
    constrain(constrained_);
    constrained_ = (constrained_ + 1) % variance_.rows();
  }
}

/// Takes the references in; false while none has sounded for the length of the filter.
bool EchoCanceller::listen(GridView<const float> references) noexcept {
  float peak = 0;
  for (std::size_t r = 0; r < references_; ++r) {
    for (const float x : references[r]) peak = std::max(peak, is_sound(x) ? std::abs(x) : 0);
  }
  const bool silent = peak < kSilence;
  silent_for_ = silent ? std::min(silent_for_ + 1, blocks_ + 1) : 0;
  if (silent_for_ > blocks_) return false;
  head_ = (head_ + blocks_ - 1) % blocks_;
  for (std::size_t r = 0; r < references_; ++r) {
    const std::span<float> frame = frames_[r];
    std::copy_n(frame.data() + hop_size_, hop_size_, frame.data());
    for (std::size_t i = 0; i < hop_size_; ++i) {
      const float x = references[r][i];
      frame[hop_size_ + i] = silent || !is_sound(x) ? 0 : x;
    }
    std::copy(frame.begin(), frame.end(), fft_.time().begin());
    fft_.forward();
    std::copy(fft_.bins().begin(), fft_.bins().end(), spectra_[r * blocks_ + head_].begin());
  }
  return true;
}

/// X of a partition: b hops ago.
std::span<const cfloat> EchoCanceller::reference(std::size_t partition) const noexcept {
  const std::size_t first = partition / blocks_ * blocks_;
  return spectra_[first + (partition - first + head_) % blocks_];
}

/// How far the estimate may be off: c sum |X|^2 P.
void EchoCanceller::predict() noexcept {
  std::fill(spread_.begin(), spread_.end(), 0.F);
  for (std::size_t b = 0; b < variance_.rows(); ++b) {
    const std::span<const cfloat> x = reference(b);
    const std::span<const float> p = variance_[b];
    for (std::size_t k = 0; k < p.size(); ++k) spread_[k] += kCaution * std::norm(x[k]) * p[k];
  }
}

void EchoCanceller::subtract(std::span<float> mic, std::size_t m) noexcept {
  usable_[m] = std::all_of(mic.begin(), mic.end(), is_sound) ? 1 : 0;
  if (usable_[m] == 0) return;
  std::fill(sum_.begin(), sum_.end(), cfloat{});
  for (std::size_t b = 0; b < variance_.rows(); ++b) {
    const std::span<const cfloat> x = reference(b);
    const std::span<const cfloat> w = filters_[m][b];
    for (std::size_t k = 0; k < w.size(); ++k) sum_[k] += x[k] * w[k];
  }
  std::copy(sum_.begin(), sum_.end(), fft_.bins().begin());
  fft_.inverse();
  const std::span<float> time = fft_.time();
  for (std::size_t i = 0; i < hop_size_; ++i) error_[i] = mic[i] - time[hop_size_ + i];
  const double before = power(mic);
  const double after = power(error_);
  const bool is_usable = after <= kMostHarm * before;
  if (is_usable) std::copy(error_.begin(), error_.end(), mic.begin());
  heard_ += before;
  left_ += is_usable ? after : before;
  heard_of_late_ += before;
  error_of_late_ += after;

  // What was taken away, and what is left, in the window in which the filter learns.
  std::fill_n(time.begin(), hop_size_, 0.F);
  fft_.forward();
  std::copy(fft_.bins().begin(), fft_.bins().end(), echoes_[m].begin());
  std::fill_n(time.begin(), hop_size_, 0.F);
  std::copy(error_.begin(), error_.end(), time.begin() + static_cast<std::ptrdiff_t>(hop_size_));
  fft_.forward();
  std::copy(fft_.bins().begin(), fft_.bins().end(), errors_[m].begin());
}

/// Of the powers what was before this hop.
void EchoCanceller::fade() noexcept {
  heard_ *= loss_memory_;
  left_ *= loss_memory_;
  heard_of_late_ *= harm_memory_;
  error_of_late_ *= harm_memory_;
}

/// Where the microphones become louder the path has changed, or the filter has gone astray.
bool EchoCanceller::does_harm() const noexcept {
  return !(error_of_late_ <= kHarm * heard_of_late_);  // no number harms, too
}

/// Psi: the power of the error, but for what goes with the estimated echo.
void EchoCanceller::judge() noexcept {
  const auto count = static_cast<float>(std::count(usable_.begin(), usable_.end(), 1));
  if (count == 0) return;
  const float weight = (1 - near_memory_) / count;
  for (std::size_t k = 0; k < near_.size(); ++k) {
    float error = 0;
    float echo = 0;
    cfloat cross{};
    for (std::size_t m = 0; m < usable_.size(); ++m) {
      if (usable_[m] == 0) continue;
      error += std::norm(errors_[m][k]);
      echo += std::norm(echoes_[m][k]);
      cross += errors_[m][k] * std::conj(echoes_[m][k]);
    }
    error_power_[k] = near_memory_ * error_power_[k] + weight * error;
    echo_power_[k] = near_memory_ * echo_power_[k] + weight * echo;
    cross_[k] = near_memory_ * cross_[k] + weight * cross;
    const float coherent = std::norm(cross_[k]) / (echo_power_[k] + kTinyEcho);
    near_[k] = std::max(error_power_[k] - coherent, 0.F);
  }
}

void EchoCanceller::learn() noexcept {
  for (std::size_t k = 0; k < gain_.size(); ++k) gain_[k] = 1 / (spread_[k] + near_[k] + kTinyEcho);
  for (std::size_t b = 0; b < variance_.rows(); ++b) {
    const std::span<const cfloat> x = reference(b);
    const std::span<float> p = variance_[b];
    for (std::size_t m = 0; m < filters_.size(); ++m) {
      if (usable_[m] == 0) continue;
      const std::span<cfloat> w = filters_[m][b];
      const std::span<const cfloat> e = errors_[m];
      for (std::size_t k = 0; k < p.size(); ++k) w[k] += (gain_[k] * p[k]) * (std::conj(x[k]) * e[k]);
    }
    const std::span<const float> path = path_power_[b];
    for (std::size_t k = 0; k < p.size(); ++k) {
      p[k] = drift_ * (1 - 0.5F * p[k] * gain_[k] * std::norm(x[k])) * p[k] + (1 - drift_) * path[k];
    }
  }
}

/// Cuts a partition back to the taps of its hop.
void EchoCanceller::constrain(std::size_t partition) noexcept {
  const std::span<float> path = path_power_[partition];
  std::fill(path.begin(), path.end(), 0.F);
  for (Grid<cfloat>& filter : filters_) {
    const std::span<cfloat> w = filter[partition];
    std::copy(w.begin(), w.end(), fft_.bins().begin());
    fft_.inverse();
    std::fill_n(fft_.time().begin() + static_cast<std::ptrdiff_t>(hop_size_), hop_size_, 0.F);
    fft_.forward();
    std::copy(fft_.bins().begin(), fft_.bins().end(), w.begin());
    const float share = 1 / static_cast<float>(filters_.size());
    for (std::size_t k = 0; k < w.size(); ++k) path[k] += share * std::norm(w[k]);
  }
}

double EchoCanceller::return_loss_db() const noexcept {
  return heard_ > 0 && left_ > 0 ? 10 * std::log10(heard_ / left_) : 0;
}

void EchoCanceller::reset() noexcept {
  frames_.fill(0);
  spectra_.fill({});
  head_ = 0;
  silent_for_ = blocks_ + 1;
  constrained_ = 0;
  heard_ = left_ = 0;
  forget();
}

/// What was learned.
void EchoCanceller::forget() noexcept {
  for (Grid<cfloat>& filter : filters_) filter.fill({});
  variance_.fill(kFirstVariance);
  path_power_.fill(0);
  for (std::vector<float>* v : {&error_power_, &echo_power_, &near_}) std::fill(v->begin(), v->end(), 0.F);
  std::fill(cross_.begin(), cross_.end(), cfloat{});
  heard_of_late_ = error_of_late_ = 0;
}

}  // namespace odas
