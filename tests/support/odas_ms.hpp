// SPDX-License-Identifier: MIT
// The post-filter ms with ODAS's faults put back, to compare with what ODAS made. Not for use.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "odas/dsp/mcra_config.hpp"
#include "odas/dsp/noise_estimator.hpp"
#include "odas/dsp/real_fft.hpp"
#include "odas/separation/multi_source_filter.hpp"

namespace odas::test {

/// MCRA as ODAS has it: a window of 1 * cos for 1 - cos (fault B1; the sum begins at 0, as in the build that
/// made the goldens), and minima that begin at zero, so that the estimate stays zero for 2 (L + 2) - 1 hops
/// (B17).
class OdasMcra final : public NoiseEstimator {
 public:
  OdasMcra(const McraConfig& config, std::size_t channels, std::size_t bins)
      : config_(config),
        smoothed_(channels, bins),
        minimum_(smoothed_),
        next_(smoothed_),
        psd_(smoothed_),
        age_(channels) {
    float sum = 0;
    for (int n = 0; n < config.b; ++n) {
      const float phase =
          2 * static_cast<float>(M_PI) * static_cast<float>(n + 1) / static_cast<float>(config.b + 1);
      window_.push_back(0.5F * std::cos(phase));
      sum += window_.back();
    }
    for (float& w : window_) w /= sum;
  }

  void update(std::size_t channel, std::span<const float> power) noexcept override {
    const auto last = static_cast<long>(power.size()) - 1;
    const bool turn = age_[channel] > config_.l;
    age_[channel] = turn ? 0 : age_[channel] + 1;
    for (long k = 0; k <= last; ++k) {
      float over_bins = 0;
      for (int n = 0; n < config_.b; ++n) {
        const long m = std::abs(k + n - (config_.b - 1) / 2);
        over_bins += window_[static_cast<std::size_t>(n)] *
                     power[static_cast<std::size_t>(m > last ? 2 * last - m : m)];
      }
      const auto i = static_cast<std::size_t>(k);
      float& s = smoothed_[channel][i];
      float& least = minimum_[channel][i];
      float& next = next_[channel][i];
      float& psd = psd_[channel][i];
      s = (1 - config_.alpha_s) * s + config_.alpha_s * over_bins;
      least = std::min(turn ? next : least, s);
      next = turn ? s : std::min(next, s);
      if (s < config_.delta * least || psd > s)
        psd = (1 - config_.alpha_d) * psd + config_.alpha_d * power[i];
    }
  }
  [[nodiscard]] GridView<const float> psd() const noexcept override { return psd_; }

  void reset(std::size_t channel, std::span<const float> known) noexcept override {
    age_[channel] = 0;
    for (Grid<float>* state : {&smoothed_, &minimum_, &next_, &psd_}) {
      std::copy(known.begin(), known.end(), (*state)[channel].begin());
    }
  }
  void reset(std::size_t channel) noexcept override { reset(channel, std::vector<float>(psd_.cols())); }

 private:
  McraConfig config_;
  std::vector<float> window_;
  Grid<float> smoothed_, minimum_, next_, psd_;
  std::vector<int> age_;
};

/// The filter with ODAS's rounding. Where ODAS knows no noise, SNRs are of the order of 1e20, and its
/// smoothing over frequency, by FFTs in single precision, spreads a ten-millionth of that over all bins, as
/// sure speech.
class OdasMultiSourceFilter final : public MultiSourceFilter {
 public:
  OdasMultiSourceFilter(const MultiSourceFilterConfig& config, std::unique_ptr<NoiseEstimator> noise,
                        const GeneralConfig& general, std::size_t slots)
      : MultiSourceFilter(config, std::move(noise), general, slots, 1e30F),
        values_(static_cast<std::size_t>(general.size.frame_size)),
        window_(static_cast<std::size_t>(general.size.frame_size)) {}

 protected:
  void smooth(HannSmoother& window, std::span<const float> xi, std::span<float> smoothed) noexcept override {
    const std::size_t frame = values_.size();
    for (std::size_t n = 0; n < frame; ++n) values_.time()[n] = xi[std::min(n, frame - n)];
    std::fill(window_.time().begin(), window_.time().end(), 0.F);
    const std::size_t width = window.width();
    for (std::size_t i = 0; i < width; ++i) {
      const double phase = 2 * M_PI * static_cast<double>(i + 1) / static_cast<double>(width + 1);
      window_.time()[(frame + i - width / 2) % frame] =
          static_cast<float>((1 - std::cos(phase)) / static_cast<double>(width + 1));
    }
    values_.forward();
    window_.forward();
    for (std::size_t k = 0; k < values_.bins().size(); ++k) values_.bins()[k] *= window_.bins()[k];
    values_.inverse();
    std::copy_n(values_.time().begin(), smoothed.size(), smoothed.begin());
  }

 private:
  RealFft values_, window_;
};

}  // namespace odas::test
