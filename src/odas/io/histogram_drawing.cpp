// SPDX-License-Identifier: MIT
#include "odas/io/histogram_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace odas {
namespace {

constexpr Ink kTalk{0.1, 0.38, 0.7, 1}, kMark{0.8, 0.24, 0.16, 1};
constexpr double kLeft = 60, kRight = kHistogramWidth - 30, kTop = 96, kBottom = kHistogramHeight - 60;

/// Energies to the right; heights as parts of the tallest, which each curve has for itself: shapes are
/// compared.
class Plot {
 public:
  Plot(Canvas& canvas, double low, double high) : canvas_(canvas), low_(low), high_(high) {}

  [[nodiscard]] double x(double energy) const {
    return kLeft + (kRight - kLeft) * std::clamp((energy - low_) / (high_ - low_), 0.0, 1.0);
  }
  [[nodiscard]] static double y(double part) {
    return kBottom - (kBottom - kTop) * std::clamp(part, 0.0, 1.0);
  }

  void axis() {
    const double step = high_ - low_ > 0.6 ? 0.1 : 0.05;
    for (double e = std::ceil(low_ / step) * step; e <= high_; e += step) {
      canvas_.polyline(std::array{Spot{x(e), kTop}, Spot{x(e), kBottom}}, false, {.line = kFaint});
      canvas_.text({x(e), kBottom + 16}, fmt::format("{:.2f}", std::abs(e) < 1e-9 ? 0 : e),
                   {.size = 10, .anchor = Canvas::Anchor::middle, .ink = kGrey});
    }
    canvas_.polyline(std::array{Spot{kLeft, kBottom}, Spot{kRight, kBottom}}, false, {.line = kGrey});
    canvas_.text({(kLeft + kRight) / 2, kBottom + 38}, "E, energy of the strongest potential of a hop",
                 {.size = 11, .anchor = Canvas::Anchor::middle, .ink = kGrey});
  }

  void bars(const EnergyHistogram& histogram, Ink ink) {
    constexpr std::size_t kTogether = 5;  // bins of a thousandth
    std::vector<double> sums(EnergyHistogram::kBins / kTogether, 0.0);
    for (std::size_t bin = 0; bin < EnergyHistogram::kBins; ++bin)
      sums[bin / kTogether] += histogram.count(bin);
    const double most = std::max(1e-9, *std::max_element(sums.begin(), sums.end()));
    ink.alpha = 0.28;
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const double from =
          EnergyHistogram::kLow + EnergyHistogram::kWidth * kTogether * static_cast<double>(i);
      const double to = from + EnergyHistogram::kWidth * kTogether;
      if (sums[i] <= 0 || to < low_ || from > high_) continue;
      const double top = y(sums[i] / most);
      canvas_.polyline(
          std::array{Spot{x(from), kBottom}, Spot{x(from), top}, Spot{x(to), top}, Spot{x(to), kBottom}},
          true, {.fill = ink});
    }
  }

  void curve(const Mixture& mixture, Ink ink) {
    std::vector<Spot> spots;
    double most = 1e-9;
    const double step = (high_ - low_) / 400;
    for (int i = 0; i <= 400; ++i) most = std::max(most, density(mixture, low_ + step * i));
    for (int i = 0; i <= 400; ++i) {
      spots.push_back({x(low_ + step * i), y(density(mixture, low_ + step * i) / most)});
    }
    canvas_.polyline(spots, false, {.line = ink, .width = 2});
  }

  void mark(double energy) {
    canvas_.polyline(std::array{Spot{x(energy), kTop - 8}, Spot{x(energy), kBottom}}, false,
                     {.line = kMark, .width = 1.5, .dashed = true});
    canvas_.text({x(energy) + 5, kTop}, fmt::format("told apart at {:.3f}", energy),
                 {.size = 11, .ink = kMark});
  }

 private:
  Canvas& canvas_;
  double low_, high_;
};

}  // namespace

void draw_histograms(Canvas& canvas, const std::string& title, const Heard& silence, const Heard& talk,
                     const MeasuredMixtures& found, double threshold) {
  const double low = std::min(0.0, silence.strongest.quantile(0.001)) - 0.02;
  const double high = std::max(talk.strongest.quantile(0.999), silence.strongest.quantile(0.999)) + 0.05;
  canvas.text({kLeft, 36}, title, {.size = 17, .bold = true});
  canvas.text({kLeft, 58}, "silence", {.size = 12, .bold = true, .ink = kGrey});
  canvas.text({kLeft + 60, 58}, "and talk", {.size = 12, .bold = true, .ink = kTalk});
  canvas.text({kLeft + 125, 58},
              "as bars; the mixtures inactive and active as lines; each as high as its tallest",
              {.size = 11, .ink = kGrey});
  Plot plot(canvas, low, high);
  plot.axis();
  plot.bars(silence.strongest, kGrey);
  plot.bars(talk.strongest, kTalk);
  if (found.active.empty()) return;
  plot.curve(found.inactive, kGrey);
  plot.curve(found.active, kTalk);
  plot.mark(threshold);
}

}  // namespace odas
