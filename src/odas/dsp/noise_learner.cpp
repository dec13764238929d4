// SPDX-License-Identifier: MIT
#include "odas/dsp/noise_learner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "odas/base/contract.hpp"
#include "odas/dsp/tiny_power.hpp"

namespace odas {
namespace {

constexpr double kSegment = 0.25;           // s
constexpr std::size_t kMostSegments = 512;  // kept
constexpr std::size_t kMostHops = 512;      // kept
constexpr double kWorth = 0.02;             // nats a bin that one more entry must bring
constexpr int kRounds = 6;                  // of assignment and mean
constexpr double kUneven = 2.5;             // dB

double power_of(GridView<const cfloat> spectra, BinRange bins) noexcept {
  double power = 0;
  for (std::size_t m = 0; m < spectra.rows(); ++m) {
    for (std::size_t k = bins.first; k <= bins.last; ++k)
      power += static_cast<double>(std::norm(spectra[m][k]));
  }
  return power;
}

}  // namespace

NoiseLearner::NoiseLearner(int sample_rate, std::size_t hop_size, std::size_t frame_size,
                           std::vector<Vec3> mics)
    : sample_rate_(sample_rate),
      hop_size_(hop_size),
      frame_size_(frame_size),
      mics_(std::move(mics)),
      bins_(telling_bins(sample_rate, frame_size)) {
  const double hops = static_cast<double>(sample_rate) / static_cast<double>(hop_size);
  segment_hops_ = std::max<std::size_t>(2 * mics_.size(), static_cast<std::size_t>(kSegment * hops));
  hops_a_second_ = std::max<std::size_t>(8, static_cast<std::size_t>(std::lround(hops)));
}

double NoiseLearner::seconds() const noexcept {
  return static_cast<double>(hops_) * static_cast<double>(hop_size_) / sample_rate_;
}

void NoiseLearner::hear(GridView<const cfloat> spectra) {
  ODAS_EXPECT(spectra.rows() == mics_.size() && spectra.cols() == frame_size_ / 2 + 1);
  const double power = power_of(spectra, bins_);
  if (!std::isfinite(power) || power <= 0) return;
  watch_level(spectra);
  keep(spectra);
  ++hops_;
  if (segments_.empty() || segments_.back().hops >= segment_hops_) {
    if (segments_.size() == kMostSegments) {  // neighbours become one
      for (std::size_t s = 0; s < kMostSegments / 2; ++s) {
        Segment& to = segments_[s];
        if (s > 0) to = std::move(segments_[2 * s]);
        const Segment& from = segments_[2 * s + 1];
        for (std::size_t i = 0; i < to.scm.size(); ++i) to.scm[i] += from.scm[i];
        to.hops += from.hops;
      }
      segments_.resize(kMostSegments / 2);
      segment_hops_ *= 2;
    }
    segments_.push_back({Scm(spectra.cols() * mics_.size() * mics_.size()), 0});
  }
  Segment& segment = segments_.back();
  cfloat* r = segment.scm.data();
  for (std::size_t k = 0; k < spectra.cols(); ++k) {
    for (std::size_t i = 0; i < mics_.size(); ++i) {
      for (std::size_t j = 0; j < mics_.size(); ++j) *r++ += spectra[i][k] * std::conj(spectra[j][k]);
    }
  }
  ++segment.hops;
}

void NoiseLearner::watch_level(GridView<const cfloat> spectra) {
  levels_.push_back(10 * std::log10(power_of(spectra, bins_)));
  if (levels_.size() < hops_a_second_) return;
  const auto n = static_cast<double>(levels_.size());
  const double mean = std::accumulate(levels_.begin(), levels_.end(), 0.0) / n;
  double variance = 0;
  for (const double level : levels_) variance += (level - mean) * (level - mean) / n;
  if (std::sqrt(variance) > kUneven) uneven_.push_back(hops_ / hops_a_second_);
  levels_.clear();
}

/// Some hops as they are, evenly over all that is heard.
void NoiseLearner::keep(GridView<const cfloat> spectra) {
  if (hops_ % keep_every_ != 0) return;
  if (kept_.size() == kMostHops) {
    for (std::size_t h = 0; h < kMostHops / 2; ++h) std::swap(kept_[h], kept_[2 * h]);
    kept_.resize(kMostHops / 2);
    keep_every_ *= 2;
    if (hops_ % keep_every_ != 0) return;
  }
  Grid<cfloat> copy(spectra.rows(), spectra.cols());
  for (std::size_t m = 0; m < spectra.rows(); ++m) {
    std::copy(spectra[m].begin(), spectra[m].end(), copy[m].begin());
  }
  kept_.push_back(std::move(copy));
}

/// The mean of the segments of an entry: of their shapes, each bin of each counting alike, at their mean
/// power.
NoiseLearner::Scm NoiseLearner::mean_of(const std::vector<std::size_t>& owner, std::size_t entry) const {
  const std::size_t mics = mics_.size();
  const std::size_t size = mics * mics;
  Scm mean(segments_.front().scm.size());
  for (std::size_t k = 0; k < mean.size() / size; ++k) {
    double power = 0;
    double count = 0;
    double hops = 0;
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      if (owner[s] != entry) continue;
      const cfloat* r = segments_[s].scm.data() + k * size;
      float trace = kTinyPower;
      for (std::size_t m = 0; m < mics; ++m) trace += r[m * mics + m].real();
      for (std::size_t i = 0; i < size; ++i) mean[k * size + i] += r[i] / trace;
      power += static_cast<double>(trace);
      hops += static_cast<double>(segments_[s].hops);
      ++count;
    }
    const auto scale = static_cast<float>(power / std::max(1.0, hops) / std::max(1.0, count));
    for (std::size_t i = 0; i < size; ++i) mean[k * size + i] *= scale;
  }
  return mean;
}

