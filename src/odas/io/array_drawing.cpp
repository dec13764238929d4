// SPDX-License-Identifier: MIT
#include "odas/io/array_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace odas {
namespace {

using Anchor = Canvas::Anchor;

constexpr Ink kDark{0.13, 0.16, 0.2, 1};
constexpr Ink kBlue{0.1, 0.38, 0.7, 1}, kRed{0.8, 0.24, 0.16, 1};
constexpr double kPanel = 400;  // width of a panel
constexpr double kMargin = 22;  // of a view's panel, for the numbers

/// The least of 1, 2, 5 times a power of ten that is not below.
double round_up(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * power >= value * 0.9999) return step * power;
  }
  return 10 * power;
}

void line(Canvas& canvas, Spot a, Spot b, const Canvas::Style& style) {
  canvas.polyline(std::array{a, b}, false, style);
}

void heading(Canvas& canvas, Spot at, const std::string& what, const std::string& more) {
  canvas.text(at, what, {.size = 15, .bold = true});
  canvas.text({at.x, at.y + 17}, more, {.size = 11, .ink = kGrey});
}

/// The microphones in the plane of two axes of the frame.
class View {
 public:
  View(Canvas& canvas, const ArrayPicture& picture, Spot corner, double height, std::size_t across,
       std::size_t up)
      : canvas_(canvas), picture_(picture), corner_(corner), height_(height), across_(across), up_(up) {
    for (const MicConfig& mic : picture.general->mics) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        least_[axis] = std::min(least_[axis], static_cast<double>(mic.mu[axis]));
        most_[axis] = std::max(most_[axis], static_cast<double>(mic.mu[axis]));
      }
    }
    const double extent = std::max({most_[0] - least_[0], most_[1] - least_[1], most_[2] - least_[2], 0.01});
    step_ = round_up(extent / 4);
    scale_ = (kPanel - 120) / extent;
  }

  void draw() {
    grid();
    for (const MicConfig& mic : picture_.general->mics) pointing(mic);
    std::vector<bool> done(picture_.general->mics.size(), false);
    for (std::size_t m = 0; m < done.size(); ++m) {
      std::vector<std::size_t> here;  // microphones that are one behind the other, as seen from here
      for (std::size_t other = m; other < done.size(); ++other) {
        const Spot a = place_of(m), b = place_of(other);
        if (!done[other] && std::hypot(a.x - b.x, a.y - b.y) < 8) here.push_back(other);
      }
      if (done[m]) continue;
      for (const std::size_t other : here) done[other] = true;
      microphones(here);
    }
  }

  /// An arrow beside the panel, towards +across.
  void azimuth_zero() {
    const Spot from{corner_.x + kPanel - kMargin + 6, place(0, 0).y}, tip{from.x + 30, from.y};
    line(canvas_, from, tip, {.line = kRed, .width = 2});
    canvas_.polyline(std::array{tip, Spot{tip.x - 9, tip.y - 5}, Spot{tip.x - 9, tip.y + 5}}, true,
                     {.fill = kRed});
    canvas_.text({tip.x + 6, tip.y + 4}, "azimuth 0", {.size = 11, .bold = true, .ink = kRed});
  }

 private:
  [[nodiscard]] double middle(std::size_t axis) const { return (least_[axis] + most_[axis]) / 2; }
  [[nodiscard]] Spot place(double across, double up) const {
    return {corner_.x + kPanel / 2 + scale_ * (across - middle(across_)),
            corner_.y + height_ / 2 - scale_ * (up - middle(up_))};
  }
  [[nodiscard]] Spot place_of(std::size_t m) const {
    const MicConfig& mic = picture_.general->mics[m];
    return place(static_cast<double>(mic.mu[across_]), static_cast<double>(mic.mu[up_]));
  }

  void grid() {
    const auto lines = [&](std::size_t axis, double room, auto&& each) {
      const double reach = (room / 2 - kMargin) / scale_;
      for (double at = std::ceil((middle(axis) - reach) / step_) * step_; at <= middle(axis) + reach;
           at += step_) {
        each(std::abs(at) < 1e-9 ? 0.0 : at);
      }
    };
    const double left = corner_.x + kMargin, right = corner_.x + kPanel - kMargin;
    const double top = corner_.y + kMargin, bottom = corner_.y + height_ - kMargin;
    lines(across_, kPanel, [&](double at) {
      const double x = place(at, 0).x;
      line(canvas_, {x, top}, {x, bottom}, {.line = at == 0 ? kGrey : kFaint});
      canvas_.text({x, bottom + 14}, fmt::format("{:g}", std::round(at * 1e5) / 100),
                   {.size = 10, .anchor = Anchor::middle, .ink = kGrey});
    });
    lines(up_, height_, [&](double at) {
      const double y = place(0, at).y;
      line(canvas_, {left, y}, {right, y}, {.line = at == 0 ? kGrey : kFaint});
      canvas_.text({left - 4, y + 3.5}, fmt::format("{:g}", std::round(at * 1e5) / 100),
                   {.size = 10, .anchor = Anchor::right, .ink = kGrey});
    });
    static constexpr std::array kAxes{"x", "y", "z"};
    canvas_.text({right + 10, bottom + 14}, fmt::format("{}, mm", kAxes[across_]),
                 {.size = 10, .bold = true, .ink = kGrey});
    canvas_.text({left - 14, top - 8}, fmt::format("{}, mm", kAxes[up_]),
                 {.size = 10, .bold = true, .ink = kGrey});
  }

  void pointing(const MicConfig& mic) {
    const Vec3 out = normalized(Vec3{mic.direction[0], mic.direction[1], mic.direction[2]});
    if (is_omni(mic) && out.z > 0.99F) return;  // everywhere alike
    const std::array<float, 3> direction{out.x, out.y, out.z};
    const Spot from = place(static_cast<double>(mic.mu[across_]), static_cast<double>(mic.mu[up_]));
    const double dx = static_cast<double>(direction[across_]), dy = -static_cast<double>(direction[up_]);
    const double length = std::hypot(dx, dy);
    if (length < 0.1) return;
    const Spot tip{from.x + 30 * dx, from.y + 30 * dy};
    line(canvas_, from, tip, {.line = kBlue, .width = 1.5});
    const double ux = dx / length, uy = dy / length;
    canvas_.polyline(std::array{tip, Spot{tip.x - 7 * ux + 3.5 * uy, tip.y - 7 * uy - 3.5 * ux},
                                Spot{tip.x - 7 * ux - 3.5 * uy, tip.y - 7 * uy + 3.5 * ux}},
                     true, {.fill = kBlue});
  }

  void microphones(const std::vector<std::size_t>& here) {
    std::string numbers, channels;
    for (const std::size_t m : here) {
      numbers += fmt::format("{}{}", numbers.empty() ? "" : ", ", m + 1);
      if (!picture_.channels[m].empty()) channels += (channels.empty() ? "ch " : ", ") + picture_.channels[m];
    }
    const Spot at = place_of(here.front());
    const bool single = here.size() == 1;
    canvas_.circle(at, single ? 10 : 6,
                   {.fill = single ? Ink{1, 1, 1, 1} : kDark, .line = kDark, .width = 1.6});
    if (single) {
      canvas_.text({at.x, at.y + 4}, numbers, {.size = 11, .anchor = Anchor::middle, .bold = true});
    } else {
      canvas_.text({at.x + 9, at.y - 8}, numbers, {.size = 11, .bold = true});
    }
    if (up_ == 1) canvas_.text({at.x + 11, at.y + (single ? -8 : 16)}, channels, {.size = 9, .ink = kGrey});
  }

  Canvas& canvas_;
  const ArrayPicture& picture_;
  Spot corner_;
  double height_;
  std::size_t across_, up_;
  std::array<double, 3> least_{1e9, 1e9, 1e9}, most_{-1e9, -1e9, -1e9};
  double step_ = 0.01, scale_ = 1;
};

