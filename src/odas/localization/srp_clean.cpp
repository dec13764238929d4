// SPDX-License-Identifier: MIT
#include "odas/localization/srp_clean.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace odas {
namespace {

std::size_t frame_size(const GeneralConfig& general) {
  return static_cast<std::size_t>(general.size.frame_size) / 2 * 2;
}

float bin_hz(const GeneralConfig& general) {
  return static_cast<float>(general.samplerate.mu) / static_cast<float>(frame_size(general));
}

constexpr std::array<Pair, 1> kSelf{{{0, 0}}};  // a channel with itself: the pattern of a plane wave

constexpr float kLeastEvidence = -6;
// How much sooner a hop is in the average, for the mean weight of its bins: that of a talker nearby is a
// tenth.
constexpr float kClearer = 60;
// After a potential of so little evidence no more are searched: they would have less.
constexpr float kNothing = -2;

/// Of what was not searched.
Potential none(Vec3 direction) noexcept { return {direction, 0, kLeastEvidence, {1, 1, 0}}; }

/// Log-odds of potentials on talkers against the others: lines over ln E, from a logistic regression over the
/// scenes of docs/localization.md. A single hop may be chance or a click; a talker fills six hops of the
/// average and more. Later potentials must stand out of what the first leaves over. Where one or a few talk,
/// the first has at least half of all that passes the gate (`share`); of a crowd it has a fifth: then the
/// onsets are as clear as a talker's, but come from everywhere.
float evidence(float energy, float strongest, float share, float hops) noexcept {
  constexpr float kMost = 8;
  constexpr float kOfTalkers = 0.5F;
  if (!(energy > 0)) return kLeastEvidence;
  const float crowd = std::min(std::log(std::max(share, 1e-3F) / kOfTalkers), 0.F);
  const float log_energy = std::log(energy);
  const float persistence = 1.2F * std::log(std::max(hops, 1.F) / 6);
  const float first = 11.3F + 1.36F * log_energy + persistence + 2.5F * crowd;
  const float later =
      7.6F + 0.65F * log_energy + 1.4F * std::log(energy / strongest) + persistence + 1.2F * crowd;
  return std::clamp(energy < strongest ? std::min(first, later) : first, kLeastEvidence, kMost);
}

/// The sharper the peak, the surer the direction: kPhase over E's curvature where the onset is clear, more
/// where it is faint. Where the array resolves little, reflections that it cannot tell apart add their own
/// error.
TangentCovariance covariance(const PeakFit::Fit& fit) noexcept {
  constexpr float kPhase = 0.005F;
  constexpr float kFaint = 0.0005F;     // E
  constexpr float kUnresolved = 0.3F;   // rad^2
  constexpr float kLeastCurvature = 1;  // of E, per E and rad^2
  const float energy = std::max(fit.energy, 1e-6F);
  const float east = std::max(fit.east / energy, kLeastCurvature);
  const float north = std::max(fit.north / energy, kLeastCurvature);
  float both = fit.cross / energy;
  float det = east * north - both * both;
  if (!(det > 0.1F * east * north)) {
    both = 0;
    det = east * north;
  }
  const float phase = kPhase * (1 + kFaint / energy);
  const auto variance = [phase](float width) {
    const float ratio = width / kUnresolved;
    return std::min(phase * width * (1 + ratio * ratio), 1.F);
  };
  const float var_east = variance(north / det);
  const float var_north = variance(east / det);
  return {var_east, var_north, -both / std::sqrt(east * north) * std::sqrt(var_east * var_north)};
}

}  // namespace

SrpClean::SrpClean(const GeneralConfig& general, const SslConfig& ssl)
    : plan_(general, ssl),
      table_(frame_size(general), ssl.interp_rate, plan_.half_lags),
      pattern_table_(frame_size(general), ssl.interp_rate, 2 * plan_.half_lags + 1),
      gate_(general.mics.size(), table_.bins(), hop_seconds_of(general), bin_hz(general)),
      diffuse_(general, plan_.pairs, table_, bin_hz(general)),
      hops_averaged_(ssl.averaging / (1000 * hop_seconds_of(general))),
      re_(general.mics.size(), padded(table_.bins())),
      im_(re_.rows(), re_.cols()),
      now_(plan_.pairs.size(), plan_.row_size),
      averaged_(now_.rows(), now_.cols()),
      rest_(now_.rows(), now_.cols()),
      root_(1, re_.cols()),
      nothing_(1, re_.cols()),
      pattern_now_(1, 2 * pattern_table_.half_lags() + 1),
      pattern_(1, pattern_now_.cols()),
      scratch_(std::max(lag_scratch_size(table_), lag_scratch_size(pattern_table_))),
      search_(plan_),
      fit_(general, plan_, ssl.interp_rate) {
  clear_.reserve(table_.bins());
}

