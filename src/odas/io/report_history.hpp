// SPDX-License-Identifier: MIT
// Who was where: what a run's tables and its report remember of the hops that passed.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "odas/array/types.hpp"

namespace odas {

/// Values in order of time, one from every `stride` hops. Where they grow too many the stride doubles, so
/// that a day of sound takes no more memory than a minute.
template <class T>
class ThinnedSeries {
 public:
  struct Entry {
    HopIndex time;
    T value;
  };

  /// `stride` hops at first; never more than about `limit` entries.
  ThinnedSeries(HopIndex stride, std::size_t limit) : stride_(stride), limit_(limit) {}

  void add(HopIndex time, const T& value) {
    if (time % stride_ != 0) return;
    if (entries_.size() >= limit_) {
      stride_ *= 2;
      std::erase_if(entries_, [this](const Entry& e) { return e.time % stride_ != 0; });
      if (time % stride_ != 0) return;
    }
    entries_.push_back({time, value});
  }

  [[nodiscard]] const std::vector<Entry>& entries() const noexcept { return entries_; }

 private:
  HopIndex stride_;
  std::size_t limit_;
  std::vector<Entry> entries_;
};

/// A place on a source's way.
struct TrailPoint {
  double seconds = 0;
  Vec3 direction{};
  float activity = 0;
};

/// What one source did from its birth to its death.
struct SourceHistory {
  std::uint64_t id = 0;
  std::string tag;
  double from_s = 0, to_s = 0;  // first and last hop with this id
  double active_share = 0;      // 0..1: hops with activity of at least one half
  Vec3 mean{}, first{},
      last{};  // unit directions: of all, of the first and of the last half second of activity
  std::vector<TrailPoint> trail;
};

struct PotentialPoint {
  double seconds = 0;
  Vec3 direction{};
  float energy = 0;
};

/// Gathers hops; bounded in memory but for a few bytes per second and source.
class ReportHistory {
 public:
  ReportHistory(std::size_t hop_size, int sample_rate);

  void add(HopIndex time, std::span<const Potential> potentials, std::span<const Track> tracks);

  /// In order of id.
  [[nodiscard]] std::vector<SourceHistory> sources() const;
  [[nodiscard]] std::vector<PotentialPoint> potentials() const;

 private:
  struct Life {
    std::string tag;
    HopIndex born = 0, seen = 0;
    std::uint64_t hops = 0, active_hops = 0;
    Vec3 sum{}, active_sum{};
    std::vector<Vec3> half_seconds;  // sums of the active directions
    TrailPoint birth, death;
  };
  struct Seen {
    std::uint64_t id;
    Vec3 direction;
    float activity;
  };

  [[nodiscard]] double seconds(HopIndex time) const noexcept;
  void follow(HopIndex time, const Track& track);

  double hop_seconds_;
  std::map<std::uint64_t, Life> lives_;
  ThinnedSeries<Seen> seen_;
  ThinnedSeries<Potential> potentials_;
};

/// The table that `odas run` prints at its end: one line a source. `file_of` gives the name of its voice.
[[nodiscard]] std::string table_of(std::span<const SourceHistory> sources,
                                   std::string (*file_of)(std::uint64_t id));

}  // namespace odas
