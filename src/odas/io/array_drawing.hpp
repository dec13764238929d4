// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "odas/array/doa_error.hpp"
#include "odas/io/canvas.hpp"

namespace odas {

inline constexpr double kArrayDrawingWidth = 1060, kArrayDrawingHeight = 920;

/// What is drawn of an array.
struct ArrayPicture {
  std::string title, subtitle;
  const GeneralConfig* general = nullptr;
  std::vector<std::string> channels;  // of each microphone: its number; "" where it has none
  const DoaError* error = nullptr;
};

/// The array from above and from its side in mm, the expected error around it, and over the sphere.
void draw_array(Canvas& canvas, const ArrayPicture& picture);

}  // namespace odas