/// The error in azimuth around the array, at one elevation.
class Polar {
 public:
  Polar(Canvas& canvas, const DoaError& error, Spot corner)
      : canvas_(canvas), error_(error), centre_{corner.x + kPanel / 2, corner.y + kPanel / 2} {}

  void draw(double elevation) {
    std::vector<double> errors;
    double most = 0;
    for (int azimuth = 0; azimuth < 360; ++azimuth) {
      const auto at = error_.at(direction_of(static_cast<float>(azimuth), static_cast<float>(elevation)));
      errors.push_back(at ? std::min(at->azimuth_deg, 30.0) : -1);
      most = std::max(most, errors.back());
    }
    most_ = round_up(std::max(most, 0.1) * 1.05);
    rings();
    std::vector<Spot> part;
    const auto flush = [&](bool closed) {
      if (part.size() > 1) {
        canvas_.polyline(
            part, closed,
            {.fill = {kBlue.red, kBlue.green, kBlue.blue, closed ? 0.12 : 0.0}, .line = kBlue, .width = 2});
      }
      part.clear();
    };
    const bool whole = std::none_of(errors.begin(), errors.end(), [](double e) { return e < 0; });
    for (int azimuth = 0; azimuth < 360; ++azimuth) {
      const double e = errors[static_cast<std::size_t>(azimuth)];
      if (e < 0) {
        flush(false);
      } else {
        part.push_back(at(azimuth, e));
      }
    }
    flush(whole);
  }

