// SPDX-License-Identifier: MIT
#include "png_canvas.hpp"

#include <array>
#include <fstream>
#include <memory>

#include "odas/base/error.hpp"

#ifdef ODAS_WITH_CAIRO
#include <cairo.h>
#endif

namespace odas {

void write_svg(const std::string& file, double width, double height,
               const std::function<void(Canvas&)>& draw) {
  SvgCanvas canvas(width, height);
  draw(canvas);
  std::ofstream stream(file, std::ios::binary);
  stream << canvas.document();
  stream.close();
  if (!stream) throw IoError("cannot write " + file);
}

#ifdef ODAS_WITH_CAIRO

namespace {

class CairoCanvas : public Canvas {
 public:
  explicit CairoCanvas(cairo_t* cairo) : cairo_(cairo) {}

  void polyline(std::span<const Spot> spots, bool closed, const Style& style) override {
    cairo_new_path(cairo_);
    for (const Spot& spot : spots) cairo_line_to(cairo_, spot.x, spot.y);
    if (closed) cairo_close_path(cairo_);
    paint(style);
  }

  void circle(Spot centre, double radius, const Style& style) override {
    cairo_new_path(cairo_);
    cairo_arc(cairo_, centre.x, centre.y, radius, 0, 2 * 3.14159265358979);
    paint(style);
  }

  void text(Spot at, std::string_view what, const Font& font) override {
    const std::string words(what);
    cairo_select_font_face(cairo_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           font.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_, font.size);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_, words.c_str(), &extents);
    double x = at.x;
    if (font.anchor == Anchor::middle) x -= extents.x_advance / 2;
    if (font.anchor == Anchor::right) x -= extents.x_advance;
    ink(font.ink);
    cairo_move_to(cairo_, x, at.y);
    cairo_show_text(cairo_, words.c_str());
  }

 private:
  void ink(const Ink& c) { cairo_set_source_rgba(cairo_, c.red, c.green, c.blue, c.alpha); }

  void paint(const Style& style) {
    if (style.fill.alpha > 0) {
      ink(style.fill);
      cairo_fill_preserve(cairo_);
    }
    if (style.line.alpha > 0) {
      static constexpr std::array kDashes{4.0, 3.0};
      cairo_set_dash(cairo_, kDashes.data(), style.dashed ? 2 : 0, 0);
      cairo_set_line_width(cairo_, style.width);
      ink(style.line);
      cairo_stroke_preserve(cairo_);
    }
    cairo_new_path(cairo_);
  }

  cairo_t* cairo_;
};

}  // namespace

void write_png(const std::string& file, double width, double height,
               const std::function<void(Canvas&)>& draw) {
  constexpr double kPixels = 2;  // a point
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(kPixels * width),
                                 static_cast<int>(kPixels * height)),
      cairo_surface_destroy);
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo(cairo_create(surface.get()), cairo_destroy);
  cairo_scale(cairo.get(), kPixels, kPixels);
  cairo_set_source_rgb(cairo.get(), 1, 1, 1);
  cairo_paint(cairo.get());
  CairoCanvas canvas(cairo.get());
  draw(canvas);
  const cairo_status_t status = cairo_surface_write_to_png(surface.get(), file.c_str());
  if (status != CAIRO_STATUS_SUCCESS)
    throw IoError("cannot write " + file + ": " + cairo_status_to_string(status));
}

#else

void write_png(const std::string& file, double, double, const std::function<void(Canvas&)>&) {
  throw IoError("cannot write " + file + ": this odas was built without cairo; use --svg");
}

#endif

}  // namespace odas
