// SPDX-License-Identifier: MIT
#include "odas/separation/multi_source_filter.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

#include "odas/base/contract.hpp"
#include "odas/dsp/mcra.hpp"

namespace odas {
namespace {

// Of the table of phi. Beyond the last v, exp(E1(v) / 2) is 1 within 2e-5.
constexpr float kPhiSteps = 32;
constexpr float kPhiLast = 8;
// Keeps 0 out of logarithms and quotients.
constexpr float kTiny = 1e-20F;

std::size_t points(int size) noexcept { return static_cast<std::size_t>(size); }

}  // namespace

MultiSourceFilter::MultiSourceFilter(const MultiSourceFilterConfig& config, const McraConfig& sne,
                                     const GeneralConfig& general, std::size_t slots)
    : MultiSourceFilter(config, std::make_unique<Mcra>(sne, slots, points(general.size.frame_size) / 2 + 1),
                        general, slots) {}

MultiSourceFilter::MultiSourceFilter(const MultiSourceFilterConfig& config,
                                     std::unique_ptr<NoiseEstimator> noise, const GeneralConfig& general,
                                     std::size_t slots, float largest_snr)
    : config_(config),
      epsilon_(std::max(general.epsilon, 1e-30F)),
      largest_snr_(largest_snr),
      noise_(std::move(noise)),
      ids_(slots),
      heard_(slots),
      interference_(points(general.size.frame_size) / 2 + 1),
      v_(interference_.size()),
      presence_(interference_.size()),
      smoothed_(interference_.size()),
      gain_(interference_.size()) {
  for (Grid<float>* state : {&power_, &leak_, &snr_, &present_gain_}) {
    *state = Grid<float>(slots, interference_.size());
  }
  for (const int width : {config.win_size_local, config.win_size_global, config.win_size_frame}) {
    windows_.push_back({HannSmoother(points(width), points(general.size.frame_size)),
                        Grid<float>(slots, interference_.size())});
  }
  // sqrt(v) exp(E1(v) / 2) is smooth, and exp(-gamma / 2) at 0.
  phi_table_.push_back(std::exp(-std::numbers::egamma_v<float> / 2));
  for (int i = 1; i <= static_cast<int>(kPhiLast * kPhiSteps) + 1; ++i) {
    const double v = i / static_cast<double>(kPhiSteps);
    phi_table_.push_back(static_cast<float>(std::sqrt(v) * std::exp(-std::expint(-v) / 2)));
  }
}

void MultiSourceFilter::apply(GridView<const cfloat> /*spectra*/, GridView<const float> noise_psd,
                              std::span<const Track> tracks, const Beamformer& beamformer,
                              GridView<const cfloat> beams, GridView<cfloat> filtered) noexcept {
  ODAS_EXPECT(noise_psd.cols() == gain_.size());
  ODAS_EXPECT(tracks.size() == ids_.size() && beams.rows() == ids_.size());
  ODAS_EXPECT(filtered.rows() == ids_.size() && filtered.cols() == gain_.size());

  for (std::size_t s = 0; s < ids_.size(); ++s) {
    if (tracks[s].id != ids_[s]) {
      forget(s);
      ids_[s] = tracks[s].id;
      if (ids_[s] != 0) begin(s, noise_psd, beamformer);
    }
    heard_[s] = false;
    if (ids_[s] == 0) continue;
    const std::span<float> power = power_[s];
    for (std::size_t k = 0; k < power.size(); ++k) power[k] = std::norm(beams[s][k]);
    heard_[s] = std::isfinite(std::accumulate(power.begin(), power.end(), 0.F));
    if (heard_[s]) estimate_noise(s);
  }
  for (std::size_t s = 0; s < ids_.size(); ++s) {
    const std::span<cfloat> out = filtered[s];
    if (!heard_[s]) {
      std::fill(out.begin(), out.end(), cfloat{});
      continue;
    }
    estimate_snr(s);
    estimate_gain(s);
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = gain_[k] * beams[s][k];
  }
}

void MultiSourceFilter::begin(std::size_t slot, GridView<const float> noise_psd,
                              const Beamformer& beamformer) noexcept {
  // Noise that is not coherent between the microphones leaves the beamformer as sum |W_m|^2 lambda_m.
  const GridView<const cfloat> weights = beamformer.weights(slot);
  std::fill(smoothed_.begin(), smoothed_.end(), 0.F);
  for (std::size_t m = 0; m < noise_psd.rows(); ++m) {
    for (std::size_t k = 0; k < smoothed_.size(); ++k) {
      smoothed_[k] += std::norm(weights[m][k]) * noise_psd[m][k];
    }
  }
  noise_->reset(slot, smoothed_);
}

void MultiSourceFilter::forget(std::size_t slot) noexcept {
  noise_->reset(slot);
  for (Grid<float>* state : {&leak_, &snr_, &present_gain_}) {
    std::fill((*state)[slot].begin(), (*state)[slot].end(), 0.F);
  }
  for (Window& window : windows_) {
    std::fill(window.presence[slot].begin(), window.presence[slot].end(), 0.F);
  }
}

void MultiSourceFilter::estimate_noise(std::size_t slot) noexcept {
  noise_->update(slot, power_[slot]);
  const std::span<float> leak = leak_[slot];
  const std::span<const float> power = power_[slot];
  for (std::size_t k = 0; k < leak.size(); ++k) leak[k] += config_.alpha_z * (power[k] - leak[k]);
}

void MultiSourceFilter::estimate_snr(std::size_t slot) noexcept {
  const std::span<const float> noise = noise_->psd()[slot];
  std::copy(noise.begin(), noise.end(), interference_.begin());
  for (std::size_t other = 0; other < ids_.size(); ++other) {
    if (other == slot || !heard_[other]) continue;
    const std::span<const float> leak = leak_[other];
    for (std::size_t k = 0; k < leak.size(); ++k) interference_[k] += config_.eta * leak[k];
  }

  const std::span<const float> power = power_[slot];
  const std::span<float> xi = snr_[slot];
  const std::span<float> g1 = present_gain_[slot];
  for (std::size_t k = 0; k < xi.size(); ++k) {
    const float posteriori = std::min(power[k] / (interference_[k] + epsilon_), largest_snr_);
    const float before = xi[k] / (1 + xi[k]);
    const float a = std::min(before * before + config_.alpha_p_min, 1.F);
    xi[k] = (1 - a) * g1[k] * g1[k] * posteriori + a * std::max(posteriori - 1, 0.F);
    const float wiener = xi[k] / (1 + xi[k]);
    v_[k] = posteriori * wiener;
    g1[k] = std::min(wiener * phi(v_[k]), 1.F);
  }
}

void MultiSourceFilter::estimate_gain(std::size_t slot) noexcept {
  const std::span<const float> xi = snr_[slot];
  std::fill(presence_.begin(), presence_.end(), 1.F);
  for (Window& window : windows_) {
    smooth(window.smoother, xi, smoothed_);
    const std::span<float> zeta = window.presence[slot];
    for (std::size_t k = 0; k < zeta.size(); ++k) {
      zeta[k] += config_.alpha_win * (smoothed_[k] - zeta[k]);
      const float ratio = config_.theta_win / zeta[k];
      presence_[k] /= 1 + ratio * ratio;
    }
  }

  const std::span<const float> g1 = present_gain_[slot];
  const float log_min = std::log(config_.g_min);
  for (std::size_t k = 0; k < gain_.size(); ++k) {
    const float q = std::min(1 - presence_[k], config_.max_absence_prob);
    const float absent = q * (1 + xi[k]) * std::exp(-v_[k]);
    const float p = (1 - q) / std::max(1 - q + absent, kTiny);
    gain_[k] = std::exp(p * std::log(std::max(g1[k], kTiny)) + (1 - p) * log_min);
  }
}

float MultiSourceFilter::phi(float v) const noexcept {
  if (v >= kPhiLast) return 1;
  const auto i = static_cast<std::size_t>(v * kPhiSteps);
  const float part = v * kPhiSteps - static_cast<float>(i);
  return (phi_table_[i] + part * (phi_table_[i + 1] - phi_table_[i])) / std::sqrt(std::max(v, kTiny));
}

void MultiSourceFilter::reset() noexcept {
  for (std::size_t s = 0; s < ids_.size(); ++s) {
    forget(s);
    ids_[s] = 0;
  }
}

}  // namespace odas
