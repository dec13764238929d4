// SPDX-License-Identifier: MIT
#include "tune_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace odas {
namespace {

/// The share of a histogram in [low, high).
double share(const EnergyHistogram& histogram, double low, double high) {
  double sum = 0;
  for (std::size_t bin = 0; bin < EnergyHistogram::kBins; ++bin) {
    const double energy = EnergyHistogram::energy(bin);
    if (energy >= low && energy < high) sum += histogram.count(bin);
  }
  return histogram.total() > 0 ? sum / histogram.total() : 0;
}

/// The share of a silence that alone would begin a track: ten times likelier active than not.
double taken_for_talk(const MeasuredMixtures& found, const EnergyHistogram& silence) {
  double sum = 0;
  for (std::size_t bin = 0; bin < EnergyHistogram::kBins; ++bin) {
    const double energy = EnergyHistogram::energy(bin);
    if (density(found.active, energy) > 10 * density(found.inactive, energy)) sum += silence.count(bin);
  }
  return sum / silence.total();
}

std::string bar(double part, std::size_t width) {
  const auto filled = static_cast<std::size_t>(std::lround(part * static_cast<double>(width)));
  // What is there at all is seen.
  return std::string(part > 0 ? std::max<std::size_t>(1, filled) : 0, '#');
}

}  // namespace

std::string histogram_text(const Energies& silence, const Energies& talk, double threshold) {
  constexpr std::size_t kRows = 24, kWidth = 32;
  const EnergyHistogram& nobody = silence.strongest;
  const double low = std::min({0.0, nobody.quantile(0.001), talk.strongest.quantile(0.001)});
  const double high = std::max(talk.strongest.quantile(0.998), nobody.quantile(0.998)) + 0.01;
  const double step = std::ceil((high - low) / kRows * 200) / 200;
  const double begin = std::floor(low / step) * step;

  double most_silence = 0, most_talk = 0;
  for (double e = begin; e < high; e += step) {
    most_silence = std::max(most_silence, share(nobody, e, e + step));
    most_talk = std::max(most_talk, share(talk.strongest, e, e + step));
  }
  std::string text =
      fmt::format("{:>13}  {:<{}}  {}\n", "E", "silence: the strongest of each hop", kWidth, "talk");
  bool marked = false;
  for (double e = begin; e < high; e += step) {
    const double s = share(nobody, e, e + step), t = share(talk.strongest, e, e + step);
    const bool here = !marked && threshold < e + step;
    marked = marked || here;
    std::string line = fmt::format("{:>5.3f}..{:>5.3f} {} {:<{}}  {}", e, e + step, here ? '>' : ' ',
                                   bar(most_silence > 0 ? s / most_silence : 0, kWidth), kWidth,
                                   bar(most_talk > 0 ? t / most_talk : 0, kWidth));
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

std::string mixture_value(const Mixture& mixture, const std::string& origin) {
  std::string text = "(  # " + origin + "\n";
  for (std::size_t k = 0; k < mixture.size(); ++k) {
    text += fmt::format("    {{ weight = {:.3f}; mu = {:.4f}; sigma2 = {:.6f}; }}{}\n", mixture[k].weight,
                        mixture[k].mu, mixture[k].sigma2, k + 1 < mixture.size() ? "," : "");
  }
  return text + "  )";
}

std::string verdict(const MeasuredMixtures& found, const Separation& apart, const Energies& silence) {
  std::string text = fmt::format(
      "Told apart at E = {:.3f}, marked >. A single potential is taken for the other kind in {:.1f} % "
      "(equal\n"
      "error); the densities share {:.0f} % of their area. Somebody was heard in {:.0f} % of the talk.\n",
      apart.threshold, 100 * apart.equal_error, 100 * apart.overlap, 100 * found.heard);
  if (apart.equal_error < 0.1) {
    text += "Good: talk stands clearly out of silence.\n";
  } else if (apart.equal_error < 0.25) {
    text += "Enough: tracks rest on several hops. Nearer talkers, or less noise and echo, would be better.\n";
  } else {
    text +=
        "Poor: talk hardly stands out. Measure nearer to the array, or without what hums and echoes; try\n"
        "ssl.weighting = \"snr\"; see with `odas array` and `odas check` whether positions and channels are "
        "right.\n";
  }
  const double loud = taken_for_talk(found, silence.strongest);
  if (loud > 0.01) {
    text += fmt::format(
        "In {:.0f} % of the silence something sounded like talk: was it silent? A machine that is always "
        "heard\n"
        "from one side is a source, too; a spatial filter keeps it out.\n",
        100 * loud);
  }
  if (found.heard < 0.2) text += "Little talk was heard: somebody should talk most of the time.\n";
  return text;
}

}  // namespace odas
