// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "odas/io/canvas.hpp"
#include "odas/tracking/mixture_fit.hpp"

namespace odas {

inline constexpr double kHistogramWidth = 860, kHistogramHeight = 480;

/// How often the strongest potential of a hop had which energy, in silence and in talk, and the mixtures that
/// were fitted.
void draw_histograms(Canvas& canvas, const std::string& title, const Heard& silence, const Heard& talk,
                     const MeasuredMixtures& found, double threshold);

}  // namespace odas
