// SPDX-License-Identifier: MIT
#include "odas/pipeline/pipeline.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "odas/classification/registry.hpp"
#include "odas/dsp/mcra.hpp"
#include "odas/dsp/noise_field.hpp"
#include "odas/dsp/stft.hpp"
#include "odas/localization/registry.hpp"
#include "odas/pipeline/input_guard.hpp"
#include "odas/pipeline/lookback.hpp"
#include "odas/pipeline/muting.hpp"
#include "odas/separation/registry.hpp"
#include "odas/tracking/tracker.hpp"

namespace odas {
namespace {

/// What is computed follows from what is wanted: each stage because of the later ones that need it.
struct Stages {
  explicit Stages(const Wanted& wanted)
      : post_filter(wanted.postfiltered),
        classifier(wanted.categories),
        separated(wanted.separated || classifier),
        beamformer(separated || post_filter),
        tracker(wanted.tracks || beamformer),
        localizer(wanted.potentials || wanted.power_map || tracker) {}
  bool post_filter, classifier, separated, beamformer, tracker, localizer;
};

// Nobody looks at reports more often, and they cost logarithms.
constexpr HopIndex kReportHops = 12;

/// Whether a source that is followed sounds.
bool anybody_speaks(std::span<const Track> tracks) noexcept {
  constexpr float kSounds = 0.5F;
  return std::any_of(tracks.begin(), tracks.end(),
                     [](const Track& track) { return track.id != 0 && track.activity > kSounds; });
}

std::size_t size(int value) { return static_cast<std::size_t>(value); }

}  // namespace

struct Pipeline::Parts {
  explicit Parts(const PipelineConfig& config);

  [[nodiscard]] std::size_t slots() const noexcept { return tracks.size(); }

  // What the configuration says
  Wanted wanted;
  McraConfig sne;
  std::size_t mics, hop_size, frame_size, voice_frame;
  int sample_rate;

  StageWatch watch;

  // The stages; those that nobody needs are absent
  InputGuard guard;
  Stft stft;
  std::optional<Stft> voice_stft;  // where separation has a frame of its own
  LookBack lookback;
  std::optional<Mcra> noise;
  std::optional<Mcra> voice_noise;        // of the bins of voice_stft
  std::optional<NoiseField> known_noise;  // of the machine itself
  std::unique_ptr<Localizer> localizer;
  std::unique_ptr<Tracker> tracker;
  Muting muting;
  std::unique_ptr<Beamformer> beamformer;
  std::unique_ptr<PostFilter> post_filter;
  std::optional<Istft> separated_istft, postfiltered_istft;
  std::unique_ptr<Classifier> classifier;

