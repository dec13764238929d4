// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>

#include "odas/scene/bench_scene.hpp"
#include "odas/scene/listening.hpp"
#include "odas/scene/score.hpp"

namespace odas {

/// A scene that was played, and how exactly it could be heard at best.
struct BenchSound {
  PlayedScene played;
  std::vector<double> tdoa_bounds;                // [target], s
  std::optional<double> ideal_beamformer_sdr_db;  // where it was asked for, and somebody talks
};

/// Plays it; or takes it from `folder`, if it was kept there: what is simulated once need not be again. An
/// empty folder: nothing is kept. `voices`: what an ideal beamformer makes of the voices is wanted, too, for
/// which all microphones' images are needed. Throws IoError.
[[nodiscard]] BenchSound bench_sound(const BenchScene& scene, const GeneralConfig& array,
                                     const std::filesystem::path& folder, bool voices = false);

/// The best mean errors that the array's aperture and the sound allow (Cramer and Rao), over the talkers. As
/// the means of errors, not their deviations: of a Gaussian 0.8 of that.
struct BenchBound {
  double azimuth_deg = 0;
  double angle_deg = 0;
};
[[nodiscard]] std::optional<BenchBound> bench_bound(const BenchSound& sound, const GeneralConfig& array);

/// What came out of one scene.
struct BenchOutcome {
  BenchScene scene;
  Score score;
  std::optional<BenchBound> bound;
  std::optional<double> ideal_mask_sdr_db, ideal_beamformer_sdr_db;  // of separation
};

/// Calls `work(i)` for i from 0 to `count` - 1, in `jobs` threads, until `stop`. The first exception ends it,
/// and is thrown here. `progress`: the share that is done, in the caller's thread.
void for_each_in_parallel(std::size_t count, std::size_t jobs, const std::atomic<bool>* stop,
                          const std::function<void(double)>& progress,
                          const std::function<void(std::size_t)>& work);

}  // namespace odas
