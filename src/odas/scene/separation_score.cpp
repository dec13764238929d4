// SPDX-License-Identifier: MIT
#include "odas/scene/separation_score.hpp"

#include <algorithm>
#include <cmath>

#include "odas/scene/correlation.hpp"
#include "odas/scene/projection.hpp"
#include "odas/scene/stoi.hpp"

namespace odas {
namespace {

constexpr std::size_t kLags = 8192;  // samples: what a system may be late

/// The hops in which a source is followed, and no other, of a sound.
class Mask {
 public:
  Mask(std::span<const HeardTrack> followed, std::size_t hop_size)
      : followed_(followed), hop_size_(hop_size) {}

  [[nodiscard]] std::vector<float> operator()(std::span<const float> sound, std::size_t samples) const {
    std::vector<float> out(samples, 0.F);
    for_each([&](std::size_t, const HeardTrack&, std::size_t begin, std::size_t end) {
      end = std::min({end, samples, sound.size()});
      for (std::size_t n = begin; n < end; ++n) out[n] = sound[n];
    });
    return out;
  }

  /// visit(hop, track, first sample, behind the last sample)
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t h = 0; h < followed_.size(); ++h) {
      if (followed_[h].id != 0) visit(h, followed_[h], h * hop_size_, (h + 1) * hop_size_);
    }
  }

  [[nodiscard]] std::size_t samples() const {
    const auto hops = std::ranges::count_if(followed_, [](const HeardTrack& t) { return t.id != 0; });
    return static_cast<std::size_t>(hops) * hop_size_;
  }

 private:
  std::span<const HeardTrack> followed_;
  std::size_t hop_size_;
};

std::vector<float> voice_of_source(const Mask& mask, const VoiceOf& voice_of, std::size_t hop_size,
                                   std::size_t samples) {
  std::vector<float> voice(samples, 0.F), hop_of_voice(hop_size);
  mask.for_each([&](std::size_t hop, const HeardTrack& track, std::size_t begin, std::size_t end) {
    voice_of(hop, track, hop_of_voice);
    for (std::size_t n = begin; n < std::min(end, samples); ++n) voice[n] = hop_of_voice[n - begin];
  });
  return voice;
}

void bring_forward(std::vector<float>& voice, std::size_t lag) {
  voice.erase(voice.begin(), voice.begin() + static_cast<long>(std::min(lag, voice.size())));
  voice.resize(voice.size() + lag, 0.F);
}

class Mean {
 public:
  void add(double value) {
    if (!std::isfinite(value)) return;  // nothing interferes
    sum_ += value;
    ++count_;
  }
  [[nodiscard]] std::optional<double> value() const {
    if (count_ == 0) return std::nullopt;
    return sum_ / static_cast<double>(count_);
  }

 private:
  double sum_ = 0;
  std::size_t count_ = 0;
};

struct Means {
  Mean sdr, si_sdr, sir, stoi;

  void add(std::span<const float> estimate, std::span<const float> target,
           std::span<const std::vector<float>> others, int sample_rate) {
    sdr.add(sdr_db(estimate, target));
    si_sdr.add(si_sdr_db(estimate, target));
    sir.add(sir_db(estimate, target, others));
    if (const auto share = odas::stoi(target, estimate, sample_rate)) stoi.add(*share);
  }
};

}  // namespace

std::optional<SeparationScore> score_separation(const KnownScene& scene, const KnownSound& sound,
                                                std::span<const std::vector<HeardTrack>> followed,
                                                const VoiceOf& voice_of) {
  Means out, in;
  for (std::size_t k = 0; k < sound.images.size(); ++k) {
    const Mask mask(followed[k], scene.hop_size);
    if (mask.samples() < static_cast<std::size_t>(scene.sample_rate)) continue;
    const std::size_t samples = sound.images[k].size();
    const auto target = mask(sound.images[k], samples);
    std::vector<std::vector<float>> others;
    for (std::size_t j = 0; j < sound.images.size(); ++j) {
      if (j != k) others.push_back(mask(sound.images[j], samples));
    }
    auto voice = voice_of_source(mask, voice_of, scene.hop_size, samples);
    bring_forward(voice, best_lag(voice, target, kLags));
    out.add(voice, target, others, scene.sample_rate);
    in.add(mask(sound.mic, samples), target, others, scene.sample_rate);
  }
  if (!out.sdr.value()) return std::nullopt;
  return SeparationScore{*out.sdr.value(), *in.sdr.value(), *out.si_sdr.value(), *in.si_sdr.value(),
                         out.sir.value(),  in.sir.value(),  out.stoi.value(),    in.stoi.value()};
}

}  // namespace odas