 private:
  static constexpr double kRadius = kPanel / 2 - 42;

  [[nodiscard]] Spot at(double azimuth, double error) const {
    const double angle = azimuth * 3.14159265358979 / 180, r = kRadius * error / most_;
    return {centre_.x + r * std::cos(angle), centre_.y - r * std::sin(angle)};
  }

  void rings() {
    for (int ring = 1; ring <= 4; ++ring) {
      canvas_.circle(centre_, kRadius * ring / 4, {.line = ring == 4 ? kGrey : kFaint});
    }
    for (int azimuth = 0; azimuth < 360; azimuth += 30) {
      line(canvas_, centre_, at(azimuth, most_), {.line = kFaint});
      const Spot label = at(azimuth, most_ * 1.1);
      const int shown = azimuth > 180 ? azimuth - 360 : azimuth;
      canvas_.text(
          {label.x, label.y + 4}, fmt::format("{}", shown),
          {.size = 10, .anchor = Anchor::middle, .bold = azimuth == 0, .ink = azimuth == 0 ? kRed : kGrey});
    }
    for (const int ring : {2, 4}) {
      const Spot label = at(75, most_ * ring / 4);
      canvas_.text({label.x, label.y + 3}, fmt::format("{:.3g} deg", most_ * ring / 4),
                   {.size = 9, .anchor = Anchor::middle, .ink = kGrey});
    }
  }

  Canvas& canvas_;
  const DoaError& error_;
  Spot centre_;
  double most_ = 1;
};

constexpr double kExact = 0.1, kVague = 30;  // degrees: the ends of the scale, which is logarithmic

/// From dark blue (exact) over green to yellow (vague).
Ink shade(double error) {
  static constexpr std::array<Ink, 5> kScale{{{0.27, 0.0, 0.33, 1},
                                              {0.23, 0.32, 0.55, 1},
                                              {0.13, 0.57, 0.55, 1},
                                              {0.37, 0.79, 0.38, 1},
                                              {0.99, 0.91, 0.14, 1}}};
  const double at =
      std::clamp(std::log(error / kExact) / std::log(kVague / kExact), 0.0, 1.0) * (kScale.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), kScale.size() - 2);
  const double part = at - static_cast<double>(low);
  const auto mix = [&](double Ink::*c) { return (1 - part) * kScale[low].*c + part * kScale[low + 1].*c; };
  return {mix(&Ink::red), mix(&Ink::green), mix(&Ink::blue), 1};
}

