// SPDX-License-Identifier: MIT
#include "odas/dsp/noise_field.hpp"

#include <algorithm>
#include <cmath>

#include "odas/base/contract.hpp"
#include "odas/dsp/cholesky.hpp"
#include "odas/dsp/tiny_power.hpp"

namespace odas {
namespace {

constexpr std::size_t kTurns = 8;     // hops in which all bins are renewed
constexpr float kLoading = 1e-3F;     // of the mean power of a microphone
constexpr float kUnlike = 3;          // standard deviations
constexpr float kUnlikeSeconds = 8;   // in which the unknown becomes noise
constexpr float kLead = 0.01F;        // nats a bin by which a rival must be likelier
constexpr float kScoreMemory = 0.8F;  // of the entry, which is asked in each hop
constexpr float kRivalMemory = 0.5F;  // of a rival, which is asked now and then

bool is_sound(GridView<const cfloat> spectra) noexcept {
  float power = 0;
  for (std::size_t m = 0; m < spectra.rows(); ++m) {
    for (const cfloat x : spectra[m]) power += std::norm(x);
  }
  return std::isfinite(power) && power > 0;
}

}  // namespace

NoiseField::NoiseField(NoiseDictionary dictionary)
    : dictionary_(std::move(dictionary)),
      mics_(dictionary_.mics.size()),
      bins_(dictionary_.bins()),
      second_(static_cast<float>(dictionary_.sample_rate) / static_cast<float>(dictionary_.hop_size)),
      scores_(dictionary_.entries.size()),
      live_(bins_ * mics_ * mics_),
      field_(live_.size()),
      factor_(mics_ * mics_) {
  ODAS_EXPECT(!dictionary_.empty());
  const BinRange bins = telling_bins(dictionary_.sample_rate, dictionary_.frame_size);
  for (const NoiseDictionary::Entry& entry : dictionary_.entries) {
    ODAS_EXPECT(entry.scm.size() == live_.size());
    models_.emplace_back(entry.scm, mics_, bins);
  }
  for (std::size_t m = 0; m < mics_; ++m) columns_.emplace_back(mics_, bins_);
  reset();
}

void NoiseField::reset() noexcept {
  // What was heard most, until something is heard.
  const auto& entries = dictionary_.entries;
  const auto most = std::max_element(entries.begin(), entries.end(),
                                     [](const auto& a, const auto& b) { return a.share < b.share; });
  entry_ = static_cast<std::size_t>(most - entries.begin());
  rival_ = entry_;
  for (std::size_t e = 0; e < scores_.size(); ++e) scores_[e] = entries[e].likeness - entries[e].deviation;
  heard_ = quiet_for_ = 0;
  turn_ = 0;
  heard_noise_ = false;
  std::fill(live_.begin(), live_.end(), cfloat{});
  for (std::size_t k = 0; k < bins_; ++k) renew(k);
}

void NoiseField::update(GridView<const cfloat> spectra, bool somebody_speaks) noexcept {
  ODAS_EXPECT(spectra.rows() == mics_ && spectra.cols() == bins_);
  if (!is_sound(spectra)) return;
  quiet_for_ = somebody_speaks ? 0 : std::min(quiet_for_ + 1, 2 * second_);
  heard_noise_ = choose(spectra);
  if (heard_noise_) {
    heard_ = std::min(heard_ + 1, second_);
    follow(spectra, 1 / heard_);
  } else if (quiet_for_ > second_) {
    follow(spectra, 1 / (kUnlikeSeconds * second_));
  }
  for (std::size_t k = turn_; k < bins_; k += kTurns) renew(k);
  turn_ = (turn_ + 1) % kTurns;
}

/// Asks the entry and one rival. Whether the hop is as one of them was learned.
bool NoiseField::choose(GridView<const cfloat> spectra) noexcept {
  const auto& entries = dictionary_.entries;
  const auto is_like = [&](std::size_t e, float likeness) {
    return likeness > entries[e].likeness - kUnlike * entries[e].deviation;
  };
  const float likeness = models_[entry_].likeness(spectra);
  bool like = is_like(entry_, likeness);
  float of_rival = 0;
  if (models_.size() > 1) {
    do rival_ = (rival_ + 1) % models_.size();
    while (rival_ == entry_);
    of_rival = models_[rival_].likeness(spectra);
    like = like || is_like(rival_, of_rival);
  }
  if (!like && quiet_for_ <= second_) return false;
  scores_[entry_] += (1 - kScoreMemory) * (likeness - scores_[entry_]);
  if (models_.size() == 1) return like;
  scores_[rival_] += (1 - kRivalMemory) * (of_rival - scores_[rival_]);
  if (scores_[rival_] > scores_[entry_] + kLead) {
    entry_ = rival_;
    heard_ = 0;
  }
  return like;
}

void NoiseField::follow(GridView<const cfloat> spectra, float gain) noexcept {
  cfloat* r = live_.data();
  for (std::size_t k = 0; k < bins_; ++k) {
    for (std::size_t i = 0; i < mics_; ++i) {
      const cfloat x = spectra[i][k];
      for (std::size_t j = 0; j < mics_; ++j, ++r) *r += gain * (x * std::conj(spectra[j][k]) - *r);
    }
  }
}

/// R and its factor, of one bin.
void NoiseField::renew(std::size_t bin) noexcept {
  const std::size_t size = mics_ * mics_;
  const std::span<const cfloat> known = dictionary_.scm(entry_, bin);
  const cfloat* live = live_.data() + bin * size;
  cfloat* field = field_.data() + bin * size;
  float known_power = kTinyPower;
  float live_power = 0;
  for (std::size_t m = 0; m < mics_; ++m) {
    known_power += known[m * mics_ + m].real();
    live_power += live[m * mics_ + m].real();
  }
  constexpr float kTrust = 2;  // hops that the level as learned is worth
  const float level = (heard_ * live_power / known_power + kTrust) / (heard_ + kTrust);
  const auto prior = 2 * static_cast<float>(mics_);
  const float of_live = heard_ / (heard_ + prior);
  const float of_known = level * prior / (heard_ + prior);
  float power = kTinyPower;
  for (std::size_t i = 0; i < size; ++i) field[i] = of_live * live[i] + of_known * known[i];
  for (std::size_t m = 0; m < mics_; ++m) power += field[m * mics_ + m].real() / static_cast<float>(mics_);
  for (std::size_t m = 0; m < mics_; ++m) field[m * mics_ + m] += kLoading * power;
  std::copy_n(field, size, factor_.begin());
  cholesky(factor_, mics_, 1e-6F * power);
  for (std::size_t j = 0; j < mics_; ++j) {
    for (std::size_t m = j; m < mics_; ++m) columns_[j][m][bin] = factor_[m * mics_ + j];
  }
}

GridView<const cfloat> NoiseField::scm(std::size_t bin) const noexcept {
  return {field_.data() + bin * mics_ * mics_, mics_, mics_};
}

}  // namespace odas
