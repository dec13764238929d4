// SPDX-License-Identifier: MIT
#include "odas/scene/listening.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "odas/base/error.hpp"
#include "odas/engine/offline.hpp"
#include "odas/engine/sink.hpp"

namespace odas {
namespace {

class SceneSourceReader : public AudioSource {
 public:
  explicit SceneSourceReader(const PlayedScene& scene) : scene_(scene) {}

  [[nodiscard]] std::size_t channels() const noexcept override { return scene_.mics.rows(); }
  [[nodiscard]] int sample_rate() const noexcept override { return scene_.truth.sample_rate; }
  [[nodiscard]] bool live() const noexcept override { return false; }

  [[nodiscard]] ReadResult read(GridView<float> block) override {
    ReadResult result;
    result.frames = std::min(block.cols(), scene_.mics.cols() - at_);
    for (std::size_t m = 0; m < block.rows(); ++m) {
      std::ranges::copy(scene_.mics[m].subspan(at_, result.frames), block[m].begin());
    }
    at_ += result.frames;
    result.end = at_ == scene_.mics.cols();
    return result;
  }

 private:
  const PlayedScene& scene_;
  std::size_t at_ = 0;
};

/// One stream of voices, all slots, hop after hop. They come `late` hops after the sound that they are of,
/// and are given for that: neither is the first word of a track cut off, nor is the last one missing.
class KeptVoices {
 public:
  explicit KeptVoices(std::size_t late) : late_(late) {}

  void add(std::size_t hop, std::span<const Track> tracks, GridView<const float> voices) {
    if (voices.rows() == 0) return;
    hops_.resize(std::max(hops_.size(), hop + 1));
    auto& kept = hops_[hop];
    for (std::size_t s = 0; s < voices.rows(); ++s) {
      kept.ids.push_back(tracks[s].id);
      kept.sound.insert(kept.sound.end(), voices[s].begin(), voices[s].end());
    }
  }
  [[nodiscard]] bool empty() const { return hops_.empty(); }
  void of(std::size_t hop, const HeardTrack& track, std::span<float> out) const {
    std::ranges::fill(out, 0.F);
    const std::size_t at = track.slot * out.size();
    if (hop + late_ >= hops_.size()) return;
    const Hop& kept = hops_[hop + late_];
    if (track.slot >= kept.ids.size() || kept.ids[track.slot] != track.id) return;
    std::copy_n(kept.sound.begin() + static_cast<std::ptrdiff_t>(at), out.size(), out.begin());
  }

 private:
  struct Hop {
    std::vector<std::uint64_t> ids;  // [slot]
    std::vector<float> sound;        // [slot][sample]
  };
  std::size_t late_;
  std::vector<Hop> hops_;
};

class Listener : public Sink {
 public:
  Listener(Wanted wanted, std::size_t late)
      : wanted_(wanted),
        separated_(std::make_shared<KeptVoices>(late)),
        postfiltered_(std::make_shared<KeptVoices>(late)) {
    audition_.potentials.emplace();
  }

  [[nodiscard]] std::string name() const override { return "the listener of a scene"; }
  [[nodiscard]] Wanted wanted() const noexcept override { return wanted_; }

  IoStatus write(const HopResult& result) override {
    const auto hop = static_cast<std::size_t>(result.time - 1);
    HeardHop heard{hop, {}};
    for (std::size_t s = 0; s < result.tracks.size(); ++s) {
      if (result.tracks[s].id != 0)
        heard.tracks.push_back({s, result.tracks[s].id, direction(result.tracks[s].direction)});
    }
    audition_.tracks.push_back(std::move(heard));
    const auto strongest = std::ranges::max_element(result.potentials, {}, &Potential::energy);
    if (strongest != result.potentials.end()) {
      audition_.potentials->push_back({hop, direction(strongest->direction)});
    }
    separated_->add(hop, result.tracks, result.separated);
    postfiltered_->add(hop, result.tracks, result.postfiltered);
    return {};
  }

  [[nodiscard]] Audition take() {
    audition_.separated = voice_of(separated_);
    audition_.postfiltered = voice_of(postfiltered_);
    return std::move(audition_);
  }

 private:
  static Direction direction(Vec3 u) {
    return {static_cast<double>(u.x), static_cast<double>(u.y), static_cast<double>(u.z)};
  }
  static VoiceOf voice_of(const std::shared_ptr<KeptVoices>& voices) {
    if (voices->empty()) return {};
    return [voices](std::size_t hop, const HeardTrack& track, std::span<float> out) {
      voices->of(hop, track, out);
    };
  }

  Wanted wanted_;
  Audition audition_;
  std::shared_ptr<KeptVoices> separated_, postfiltered_;
};

float as_16_bit(float x) { return std::round(std::clamp(x * 32768.F, -32768.F, 32767.F)) / 32768.F; }

double as_in_a_file(float x) { return std::round(static_cast<double>(x) * 1e5) / 1e5; }

}  // namespace

PlayedScene played(const Scene& scene, SimulatedScene simulated) {
  PlayedScene result;
  result.truth.sample_rate = scene.sample_rate;
  result.truth.hop_size = scene.hop;
  result.truth.hops = scene.hops();
  for (SourceTruth& source : simulated.truth) {
    KnownSource known;
    for (const Vec3 u : source.direction) {
      known.direction.push_back({as_in_a_file(u.x), as_in_a_file(u.y), as_in_a_file(u.z)});
    }
    known.active = std::move(source.active);
    result.truth.sources.push_back(std::move(known));
  }
  result.mics = std::move(simulated.mics);
  for (std::size_t m = 0; m < result.mics.rows(); ++m) {
    for (float& x : result.mics[m]) x = as_16_bit(x);
  }
  result.sound.mic.assign(result.mics[0].begin(), result.mics[0].end());
  result.sound.images = std::move(simulated.images);
  for (auto& image : result.sound.images) {
    for (float& x : image) x = as_16_bit(x);
  }
  return result;
}

Audition listen(const PlayedScene& scene, Configuration config) {
  config.raw = RawConfig();
  config.raw.fs = scene.truth.sample_rate;
  config.raw.hop_size = config.pipeline.general.size.hop_size;
  config.raw.n_channels = static_cast<int>(scene.mics.rows());
  config.mapping = MappingConfig();
  Pipeline pipeline(config.pipeline);
  SceneSourceReader source(scene);
  const double hops_a_second = scene.truth.sample_rate / static_cast<double>(config.raw.hop_size);
  const auto late = static_cast<std::size_t>(std::lround(voice_delay_s(config.pipeline) * hops_a_second));
  Listener listener(config.pipeline.wanted, late);
  Sink* const sink = &listener;
  const RunSummary summary = run_offline(source, config, pipeline, std::span(&sink, 1), {});
  if (summary.exit_code() != 0) throw IoError(summary.fault);
  return listener.take();
}

}  // namespace odas