/// The angle between estimate and truth, over azimuth and elevation.
void draw_map(Canvas& canvas, const DoaError& error, Spot corner) {
  constexpr int kStep = 5;
  constexpr double kLeft = 36, kTop = 22, kWidth = kPanel - 60, kHeight = 190;
  const auto x = [&](double azimuth) { return corner.x + kLeft + kWidth * (180 - azimuth) / 360; };
  const auto y = [&](double elevation) { return corner.y + kTop + kHeight * (90 - elevation) / 180; };
  for (int elevation = -90; elevation < 90; elevation += kStep) {
    for (int azimuth = -180; azimuth < 180; azimuth += kStep) {
      const auto at =
          error.at(direction_of(static_cast<float>(azimuth) + 2.5F, static_cast<float>(elevation) + 2.5F));
      const double right = x(azimuth) + 0.3, left = x(azimuth + kStep);
      const double bottom = y(elevation) + 0.3, top = y(elevation + kStep);
      canvas.polyline(std::array{Spot{left, top}, Spot{right, top}, Spot{right, bottom}, Spot{left, bottom}},
                      true, {.fill = at ? shade(at->angle_deg()) : Ink{0.93, 0.94, 0.95, 1}});
    }
  }
  for (int azimuth = -180; azimuth <= 180; azimuth += 90) {
    canvas.text(
        {x(azimuth), corner.y + kTop + kHeight + 15}, fmt::format("{}", azimuth),
        {.size = 10, .anchor = Anchor::middle, .bold = azimuth == 0, .ink = azimuth == 0 ? kRed : kGrey});
  }
  for (int elevation = -90; elevation <= 90; elevation += 45) {
    canvas.text({corner.x + kLeft - 6, y(elevation) + 4}, fmt::format("{}", elevation),
                {.size = 10, .anchor = Anchor::right, .ink = kGrey});
  }
  const double bar = corner.y + kTop + kHeight + 34;
  for (int i = 0; i < 100; ++i) {
    const double from = corner.x + kLeft + kWidth * i / 100, to = from + kWidth / 100 + 0.3;
    canvas.polyline(std::array{Spot{from, bar}, Spot{to, bar}, Spot{to, bar + 12}, Spot{from, bar + 12}},
                    true, {.fill = shade(kExact * std::pow(kVague / kExact, i / 100.0))});
  }
  for (const double e : {0.1, 0.3, 1.0, 3.0, 10.0, 30.0}) {
    canvas.text({corner.x + kLeft + kWidth * std::log(e / kExact) / std::log(kVague / kExact), bar + 26},
                fmt::format("{:g} deg", e), {.size = 10, .anchor = Anchor::middle, .ink = kGrey});
  }
  canvas.text({corner.x + kLeft, bar + 44}, "grey: not listened to", {.size = 10, .ink = kGrey});
}

}  // namespace

void draw_array(Canvas& canvas, const ArrayPicture& picture) {
  constexpr double kElevation = 20;
  constexpr double kLeft = 60, kRight = 620, kSide = 330;
  canvas.text({kLeft, 40}, picture.title, {.size = 20, .bold = true});
  canvas.text({kLeft, 60}, picture.subtitle, {.size = 12, .ink = kGrey});

  heading(canvas, {kLeft, 96}, "From above",
          "microphone in the circle, its channel beside it; arrows: where it points");
  View above(canvas, picture, {kLeft - kMargin, 112}, kPanel, 0, 1);
  above.draw();
  above.azimuth_zero();
  heading(canvas, {kLeft, 560}, "From the side", "as seen from -y: x to the right, z up");
  View(canvas, picture, {kLeft - kMargin, 576}, kSide, 0, 2).draw();

  heading(canvas, {kRight, 96}, "Expected error in azimuth",
          fmt::format("around the array, at {} deg of elevation", kElevation));
  Polar(canvas, *picture.error, {kRight - 10, 120}).draw(kElevation);
  heading(canvas, {kRight, 560}, "Expected error over the sphere",
          "angle to the truth; azimuth to the left, elevation up, degrees");
  draw_map(canvas, *picture.error, {kRight - 10, 576});
}

}  // namespace odas
