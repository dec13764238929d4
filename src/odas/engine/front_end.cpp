// SPDX-License-Identifier: MIT
#include "odas/engine/front_end.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "odas/base/error.hpp"

namespace odas {
namespace {

std::size_t size(int value) { return static_cast<std::size_t>(value); }

/// The map as the file has it, 1-based; where it is absent, channel m is microphone m.
std::vector<int> written_map(const Configuration& config) {
  if (!config.mapping.map.empty()) return config.mapping.map;
  std::vector<int> map(config.pipeline.general.mics.size());
  std::iota(map.begin(), map.end(), 1);
  return map;
}

std::vector<std::size_t> channels_of(const Configuration& config, std::size_t channels, std::size_t silence) {
  std::vector<std::size_t> map;
  for (const int channel : written_map(config)) {
    if (channel < 0 || size(channel) > channels) {
      throw ConfigError("mapping.map", "asks for channel " + std::to_string(channel) +
                                           ", but the source has " + std::to_string(channels));
    }
    map.push_back(channel == 0 ? silence : size(channel) - 1);
  }
  if (map.size() != config.pipeline.general.mics.size()) {
    throw ConfigError("mapping.map", "has " + std::to_string(map.size()) + " channels for " +
                                         std::to_string(config.pipeline.general.mics.size()) +
                                         " microphones; must be one for each");
  }
  for (const int channel : config.mapping.reference) {
    if (channel < 1 || size(channel) > channels) {
      throw ConfigError("mapping.reference", "asks for channel " + std::to_string(channel) +
                                                 ", but the source has " + std::to_string(channels));
    }
    map.push_back(size(channel) - 1);
  }
  return map;
}

}  // namespace

FrontEnd::FrontEnd(const Configuration& config, std::size_t channels, int source_rate)
    : mics_(config.pipeline.general.mics.size()),
      map_(channels_of(config, channels, kSilence)),
      resamples_(source_rate != config.pipeline.general.samplerate.mu),
      mapped_(map_.size(), size(config.raw.hop_size)),
      health_(written_map(config), source_rate),
      resampler_(map_.size(), source_rate, config.pipeline.general.samplerate.mu, size(config.raw.hop_size),
                 size(config.pipeline.general.size.hop_size)) {
  const std::size_t references = map_.size() - mics_;
  if (references == 0) return;
  const int rate = config.pipeline.general.samplerate.mu;
  const std::size_t hop = size(config.pipeline.general.size.hop_size);
  const double length = static_cast<double>(config.mapping.echo_length) * rate / 1000;
  resampled_ = Grid<float>(map_.size(), hop);
  canceller_.emplace(mics_, references, hop, static_cast<std::size_t>(std::ceil(length)), rate);
}

void FrontEnd::push(GridView<const float> block) noexcept {
  ODAS_EXPECT(block.cols() <= mapped_.cols());
  const GridView<float> mapped(mapped_.data(), mapped_.rows(), block.cols(), mapped_.cols());
  for (std::size_t m = 0; m < map_.size(); ++m) {
    if (map_[m] == kSilence) continue;  // zero from the start
    std::copy_n(block[map_[m]].data(), block.cols(), mapped[m].data());
    if (!resamples_) continue;
    for (float& x : mapped[m]) {
      if (std::isfinite(x)) continue;
      x = 0;
      ++non_finite_;
    }
  }
  health_.watch({mapped.data(), mics_, mapped.cols(), mapped.stride()});
  resampler_.push(mapped);
}

bool FrontEnd::pop(GridView<float> hop) noexcept {
  if (!canceller_) return resampler_.pop(hop);
  if (!resampler_.pop(resampled_)) return false;
  clean(hop);
  return true;
}

bool FrontEnd::pop_rest(GridView<float> hop) noexcept {
  if (!canceller_) return resampler_.pop_rest(hop) > 0;
  if (resampler_.pop_rest(resampled_) == 0) return false;
  clean(hop);
  return true;
}

/// The microphones of `resampled_`, without what the machine plays.
void FrontEnd::clean(GridView<float> hop) noexcept {
  ODAS_EXPECT(hop.rows() == mics_ && hop.cols() == resampled_.cols());
  for (std::size_t m = 0; m < mics_; ++m) {
    std::copy(resampled_[m].begin(), resampled_[m].end(), hop[m].begin());
  }
  const std::size_t references = resampled_.rows() - mics_;
  canceller_->cancel({resampled_[mics_].data(), references, resampled_.cols()}, hop);
}

void FrontEnd::finish() noexcept {
  health_.finish();
  resampler_.finish();
}

}  // namespace odas
