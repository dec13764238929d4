// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace odas {

/// What a hop is made of, in the order of its way.
enum class Stage : std::uint8_t {
  transform,
  noise,
  localization,
  tracking,
  separation,
  synthesis,
  classification,
  post_filter
};
inline constexpr std::size_t kStages = 8;
/// Nanoseconds of each stage, of all hops so far.
using StageTimes = std::array<std::uint64_t, kStages>;

[[nodiscard]] constexpr const char* name_of(Stage stage) noexcept {
  constexpr std::array<const char*, kStages> kNames{"transform",      "noise",      "localization",
                                                    "tracking",       "separation", "synthesis",
                                                    "classification", "post_filter"};
  return kNames[static_cast<std::size_t>(stage)];
}

/// Where the time of a hop goes. The pipeline has no clock: who has one lends it. Cost: one reading of it for
/// each stage of a hop, a few hundred nanoseconds in all.
class StageWatch {
 public:
  /// Nanoseconds of a clock that never goes back.
  using Clock = std::uint64_t (*)() noexcept;

  /// nullptr: times are not taken.
  void use(Clock clock) noexcept { clock_ = clock; }
  [[nodiscard]] const StageTimes& times() const noexcept { return times_; }

  void begin() noexcept {
    if (clock_ != nullptr) last_ = clock_();
  }
  /// What has passed since the last call was spent on `stage`.
  void spent_on(Stage stage) noexcept {
    if (clock_ == nullptr) return;
    const std::uint64_t now = clock_();
    times_[static_cast<std::size_t>(stage)] += now - last_;
    last_ = now;
  }

 private:
  Clock clock_ = nullptr;
  std::uint64_t last_ = 0;
  StageTimes times_{};
};

}  // namespace odas
