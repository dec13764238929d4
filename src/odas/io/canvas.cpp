// SPDX-License-Identifier: MIT
#include "odas/io/canvas.hpp"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace odas {
namespace {

std::string colour(const Ink& ink) {
  const auto byte = [](double part) { return std::lround(255 * part); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(ink.red), byte(ink.green), byte(ink.blue));
}

std::string paint(const char* what, const Ink& ink) {
  if (ink.alpha <= 0) return fmt::format(" {}=\"none\"", what);
  if (ink.alpha >= 1) return fmt::format(" {}=\"{}\"", what, colour(ink));
  return fmt::format(" {0}=\"{1}\" {0}-opacity=\"{2:.2f}\"", what, colour(ink), ink.alpha);
}

std::string style_of(const Canvas::Style& style) {
  std::string text = paint("fill", style.fill);
  if (style.line.alpha <= 0) return text;
  text += paint("stroke", style.line) + fmt::format(" stroke-width=\"{:.4g}\"", style.width);
  return style.dashed ? text + " stroke-dasharray=\"4 3\"" : text;
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (static_cast<unsigned char>(c) >= ' ') {
      out += c;
    }
  }
  return out;
}

}  // namespace

SvgCanvas::SvgCanvas(double width, double height)
    : body_(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
                        "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"DejaVu Sans, sans-serif\">\n"
                        "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
                        width, height)) {}

void SvgCanvas::polyline(std::span<const Spot> spots, bool closed, const Style& style) {
  body_ += closed ? "<polygon points=\"" : "<polyline points=\"";
  for (const Spot& spot : spots) fmt::format_to(std::back_inserter(body_), "{:.2f},{:.2f} ", spot.x, spot.y);
  if (!spots.empty()) body_.pop_back();
  body_ += '"' + style_of(style) + "/>\n";
}

void SvgCanvas::circle(Spot centre, double radius, const Style& style) {
  body_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"{}/>\n", centre.x, centre.y, radius,
                       style_of(style));
}

void SvgCanvas::text(Spot at, std::string_view what, const Font& font) {
  static constexpr const char* kAnchors[] = {"start", "middle", "end"};
  body_ +=
      fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.4g}\" text-anchor=\"{}\"{}{}>{}</text>\n",
                  at.x, at.y, font.size, kAnchors[static_cast<int>(font.anchor)],
                  font.bold ? " font-weight=\"bold\"" : "", paint("fill", font.ink), escaped(what));
}

}  // namespace odas