void SrpClean::locate(GridView<const cfloat> spectra, GridView<const float> noise_psd,
                      std::span<Potential> potentials) noexcept {
  ODAS_EXPECT(spectra.rows() == re_.rows() && spectra.cols() == table_.bins());
  gate_.update(spectra, noise_psd);
  hear(spectra);
  average();
  float strongest = 0;
  for (std::size_t p = 0; p < potentials.size(); ++p) {
    const auto peak = search_.strongest(plan_, rest_, p == 0 ? std::span<float>(power_) : std::span<float>());
    const std::span<const std::uint8_t> heard = std::as_const(plan_.fine_heard)[peak.point];
    const auto fit = fit_.fit(rest_, heard, plan_.levels.back().directions[peak.point]);
    if (p == 0) strongest = fit.energy;
    potentials[p] = describe(fit, strongest);
    if (potentials[p].evidence < kNothing) {
      std::fill(potentials.begin() + static_cast<std::ptrdiff_t>(p) + 1, potentials.end(),
                none(fit.direction));
      break;
    }
    if (p + 1 < potentials.size()) subtract(fit, heard);
  }
}

void SrpClean::hear(GridView<const cfloat> spectra) noexcept {
  const std::span<const float> weights = gate_.weights();
  float* root = root_[0].data();
  clear_.clear();
  for (std::size_t k = 0; k < weights.size(); ++k) {
    root[k] = std::sqrt(weights[k]);
    if (root[k] > 0) clear_.push_back(static_cast<std::uint16_t>(k));
  }
  for (std::size_t m = 0; m < spectra.rows(); ++m) {
    const cfloat* x = spectra[m].data();
    float* re = re_[m].data();
    float* im = im_[m].data();
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const float power = x[k].real() * x[k].real() + x[k].imag() * x[k].imag();
      const bool heard = root[k] > 0 && power > 0 && power <= std::numeric_limits<float>::max();
      const float scale = heard ? root[k] / std::sqrt(power) : 0.F;
      re[k] = heard ? scale * x[k].real() : 0.F;
      im[k] = heard ? scale * x[k].imag() : 0.F;
    }
  }
}

void SrpClean::average() noexcept {
  lag_products(re_, im_, plan_.pairs, table_, clear_, scratch_, now_);
  diffuse_.subtract(gate_.diffuse(), table_, clear_, scratch_, now_);
  lag_products(root_, nothing_, kSelf, pattern_table_, clear_, scratch_, pattern_now_);
  const float clear = pattern_now_[0][pattern_table_.half_lags()];
  const float share = hops_averaged_ > 0 ? 1 - std::exp(-(1 + kClearer * clear) / hops_averaged_) : 1;
  const auto mix = [share](std::span<float> kept, std::span<const float> heard) {
    for (std::size_t n = 0; n < kept.size(); ++n) kept[n] += share * (heard[n] - kept[n]);
  };
  for (std::size_t q = 0; q < now_.rows(); ++q) {
    mix(averaged_[q], now_[q]);
    std::copy(averaged_[q].begin(), averaged_[q].end(), rest_[q].begin());
  }
  mix(pattern_[0], pattern_now_[0]);
  const float added = share * clear;
  squares_ = (1 - share) * (1 - share) * squares_ + added * added;
}

void SrpClean::subtract(const PeakFit::Fit& fit, std::span<const std::uint8_t> heard) noexcept {
  const std::size_t lags = 2 * plan_.half_lags + 1;
  const std::size_t middle = pattern_table_.half_lags();
  const float height = pattern_[0][middle];
  if (!(height > 0)) return;
  const float scale = fit.energy / height;
  for (std::size_t q = 0; q < plan_.pairs.size(); ++q) {
    if (heard[q] == 0) continue;
    // The pattern, shifted by a lag between two columns.
    const float first = static_cast<float>(middle - plan_.half_lags) - fit_.lag(q, fit.direction);
    const float whole = std::floor(first);
    const float late = scale * (first - whole);
    const float early = scale - late;
    const float* w = pattern_[0].data() + static_cast<std::size_t>(std::max(whole, 0.F));
    float* x = rest_[q].data();
    for (std::size_t n = 0; n < lags; ++n) x[n] -= early * w[n] + late * w[n + 1];
  }
}

Potential SrpClean::describe(const PeakFit::Fit& fit, float strongest) const noexcept {
  Potential potential{fit.direction, fit.energy};
  const float heard = pattern_[0][pattern_table_.half_lags()];
  potential.evidence = evidence(fit.energy, strongest, heard > 0 ? strongest / heard : 0.F, hops_heard());
  potential.covariance = covariance(fit);
  return potential;
}

float SrpClean::hops_heard() const noexcept {
  const float all = pattern_[0][pattern_table_.half_lags()];
  return squares_ > 0 ? all * all / squares_ : 0.F;
}

void SrpClean::reset() noexcept {
  squares_ = 0;
  gate_.reset();
  averaged_.fill(0);
  rest_.fill(0);
  pattern_.fill(0);
  std::fill(power_.begin(), power_.end(), 0.F);
}

}  // namespace odas