  // What goes from stage to stage
  HopIndex time = 0;
  Grid<cfloat> spectra;  // [mic][bin], where separation has spectra of its own; else they go to look-back
  std::vector<Potential> potentials;
  std::vector<Track> tracks;            // [slot]
  Grid<cfloat> beams, filtered;         // [slot][bin]
  Grid<float> separated, postfiltered;  // [slot][hop]
  std::vector<BeamReport> reports;      // [slot]
};

Pipeline::Parts::Parts(const PipelineConfig& config)
    : wanted(config.wanted),
      sne(config.sne),
      mics(config.general.mics.size()),
      hop_size(size(config.general.size.hop_size)),
      frame_size(size(config.general.size.frame_size) / 2 * 2),
      voice_frame(Stages(wanted).beamformer ? separation_frame(config) : frame_size),
      sample_rate(config.general.samplerate.mu),
      guard(mics, hop_size),
      stft(mics, hop_size, frame_size),
      lookback(Stages(wanted).beamformer ? odas::lookback_hops(config) : 0, mics, voice_frame / 2 + 1,
               config.sst.slots()),
      tracks(config.sst.slots()) {
  const Stages stages(wanted);
  GeneralConfig heard = config.general;  // as separation sees it
  heard.size.frame_size = static_cast<int>(voice_frame);
  if (stages.localizer) {
    localizer = make_localizer(config.general, config.ssl);
    potentials.resize(size(config.ssl.n_pots));
    if (wanted.power_map) localizer->keep_power_map();
  }
  if (stages.tracker) {
    tracker = make_tracker(config.sst, {static_cast<double>(hop_size) / sample_rate,
                                        localizer->plan().heard_share, potentials.size()});
  }
  if (stages.beamformer) {
    beamformer = make_beamformer(config.sss, heard, slots());
    beams = Grid<cfloat>(slots(), voice_frame / 2 + 1);
    reports.resize(slots());
    if (!config.known_noise.empty()) {
      known_noise.emplace(config.known_noise);
      beamformer->use_noise(&*known_noise);
    }
  }
  if (stages.separated) {
    separated_istft.emplace(slots(), hop_size, voice_frame);
    separated = Grid<float>(slots(), hop_size);
  }
  if (stages.classifier) classifier = make_classifier(config.classify, hop_size, slots());
  if (stages.post_filter) {
    post_filter = make_post_filter(config.sss, config.sne, heard, slots());
    filtered = Grid<cfloat>(slots(), voice_frame / 2 + 1);
    postfiltered_istft.emplace(slots(), hop_size, voice_frame);
    postfiltered = Grid<float>(slots(), hop_size);
  }
  const bool apart = voice_frame != frame_size;
  if (apart) {
    voice_stft.emplace(mics, hop_size, voice_frame);
    spectra = Grid<cfloat>(mics, stft.bins());
  }
  const bool noise_for_filter = post_filter && post_filter->needs_noise();
  if ((localizer && localizer->needs_noise()) || (noise_for_filter && !apart)) {
    noise.emplace(config.sne, mics, stft.bins());
  }
  if (noise_for_filter && apart) voice_noise.emplace(config.sne, mics, voice_stft->bins());
}

Pipeline::Pipeline(const PipelineConfig& config) : parts_(std::make_unique<Parts>(config)) {}
Pipeline::~Pipeline() = default;
Pipeline::Pipeline(Pipeline&&) noexcept = default;
Pipeline& Pipeline::operator=(Pipeline&&) noexcept = default;

HopResult Pipeline::process_hop(GridView<const float> mics) noexcept {
  Parts& p = *parts_;
  ODAS_EXPECT(mics.rows() == p.mics && mics.cols() == p.hop_size);
  ++p.time;
  p.watch.begin();
  const GridView<const float> heard = p.guard.pass(mics);
  const GridView<cfloat> kept = p.lookback.begin_hop();
  const GridView<cfloat> spectra = p.voice_stft ? p.spectra.view() : kept;
  p.stft.analyse(heard, spectra);
  if (p.voice_stft) p.voice_stft->analyse(heard, kept);
  p.watch.spent_on(Stage::transform);
  if (p.noise) p.noise->update(spectra);
  if (p.voice_noise) p.voice_noise->update(kept);
  const GridView<const float> noise_psd = p.noise ? p.noise->psd() : GridView<const float>();
  const GridView<const float> voice_psd = p.voice_noise ? p.voice_noise->psd() : noise_psd;
  p.watch.spent_on(Stage::noise);
  if (p.localizer) p.localizer->locate(spectra, noise_psd, p.potentials);
  p.muting.hush(p.potentials);
  p.watch.spent_on(Stage::localization);
  if (p.tracker) p.tracker->update(p.potentials, p.tracks);
  p.muting.hush(p.tracks);
  p.watch.spent_on(Stage::tracking);

  // Voices are heard as they were some hops ago, by what is known now.
  const GridView<const cfloat> then = p.lookback.spectra();
  const std::span<const Track> voices = p.lookback.recall(p.tracks);
  if (p.known_noise) p.known_noise->update(then, anybody_speaks(voices));
  if (p.beamformer) p.beamformer->separate(then, voices, p.beams);
  if (p.time % kReportHops == 0) {
    for (std::size_t s = 0; s < p.reports.size(); ++s) {
      p.reports[s] = voices[s].id != 0 ? p.beamformer->report(s) : BeamReport{};
      p.reports[s].id = voices[s].id;
    }
  }
  p.watch.spent_on(Stage::separation);
  if (p.separated_istft) p.separated_istft->synthesise(p.beams, p.separated);
  p.watch.spent_on(Stage::synthesis);
  if (p.classifier) p.classifier->classify(p.separated, p.tracks);
  p.watch.spent_on(Stage::classification);
  if (p.post_filter) {
    p.post_filter->apply(then, voice_psd, voices, *p.beamformer, p.beams, p.filtered);
    p.watch.spent_on(Stage::post_filter);
    p.postfiltered_istft->synthesise(p.filtered, p.postfiltered);
    p.watch.spent_on(Stage::synthesis);
  }
  HopResult result{p.time, p.potentials, p.tracks, p.separated, p.postfiltered};
  result.reports = p.reports;
  if (p.wanted.mics) result.mics = heard;
  if (p.localizer) result.power = p.localizer->power_map();
  return result;
}

void Pipeline::skip_hops(HopIndex hops) noexcept { parts_->time += hops; }

void Pipeline::set_targets(std::span<const Target> targets) noexcept {
  if (parts_->tracker) parts_->tracker->set_targets(targets);
}
void Pipeline::set_muted(std::span<const Target> directions) noexcept { parts_->muting.set(directions); }
std::size_t Pipeline::unfollowed_targets() const noexcept {
  return parts_->tracker ? parts_->tracker->unfollowed_targets() : 0;
}

void Pipeline::time_stages(StageWatch::Clock clock) noexcept { parts_->watch.use(clock); }
const StageTimes& Pipeline::stage_times() const noexcept { return parts_->watch.times(); }

bool Pipeline::can_continue(const Pipeline& before) const noexcept {
  const Parts& p = *parts_;
  const Parts& b = *before.parts_;
  return p.mics == b.mics && p.hop_size == b.hop_size && p.frame_size == b.frame_size &&
         p.voice_frame == b.voice_frame && p.sample_rate == b.sample_rate && p.slots() == b.slots() &&
         p.potentials.size() == b.potentials.size() && p.lookback.hops() == b.lookback.hops() &&
         p.wanted == b.wanted && power_grid().size() == before.power_grid().size();
}

void Pipeline::continue_from(Pipeline& before) noexcept {
  ODAS_EXPECT(can_continue(before));
  Parts& p = *parts_;
  Parts& b = *before.parts_;
  p.time = b.time;
  p.watch = b.watch;
  std::swap(p.guard, b.guard);
  std::swap(p.stft, b.stft);
  std::swap(p.voice_stft, b.voice_stft);
  std::swap(p.lookback, b.lookback);
  std::swap(p.separated_istft, b.separated_istft);
  std::swap(p.postfiltered_istft, b.postfiltered_istft);
  if (p.noise && b.noise && p.sne == b.sne) std::swap(p.noise, b.noise);
  if (p.voice_noise && b.voice_noise && p.sne == b.sne) std::swap(p.voice_noise, b.voice_noise);
  p.muting = b.muting;
  if (p.tracker) p.tracker->continue_from(*b.tracker);
}

void Pipeline::reset() noexcept {
  Parts& p = *parts_;
  p.time = 0;
  std::fill(p.reports.begin(), p.reports.end(), BeamReport{});
  p.muting.set({});
  p.guard.reset();
  p.stft.reset();
  if (p.voice_stft) p.voice_stft->reset();
  p.lookback.reset();
  if (p.noise) p.noise->reset();
  if (p.voice_noise) p.voice_noise->reset();
  if (p.localizer) p.localizer->reset();
  if (p.tracker) p.tracker->reset();
  if (p.known_noise) p.known_noise->reset();
  if (p.beamformer) p.beamformer->reset();
  if (p.separated_istft) p.separated_istft->reset();
  if (p.classifier) p.classifier->reset();
  if (p.post_filter) p.post_filter->reset();
  if (p.postfiltered_istft) p.postfiltered_istft->reset();
}

std::size_t Pipeline::mics() const noexcept { return parts_->mics; }
std::size_t Pipeline::hop_size() const noexcept { return parts_->hop_size; }
std::size_t Pipeline::slots() const noexcept { return parts_->slots(); }
int Pipeline::sample_rate() const noexcept { return parts_->sample_rate; }
std::span<const Vec3> Pipeline::power_grid() const noexcept {
  return parts_->wanted.power_map ? parts_->localizer->power_grid() : std::span<const Vec3>();
}
std::size_t Pipeline::lookback_hops() const noexcept { return parts_->lookback.hops(); }
std::uint64_t Pipeline::non_finite_samples() const noexcept { return parts_->guard.refused(); }

Pipeline::Plan Pipeline::plan() const {
  const Parts& p = *parts_;
  Plan plan;
  plan.transform_ms = 1000.0 * static_cast<double>(p.voice_frame - p.hop_size) / p.sample_rate;
  plan.lookback_ms = 1000.0 * static_cast<double>(p.lookback.hops() * p.hop_size) / p.sample_rate;
  plan.memory_bytes = p.lookback.memory_bytes() +
                      sizeof(float) * (p.mics * (p.frame_size + p.hop_size) +
                                       (p.voice_stft ? p.mics * (p.voice_frame + 2 * p.stft.bins()) : 0) +
                                       2 * p.beams.cols() * (p.beams.rows() + p.filtered.rows()) +
                                       p.slots() * (p.voice_frame + p.hop_size) *
                                           (p.wanted.separated + p.wanted.postfiltered));
  if (p.localizer) {
    const LocalizerPlan located = p.localizer->plan();
    plan.pairs = located.pairs;
    plan.pairs_used = located.pairs_used;
    for (const auto& scan : located.scans)
      plan.scans.push_back({scan.level, scan.points, scan.active_points});
    plan.lags = located.lags;
    plan.half_sphere = located.half_sphere;
    plan.memory_bytes += located.memory_bytes;
  }
  return plan;
}

}  // namespace odas
