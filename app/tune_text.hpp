// SPDX-License-Identifier: MIT
// What `odas tune` says of its measurement, and writes of it.
#pragma once

#include <string>

#include "energy_measurement.hpp"

namespace odas {

/// The histograms side by side, in bars: E of the strongest potential of each hop.
[[nodiscard]] std::string histogram_text(const Energies& silence, const Energies& talk, double threshold);

/// The value of `sst.active` or `sst.inactive` in a configuration, with a comment on where it comes from.
[[nodiscard]] std::string mixture_value(const Mixture& mixture, const std::string& origin);

/// How well the two are told apart, and what to do where they are not.
[[nodiscard]] std::string verdict(const MeasuredMixtures& found, const Separation& apart,
                                  const Energies& silence);

}  // namespace odas
