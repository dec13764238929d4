// SPDX-License-Identifier: MIT
// Sources and sinks in memory, and small configurations, for tests of the engine.
#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "odas/engine/audio_source.hpp"
#include "odas/engine/config.hpp"
#include "odas/engine/sink.hpp"

namespace odas::test {

/// Microphones on the x axis, 5 cm apart, a coarse search and short patience: cheap.
inline Configuration small_configuration(std::size_t mics = 3) {
  Configuration config;
  for (std::size_t m = 0; m < mics; ++m) {
    MicConfig mic;
    mic.mu = {0.05F * static_cast<float>(m), 0, 0};
    config.pipeline.general.mics.push_back(mic);
  }
  config.pipeline.general.spatialfilters.emplace();
  config.pipeline.ssl.scans = {{.level = 1, .delta = 1}};
  config.raw.n_channels = static_cast<int>(mics);
  return config;
}

/// White noise, [channel][frame], a tenth of full scale.
inline Grid<float> noise(std::size_t channels, std::size_t frames, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<float> normal(0, 0.1F);
  Grid<float> samples(channels, frames);
  for (std::size_t c = 0; c < channels; ++c) {
    for (float& x : samples[c]) x = normal(random);
  }
  return samples;
}

/// Plays [channel][frame] from memory.
class MemorySource : public AudioSource {
 public:
  explicit MemorySource(Grid<float> samples, int sample_rate = 16000)
      : samples_(std::move(samples)), sample_rate_(sample_rate) {}

  [[nodiscard]] std::size_t channels() const noexcept override { return samples_.rows(); }
  [[nodiscard]] int sample_rate() const noexcept override { return sample_rate_; }
  [[nodiscard]] bool live() const noexcept override { return live_source; }
  [[nodiscard]] std::optional<std::uint64_t> total_frames() const noexcept override {
    return samples_.cols();
  }
  [[nodiscard]] ReadResult read(GridView<float> block) override {
    ReadResult result;
    result.frames = std::min(block.cols(), samples_.cols() - at_);
    for (std::size_t c = 0; c < samples_.rows(); ++c) {
      std::copy_n(samples_[c].data() + at_, result.frames, block[c].data());
    }
    at_ += result.frames;
    result.end = result.frames < block.cols();
    if (result.end && !fault.empty()) result.status = IoStatus::failed(fault);
    return result;
  }
  [[nodiscard]] std::string warning() const override { return remark; }

  bool live_source = false;
  std::string fault;   // said at the end
  std::string remark;  // its warning

 private:
  Grid<float> samples_;
  int sample_rate_;
  std::size_t at_ = 0;
};

/// Plays from memory but for the frames of its gaps, which it says are lost.
class GappySource : public AudioSource {
 public:
  struct Gap {
    std::size_t begin, frames;
  };
  GappySource(Grid<float> samples, std::vector<Gap> gaps, int sample_rate = 16000)
      : samples_(std::move(samples)), gaps_(std::move(gaps)), sample_rate_(sample_rate) {}

  [[nodiscard]] std::size_t channels() const noexcept override { return samples_.rows(); }
  [[nodiscard]] int sample_rate() const noexcept override { return sample_rate_; }
  [[nodiscard]] bool live() const noexcept override { return false; }
  [[nodiscard]] ReadResult read(GridView<float> block) override {
    ReadResult result;
    if (next_ < gaps_.size() && at_ == gaps_[next_].begin) {
      result.lost = gaps_[next_].frames;
      at_ += gaps_[next_].frames;
      ++next_;
    }
    const std::size_t until = next_ < gaps_.size() ? gaps_[next_].begin : samples_.cols();
    result.frames = std::min(block.cols(), until - at_);
    for (std::size_t c = 0; c < samples_.rows(); ++c) {
      std::copy_n(samples_[c].data() + at_, result.frames, block[c].data());
    }
    at_ += result.frames;
    result.end = at_ == samples_.cols();
    return result;
  }

 private:
  Grid<float> samples_;
  std::vector<Gap> gaps_;
  int sample_rate_;
  std::size_t at_ = 0;
  std::size_t next_ = 0;
};

/// Keeps all that it is given.
class KeepingSink : public Sink {
 public:
  struct Hop {
    HopIndex time = 0;
    std::vector<Potential> potentials;
    std::vector<Track> tracks;
    std::vector<float> separated;  // slot after slot
  };

  [[nodiscard]] std::string name() const override { return "kept"; }
  [[nodiscard]] Wanted wanted() const noexcept override { return {true, true, true, false}; }
  IoStatus write(const HopResult& hop) override {
    if (fail_at != 0 && hop.time >= fail_at) {
      ++writes_after_failure;
      return IoStatus::failed("no more room");
    }
    Hop kept{
        hop.time, {hop.potentials.begin(), hop.potentials.end()}, {hop.tracks.begin(), hop.tracks.end()}, {}};
    for (std::size_t s = 0; s < hop.separated.rows(); ++s) {
      kept.separated.insert(kept.separated.end(), hop.separated[s].begin(), hop.separated[s].end());
    }
    hops.push_back(std::move(kept));
    return {};
  }
  IoStatus flush() override {
    ++flushes;
    return {};
  }
  IoStatus close() override {
    ++closes;
    return close_fault.empty() ? IoStatus() : IoStatus::failed(close_fault);
  }
  [[nodiscard]] std::uint64_t clipped_samples() const noexcept override { return clipped; }

  std::vector<Hop> hops;
  HopIndex fail_at = 0;  // 0: never
  std::string close_fault;
  std::uint64_t clipped = 0;
  int writes_after_failure = 0;
  int flushes = 0;
  int closes = 0;
};

/// A hop that points into these.
struct HopOfHand {
  std::vector<Potential> potentials;
  std::vector<Track> tracks;
  Grid<float> separated, postfiltered;

  [[nodiscard]] HopResult result(HopIndex time) const {
    return {time, potentials, tracks, separated.view(), postfiltered.view()};
  }
};

}  // namespace odas::test
