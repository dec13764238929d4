// SPDX-License-Identifier: MIT
#include "odas/separation/talker_masks.hpp"

#include <algorithm>
#include <cmath>

#include "odas/base/contract.hpp"
#include "odas/dsp/tiny_power.hpp"
#include "odas/separation/factor_kernels.hpp"

namespace odas {
namespace {

// How far a talker's sound is from a plane wave: reflections, and microphones that are not where they should
// be.
constexpr float kSpread = 0.3F;
// White noise beside the diffuse: keeps low frequencies, where all microphones hear the same, solvable.
constexpr float kWhite = 0.1F;
// Weight of the past in the shares: a time constant of ten hops.
constexpr float kShareMemory = 0.9F;
// Nobody is ever ruled out.
constexpr float kLeastShare = 1e-3F;
// The floor lies under the mean power of the noise by about this factor.
constexpr float kMinimumBias = 2;

}  // namespace

BinBlocks diffuse_factor(const GeneralConfig& general, float white) {
  const std::size_t mics = general.mics.size();
  const std::size_t bins = static_cast<std::size_t>(general.size.frame_size) / 2 + 1;
  BinBlocks factor(factor_rows(mics), bins);
  std::vector<double> l(mics * mics);
  for (std::size_t k = 0; k < factor.blocks() * kBlockBins; ++k) {
    const double hertz =
        static_cast<double>(k) * general.samplerate.mu / static_cast<double>(general.size.frame_size);
    for (std::size_t j = 0; j < mics; ++j) {
      for (std::size_t i = j; i < mics; ++i) {
        const auto& a = general.mics[i].mu;
        const auto& b = general.mics[j].mu;
        const double apart = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
        const double x = 2 * M_PI * hertz * apart / static_cast<double>(general.speedofsound.mu);
        const double coherent = x > 0 ? std::sin(x) / x : 1;
        double sum = i == j ? 1 : (1 - static_cast<double>(white)) * coherent;
        for (std::size_t n = 0; n < j; ++n) sum -= l[i * mics + n] * l[j * mics + n];
        l[i * mics + j] = i == j ? std::sqrt(sum) : sum / l[j * mics + j];
        factor.set(factor_row(mics, i, j), k, {static_cast<float>(l[i * mics + j]), 0});
      }
    }
  }
  return factor;
}

TalkerMasks::TalkerMasks(const GeneralConfig& general, std::size_t slots)
    : mics_(general.mics.size()),
      bins_(static_cast<std::size_t>(general.size.frame_size) / 2 + 1),
      diffuse_(odas::diffuse_factor(general, kWhite)),
      looks_(slots),
      masks_(slots, BinReals(bins_)),
      whitened_(mics_, bins_),
      match_(1, bins_),
      energy_(bins_),
      diffuse_score_(bins_),
      sum_(bins_),
      loudness_(bins_),
      smoothed_(bins_) {
  for (Look& look : looks_) {
    look.pattern = BinBlocks(mics_, bins_);
    look.surety = look.narrowing = look.score = BinReals(bins_);
  }
}

void TalkerMasks::listen(std::size_t slot, const BinBlocks& steering) noexcept {
  Look& look = looks_[slot];
  if (!look.listens) look.share = 0.5F;
  look.listens = true;
  look.pattern = steering;
  BinReals& gain = look.surety;  // d^H G^-1 d, for now
  factor_forward(diffuse_, look.pattern, gain);
  for (std::size_t b = 0; b < look.pattern.blocks(); ++b) {
    for (std::size_t m = 0; m < mics_; ++m) {
      float* p = look.pattern.at(b, m);
      for (std::size_t i = 0; i < kBlockBins; ++i) {
        const float scale = 1 / std::sqrt(gain.data()[b * kBlockBins + i] + kTinyPower);
        p[i] *= scale;
        p[i + kBlockBins] *= scale;
      }
    }
  }
  for (std::size_t k = 0; k < bins_; ++k) {
    const float a = (1 - kSpread) / kSpread * gain[k];
    look.narrowing[k] = std::pow(1 + a, -1 / static_cast<float>(mics_));
    look.surety[k] = a / (1 + a);
  }
}

void TalkerMasks::leave(std::size_t slot) noexcept {
  looks_[slot].listens = false;
  masks_[slot].fill(0);
}

void TalkerMasks::update(const BinBlocks& x, std::span<const BinReals> powers,
                         const BinReals& floor) noexcept {
  ODAS_EXPECT(x.rows() == mics_ && x.bins() == bins_ && powers.size() == looks_.size());
  whitened_ = x;
  factor_forward(diffuse_, whitened_, energy_);

  float* inverse = diffuse_score_.data();
  diffuse_score_.fill(0);
  float listeners = 0;
  for (std::size_t s = 0; s < looks_.size(); ++s) {
    Look& look = looks_[s];
    if (!look.listens) continue;
    listeners += 1;
    score(look, powers[s]);
    const float* p = powers[s].data();
    for (std::size_t k = 0; k < bins_; ++k) inverse[k] += 1 / (p[k] + kTinyPower);
  }
  if (listeners == 0) return;
  for (std::size_t k = 0; k < bins_; ++k) {
    const float mean = (listeners + 1) / (inverse[k] + 1 / (kMinimumBias * floor[k] + kTinyPower));
    diffuse_score_[k] = mean * mean;
    loudness_[k] = std::sqrt(std::sqrt(energy_[k]));
  }
  share({loudness_.data(), bins_});  // the shares of this hop ...
  share({});                         // ... go into its masks
  for (std::size_t s = 0; s < looks_.size(); ++s) {
    if (!looks_[s].listens) continue;
    BinReals& mask = masks_[s];
    smoothed_ = mask;
    for (std::size_t k = 0; k < bins_; ++k) {
      const float below = smoothed_[k == 0 ? 0 : k - 1];
      const float above = smoothed_[k + 1 == bins_ ? k : k + 1];
      mask[k] = 0.25F * below + 0.5F * smoothed_[k] + 0.25F * above;
    }
  }
}

void TalkerMasks::score(Look& look, const BinReals& power) noexcept {
  inner_product(look.pattern, whitened_, match_);
  for (std::size_t b = 0; b < match_.blocks(); ++b) {
    const float* re = match_.at(b, 0);
    const float* im = re + kBlockBins;
    const std::size_t first = b * kBlockBins;
    for (std::size_t i = 0; i < kBlockBins; ++i) {
      const std::size_t k = first + i;
      const float ratio = std::min((re[i] * re[i] + im[i] * im[i]) / (energy_.data()[k] + kTinyPower), 1.F);
      const float likelihood = look.narrowing.data()[k] / (1 - look.surety.data()[k] * ratio);
      const float root = (power.data()[k] + kTinyPower) * likelihood;
      look.score.data()[k] = root * root;
    }
  }
}

/// Masks by the shares as they are; with `loudness`, the shares follow the masks.
void TalkerMasks::share(std::span<const float> loudness) noexcept {
  const float diffuse = diffuse_share_ + kLeastShare;
  for (std::size_t k = 0; k < bins_; ++k) sum_[k] = diffuse * diffuse_score_[k] + kTinyPower;
  for (const Look& look : looks_) {
    if (!look.listens) continue;
    const float pi = look.share + kLeastShare;
    for (std::size_t k = 0; k < bins_; ++k) sum_[k] += pi * look.score[k];
  }
  float all = kTinyPower;
  for (const float e : loudness) all += e;
  float others = 1;
  for (std::size_t s = 0; s < looks_.size(); ++s) {
    Look& look = looks_[s];
    if (!look.listens) continue;
    const float pi = look.share + kLeastShare;
    float heard = 0;
    for (std::size_t k = 0; k < bins_; ++k) masks_[s][k] = pi * look.score[k] / sum_[k];
    for (std::size_t k = 0; k < loudness.size(); ++k) heard += masks_[s][k] * loudness[k];
    if (!loudness.empty()) look.share += (1 - kShareMemory) * (heard / all - look.share);
    others -= look.share;
  }
  if (!loudness.empty()) diffuse_share_ = std::max(others, 0.F);
}

void TalkerMasks::reset() noexcept {
  for (std::size_t s = 0; s < looks_.size(); ++s) {
    leave(s);
    looks_[s].share = 0;
  }
  diffuse_share_ = 0;
}

}  // namespace odas
