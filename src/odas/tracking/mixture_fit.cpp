// SPDX-License-Identifier: MIT
#include "odas/tracking/mixture_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace odas {
namespace {

using Bins = std::array<double, EnergyHistogram::kBins>;
constexpr std::size_t kBins = EnergyHistogram::kBins;

constexpr int kMostGaussians = 3;
constexpr int kIterations = 300;
constexpr double kLeastVariance = 1e-4;
constexpr double kHopsThatAreAlike = 8;  // a frame of 16 ms every 8 ms, and words that last
constexpr double kLeastHeard = 0.05;     // of talk: less is chance
constexpr double kAlike = 0.35;          // equal error of what is no better than silence
constexpr double kTinyDensity = 1e-12;   // density far from everything

double gaussian(const GaussianConfig& g, double energy) noexcept {
  const double variance = g.sigma2;
  const double d = energy - g.mu;
  return g.weight / std::sqrt(2 * std::numbers::pi * variance) * std::exp(-0.5 * d * d / variance);
}

Bins densities(const Mixture& mixture) noexcept {
  Bins p{};
  for (std::size_t bin = 0; bin < kBins; ++bin) p[bin] = density(mixture, EnergyHistogram::energy(bin));
  return p;
}

/// What is known already, each with a weight that is not.
using Known = std::vector<Bins>;

struct Fit {
  Mixture mixture;  // weights sum, with those of the known, to 1
  std::vector<double> known_weights{};
  double log_likelihood = -std::numeric_limits<double>::infinity();
};

/// Begins at the quantiles, each Gaussian as wide as its part of the whole.
Fit beginning(const EnergyHistogram& data, int gaussians, const Known& known) {
  Fit fit;
  fit.known_weights.assign(known.size(), 0.5 / static_cast<double>(std::max<std::size_t>(1, known.size())));
  const double free = known.empty() ? 1 : 0.5;
  const double spread = data.quantile(0.9) - data.quantile(0.1);
  const double variance = std::max(kLeastVariance, spread * spread / (4.0 * gaussians * gaussians));
  // Beside what is known, what is new lies above it.
  const double from = known.empty() ? 0 : 0.4;
  for (int k = 0; k < gaussians; ++k) {
    const double share = from + (1 - from) * (k + 0.5) / gaussians;
    fit.mixture.push_back({static_cast<float>(free / gaussians), static_cast<float>(data.quantile(share)),
                           static_cast<float>(variance)});
  }
  return fit;
}

/// One step of expectation-maximization. Gives the log-likelihood of the parameters before it.
double step(const EnergyHistogram& data, const Known& known, Fit& fit) {
  struct Moments {
    double n = 0, sum = 0, squares = 0;
  };
  std::array<Moments, kMostGaussians> moments{};
  std::vector<double> known_counts(known.size(), 0.0);
  double log_likelihood = 0;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    const double count = data.count(bin);
    if (count == 0) continue;
    const double energy = EnergyHistogram::energy(bin);
    std::array<double, kMostGaussians> p{};
    double total = kTinyDensity;
    for (std::size_t k = 0; k < known.size(); ++k) total += fit.known_weights[k] * known[k][bin];
    for (std::size_t k = 0; k < fit.mixture.size(); ++k) total += p[k] = gaussian(fit.mixture[k], energy);
    log_likelihood += count * std::log(total);
    for (std::size_t k = 0; k < known.size(); ++k) {
      known_counts[k] += count * fit.known_weights[k] * known[k][bin] / total;
    }
    for (std::size_t k = 0; k < fit.mixture.size(); ++k) {
      const double share = count * p[k] / total;
      moments[k].n += share;
      moments[k].sum += share * energy;
      moments[k].squares += share * energy * energy;
    }
  }
  for (std::size_t k = 0; k < fit.mixture.size(); ++k) {
    const Moments& m = moments[k];
    if (m.n <= 0) continue;
    const double mean = m.sum / m.n;
    fit.mixture[k] = {static_cast<float>(m.n / data.total()), static_cast<float>(mean),
                      static_cast<float>(std::max(kLeastVariance, m.squares / m.n - mean * mean))};
  }
  for (std::size_t k = 0; k < known.size(); ++k) fit.known_weights[k] = known_counts[k] / data.total();
  return log_likelihood;
}

/// As many Gaussians as the Bayesian information criterion pays for.
Fit fit(const EnergyHistogram& data, const Known& known) {
  const double samples = std::max(2.0, data.total() / kHopsThatAreAlike);
  Fit best;
  double least = std::numeric_limits<double>::infinity();
  for (int gaussians = 1; gaussians <= kMostGaussians; ++gaussians) {
    Fit now = beginning(data, gaussians, known);
    for (int i = 0; i < kIterations; ++i) now.log_likelihood = step(data, known, now);
    const double bic = 3 * gaussians * std::log(samples) - 2 * now.log_likelihood / data.total() * samples;
    if (bic < least) {
      least = bic;
      best = now;
    }
  }
  return best;
}

