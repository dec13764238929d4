// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "odas/io/canvas.hpp"

namespace odas {

/// Draws a picture of this size, in points, into a PNG of twice as many pixels. Throws IoError where it
/// cannot be written, or where the program was built without cairo.
void write_png(const std::string& file, double width, double height,
               const std::function<void(Canvas&)>& draw);

/// The same as SVG.
void write_svg(const std::string& file, double width, double height,
               const std::function<void(Canvas&)>& draw);

}  // namespace odas
