// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <mutex>
#include <vector>

#include "odas/studio/hop_listener.hpp"

namespace odas::test {

/// Keeps all hops, and the sound under the id that it was heard under.
class KeptHops : public HopListener {
 public:
  struct Hop {
    std::uint64_t run = 0;
    HopIndex time = 0;
    std::vector<Track> tracks;
    std::vector<Potential> potentials;
    std::vector<std::vector<float>> separated, postfiltered;  // [slot][sample]; none: it came without
  };

  void begin(const StreamInfo& info) override {
    const std::scoped_lock lock(mutex_);
    infos_.push_back(info);
    running_ = true;
  }
  void hop(const HopResult& hop) override {
    const std::scoped_lock lock(mutex_);
    hops_.push_back({infos_.back().run,
                     hop.time,
                     {hop.tracks.begin(), hop.tracks.end()},
                     {hop.potentials.begin(), hop.potentials.end()},
                     copy(hop.separated),
                     copy(hop.postfiltered)});
  }
  void end() override {
    const std::scoped_lock lock(mutex_);
    running_ = false;
  }

  [[nodiscard]] std::vector<Hop> hops() const {
    const std::scoped_lock lock(mutex_);
    return hops_;
  }
  [[nodiscard]] std::vector<StreamInfo> infos() const {
    const std::scoped_lock lock(mutex_);
    return infos_;
  }
  [[nodiscard]] bool running() const {
    const std::scoped_lock lock(mutex_);
    return running_;
  }
  [[nodiscard]] std::size_t count() const {
    const std::scoped_lock lock(mutex_);
    return hops_.size();
  }

 private:
  static std::vector<std::vector<float>> copy(GridView<const float> from) {
    std::vector<std::vector<float>> rows;
    for (std::size_t r = 0; r < from.rows(); ++r) rows.emplace_back(from[r].begin(), from[r].end());
    return rows;
  }
  mutable std::mutex mutex_;
  std::vector<StreamInfo> infos_;
  std::vector<Hop> hops_;
  bool running_ = false;
};

}  // namespace odas::test