void normalize(Mixture& mixture) {
  std::erase_if(mixture, [](const GaussianConfig& g) { return g.weight < 0.005F; });
  float sum = 0;
  for (const GaussianConfig& g : mixture) sum += g.weight;
  for (GaussianConfig& g : mixture) g.weight /= sum;
  std::sort(mixture.begin(), mixture.end(), [](const auto& a, const auto& b) { return a.mu < b.mu; });
}

double mean(const Mixture& mixture) {
  double sum = 0;
  for (const GaussianConfig& g : mixture) sum += static_cast<double>(g.weight) * g.mu;
  return sum;
}

/// Narrows the Gaussian that reaches furthest to `energy`; false where none can be narrowed.
bool narrow(Mixture& mixture, double energy) {
  const auto furthest = std::max_element(mixture.begin(), mixture.end(), [&](const auto& a, const auto& b) {
    return gaussian(a, energy) < gaussian(b, energy);
  });
  if (furthest->sigma2 <= static_cast<float>(kLeastVariance)) return false;
  furthest->sigma2 = std::max(static_cast<float>(kLeastVariance), 0.95F * furthest->sigma2);
  return true;
}

/// Below the E from which on the active win they must not win again, above they must not lose: from a little
/// below the least E that was measured, to 1, the most that there is.
void keep_order(Mixture& active, Mixture& inactive, double least) {
  constexpr double kBelow = 0.03, kMostEnergy = 1;
  const auto bin_of = [](double energy) {
    return static_cast<std::size_t>(
        std::max(0.0, (energy - EnergyHistogram::kLow) / EnergyHistogram::kWidth));
  };
  const std::size_t from = bin_of(least - kBelow), to = bin_of(kMostEnergy);
  for (bool changed = true; changed;) {
    changed = false;
    const Bins a = densities(active), i = densities(inactive);
    const std::size_t top = std::clamp(bin_of(active.back().mu), from, to);
    std::size_t crossing = top;
    while (crossing > from && a[crossing - 1] >= i[crossing - 1]) --crossing;
    for (std::size_t bin = from; bin < crossing && !changed; ++bin) {
      if (a[bin] > i[bin]) changed = narrow(active, EnergyHistogram::energy(bin));
    }
    for (std::size_t bin = to; bin > top && !changed; --bin) {
      if (i[bin] > a[bin]) changed = narrow(inactive, EnergyHistogram::energy(bin));
    }
  }
}

}  // namespace

double density(const Mixture& mixture, double energy) noexcept {
  double p = 0;
  for (const GaussianConfig& g : mixture) p += gaussian(g, energy);
  return p;
}

MeasuredMixtures fit_mixtures(const Heard& silence, const Heard& talk) {
  MeasuredMixtures found;
  if (silence.strongest.total() <= 0 || talk.strongest.total() <= 0) return found;
  const auto alone = [](const EnergyHistogram& data) {
    Mixture mixture = fit(data, {}).mixture;
    normalize(mixture);
    return mixture;
  };
  // The strongest of silence are the ones that a talker must surpass: they weigh as much as all others.
  EnergyHistogram others = silence.others;
  others.add(talk.others);
  EnergyHistogram nobody = silence.strongest;
  if (others.total() > 0) nobody.add(others, silence.strongest.total() / others.total());
  found.inactive = alone(nobody);

  const Mixture pauses = alone(silence.strongest);
  Known known{densities(pauses)};
  if (talk.others.total() > 0) known.push_back(densities(alone(talk.others)));
  const Fit heard = fit(talk.strongest, known);
  found.active = heard.mixture;
  const double above = mean(found.inactive);
  std::erase_if(found.active, [&](const GaussianConfig& g) { return g.mu <= above || g.weight < 0.01F; });
  for (const GaussianConfig& g : found.active) found.heard += static_cast<double>(g.weight);
  if (found.heard < kLeastHeard) found.active.clear();
  if (found.active.empty()) return found;
  normalize(found.active);
  if (separation(found.active, pauses).equal_error > kAlike) {
    found.active.clear();
    return found;
  }
  keep_order(found.active, found.inactive, nobody.quantile(0));
  return found;
}

Separation separation(const Mixture& active, const Mixture& inactive) noexcept {
  Separation result;
  if (active.empty() || inactive.empty()) return result;
  const Bins a = densities(active), i = densities(inactive);
  double active_below = 0, inactive_below = 0, shared = 0, least = 2;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    active_below += a[bin] * EnergyHistogram::kWidth;
    inactive_below += i[bin] * EnergyHistogram::kWidth;
    shared += std::min(a[bin], i[bin]) * EnergyHistogram::kWidth;
    const double missed = active_below, false_alarm = 1 - inactive_below;
    if (const double apart = std::abs(missed - false_alarm); apart < least) {
      least = apart;
      result.threshold = EnergyHistogram::energy(bin);
      result.equal_error = std::clamp((missed + false_alarm) / 2, 0.0, 1.0);
    }
  }
  result.overlap = std::clamp(shared, 0.0, 1.0);
  return result;
}

}  // namespace odas
