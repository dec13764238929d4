// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "odas/array/types.hpp"

namespace odas {

/// What the microphones did in a tenth of a second.
struct MeterReading {
  enum Flag : std::uint8_t { clipped = 1, dead = 2, duplicate = 4 };
  struct Mic {
    float rms_db = -120, peak_db = -120;  // of full scale
    std::uint8_t flags = 0;
    int same_as = 0;  // duplicate: of which microphone, from 1
  };
  HopIndex time = 0;
  std::vector<Mic> mics;
};

/// Level meters of the microphones. Dead: all samples of a second the same while another one's are not.
/// Duplicate: the same samples as an earlier one's for a second, and not dead. Clipped: one sample in a
/// thousand, or more, of the reading within 1 % of full scale. (InputHealth says the same once a run.)
class MicMeters {
 public:
  static constexpr int kReadingsPerSecond = 10;

  MicMeters() = default;
  MicMeters(std::size_t mics, int sample_rate);

  /// [mic][sample], any number of samples. True: a reading is due.
  bool add(GridView<const float> mics);
  [[nodiscard]] MeterReading take(HopIndex time);

 private:
  struct Mic {
    double sum = 0;
    float peak = 0;
    std::uint64_t at_limit = 0;
    float last = 0;
    std::uint64_t still = 0;              // samples in a row that were the same
    std::vector<std::uint64_t> same_for;  // [earlier mic]: samples in a row
  };
  std::uint64_t second_ = 16000;  // samples
  std::uint64_t samples_ = 0;     // of this reading
  std::vector<Mic> mics_;
};

}  // namespace odas
