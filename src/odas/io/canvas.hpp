// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace odas {

/// A colour, 0..1; `alpha` 0 is not drawn.
struct Ink {
  double red = 0, green = 0, blue = 0, alpha = 1;
};
inline constexpr Ink kNoInk{0, 0, 0, 0}, kGrey{0.45, 0.5, 0.55, 1}, kFaint{0.86, 0.88, 0.9, 1};

struct Spot {
  double x = 0, y = 0;  // points, from the upper left corner
};

/// What a drawing is drawn on: an SVG, a picture. Sizes are in points.
class Canvas {
 public:
  virtual ~Canvas() = default;

  struct Style {
    Ink fill = kNoInk;
    Ink line = kNoInk;
    double width = 1;
    bool dashed = false;
  };
  enum class Anchor { left, middle, right };
  struct Font {
    double size = 12;
    Anchor anchor = Anchor::left;
    bool bold = false;
    Ink ink{0.13, 0.16, 0.2, 1};
  };

  virtual void polyline(std::span<const Spot> spots, bool closed, const Style& style) = 0;
  virtual void circle(Spot centre, double radius, const Style& style) = 0;
  /// `at` is on the base line.
  virtual void text(Spot at, std::string_view what, const Font& font) = 0;
};

/// Draws an SVG 1.1 document in memory.
class SvgCanvas : public Canvas {
 public:
  SvgCanvas(double width, double height);

  void polyline(std::span<const Spot> spots, bool closed, const Style& style) override;
  void circle(Spot centre, double radius, const Style& style) override;
  void text(Spot at, std::string_view what, const Font& font) override;

  /// The whole document.
  [[nodiscard]] std::string document() const { return body_ + "</svg>\n"; }

 private:
  std::string body_;
};

}  // namespace odas
