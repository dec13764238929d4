// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace odas {

/// A text as a QR code for a terminal: two rows of modules a line, light on dark and dark on light alike. "":
/// there is no libqrencode in this build, or the text is too long for a code.
[[nodiscard]] std::string qr_code(const std::string& text);

}  // namespace odas
