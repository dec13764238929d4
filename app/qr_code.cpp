// SPDX-License-Identifier: MIT
#include "qr_code.hpp"

#ifdef ODAS_WITH_QRENCODE

#include <array>
#include <memory>

#include <qrencode.h>

namespace odas {

std::string qr_code(const std::string& text) {
  const std::unique_ptr<QRcode, decltype(&QRcode_free)> code(
      QRcode_encodeString8bit(text.c_str(), 0, QR_ECLEVEL_L), &QRcode_free);
  if (!code) return "";
  constexpr int kQuiet = 2;  // modules around it; four are the rule, two do for cameras of phones
  const auto is_dark = [&](int row, int column) {
    const int n = code->width;
    if (row < 0 || column < 0 || row >= n || column >= n) return false;
    return (code->data[row * n + column] & 1U) != 0;
  };
  // Black ink on white paper, whatever the terminal's own colours are.
  constexpr std::array<const char*, 4> kBlocks{" ", "\u2584", "\u2580", "\u2588"};
  std::string picture;
  for (int row = -kQuiet; row < code->width + kQuiet; row += 2) {
    picture += "\x1B[30;107m";
    for (int column = -kQuiet; column < code->width + kQuiet; ++column) {
      picture += kBlocks[(is_dark(row, column) ? 2U : 0U) + (is_dark(row + 1, column) ? 1U : 0U)];
    }
    picture += "\x1B[0m\n";
  }
  return picture;
}

}  // namespace odas

#else

namespace odas {

std::string qr_code(const std::string& /*text*/) { return ""; }

}  // namespace odas

#endif
