// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "odas/engine/config.hpp"
#include "odas/io/sample_format.hpp"

namespace odas {

/// What a capture device can do, as it says itself.
struct CaptureOffer {
  std::vector<SampleFormat> formats;       // that odas can read, the best first
  std::vector<std::string> other_formats;  // that it cannot
  int min_channels = 0, max_channels = 0;  // 0, 0: none
  std::vector<int> channels;               // those among them that it has, as far as they were asked for
  int min_rate = 0, max_rate = 0;          // Hz
  std::vector<int> rates;                  // the usual ones among them

  [[nodiscard]] bool has_channels(int n) const noexcept;
  [[nodiscard]] bool has_rate(int hz) const noexcept;
};

/// What devices are asked for one by one: between the least and the most that they have, there are gaps.
inline constexpr std::array kUsualRates{8000,  16000, 22050, 32000,  44100,
                                        48000, 88200, 96000, 176400, 192000};
inline constexpr int kAskedChannels = 32;

/// "1 to 8", "16000, 48000", "S16_LE, S32_LE".
[[nodiscard]] std::string channels_text(const CaptureOffer& offer);
[[nodiscard]] std::string rates_text(const CaptureOffer& offer);
[[nodiscard]] std::string formats_text(const CaptureOffer& offer);

/// The formats that `raw` allows, in the order in which they should be tried: of nBits = 24 both packings.
[[nodiscard]] std::vector<SampleFormat> wanted_formats(const RawConfig& raw);

/// The best format that is both wanted and offered.
[[nodiscard]] std::optional<SampleFormat> choose_format(const RawConfig& raw, const CaptureOffer& offer);

/// What of `raw` the device cannot do, with the lines to write into `raw` instead; "" if it can do all of it.
[[nodiscard]] std::string misfit(const std::string& device, const RawConfig& raw, const CaptureOffer& offer);

/// The section `raw` that suits a device: text ready to paste. `interface`: the keys of its group.
[[nodiscard]] std::string propose_raw(const CaptureOffer& offer, const std::string& interface);

}  // namespace odas