/// Gives each segment to the entry under which it is likeliest; the mean likeness.
double NoiseLearner::assign(const std::vector<NoiseModel>& models, std::vector<std::size_t>& owner) const {
  double sum = 0;
  for (std::size_t s = 0; s < segments_.size(); ++s) {
    float best = -std::numeric_limits<float>::infinity();
    for (std::size_t e = 0; e < models.size(); ++e) {
      const float likeness = models[e].likeness(segments_[s].scm);
      if (likeness > best) {
        best = likeness;
        owner[s] = e;
      }
    }
    sum += static_cast<double>(best);
  }
  return sum / static_cast<double>(segments_.size());
}

std::size_t NoiseLearner::least_likely(const std::vector<NoiseModel>& models) const {
  std::size_t worst = 0;
  float lowest = std::numeric_limits<float>::infinity();
  for (std::size_t s = 0; s < segments_.size(); ++s) {
    float best = -std::numeric_limits<float>::infinity();
    for (const NoiseModel& model : models) best = std::max(best, model.likeness(segments_[s].scm));
    if (best < lowest) {
      lowest = best;
      worst = s;
    }
  }
  return worst;
}

NoiseDictionary NoiseLearner::learn(std::size_t most) const {
  NoiseDictionary dictionary{sample_rate_, hop_size_, frame_size_, mics_, {}};
  if (segments_.empty() || hops_ < 4 * mics_.size()) return dictionary;
  std::vector<std::size_t> owner(segments_.size(), 0);
  const auto fit = [&](std::size_t entry) { return NoiseModel(mean_of(owner, entry), mics_.size(), bins_); };
  std::vector<NoiseModel> models{fit(0)};
  double likeness = assign(models, owner);
  const std::size_t limit = std::min({most, NoiseDictionary::kMostEntries, segments_.size()});
  while (models.size() < limit) {
    const std::vector<std::size_t> before = owner;
    std::vector<NoiseModel> more = models;
    more.emplace_back(segments_[least_likely(models)].scm, mics_.size(), bins_);
    double now = assign(more, owner);
    for (int round = 0; round < kRounds; ++round) {
      for (std::size_t e = 0; e < more.size(); ++e) {
        if (std::count(owner.begin(), owner.end(), e) > 0) more[e] = fit(e);
      }
      now = assign(more, owner);
    }
    if (now - likeness < kWorth) {
      owner = before;
      break;
    }
    likeness = now;
    models = std::move(more);
  }
  // A segment that is alone is a change from one state to another.
  std::vector<NoiseModel> lasting;
  for (std::size_t e = 0; e < models.size(); ++e) {
    if (std::count(owner.begin(), owner.end(), e) > 1) lasting.push_back(models[e]);
  }
  if (!lasting.empty() && lasting.size() < models.size()) {
    models = std::move(lasting);
    assign(models, owner);
  }
  for (std::size_t e = 0; e < models.size(); ++e) {
    const auto count = static_cast<float>(std::count(owner.begin(), owner.end(), e));
    if (count == 0) continue;
    dictionary.entries.push_back({count / static_cast<float>(segments_.size()), 0, 0, mean_of(owner, e)});
  }
  describe_hops(dictionary);
  return dictionary;
}

/// How like an entry the single hops are that belong to it.
void NoiseLearner::describe_hops(NoiseDictionary& dictionary) const {
  std::vector<NoiseModel> models;
  for (const NoiseDictionary::Entry& entry : dictionary.entries) {
    models.emplace_back(entry.scm, mics_.size(), bins_);
  }
  std::vector<std::vector<float>> likenesses(models.size());
  for (const Grid<cfloat>& hop : kept_) {
    std::size_t best = 0;
    float highest = -std::numeric_limits<float>::infinity();
    for (std::size_t e = 0; e < models.size(); ++e) {
      const float likeness = models[e].likeness(hop.view());
      if (likeness > highest) {
        highest = likeness;
        best = e;
      }
    }
    likenesses[best].push_back(highest);
  }
  for (std::size_t e = 0; e < models.size(); ++e) {
    const auto n = static_cast<float>(std::max<std::size_t>(1, likenesses[e].size()));
    float mean = 0;
    float variance = 0;
    for (const float x : likenesses[e]) mean += x / n;
    for (const float x : likenesses[e]) variance += (x - mean) * (x - mean) / n;
    dictionary.entries[e].likeness = mean;
    dictionary.entries[e].deviation = std::sqrt(variance);
  }
}

}  // namespace odas
