// SPDX-License-Identifier: MIT
// Time per hop of each stage, and of the whole, for arrays of 4, 7, 8 and 16 microphones (rings of 5 cm
// radius, half sphere, hops of 8 ms, frames of 16 ms, 4 potentials, 4 live tracks, ODAS's defaults).
#include <algorithm>
#include <cmath>
#include <random>

#include <benchmark/benchmark.h>

#include "odas/dsp/mcra.hpp"
#include "odas/dsp/stft.hpp"
#include "odas/localization/registry.hpp"
#include "odas/pipeline/pipeline.hpp"
#include "odas/separation/registry.hpp"
#include "odas/tracking/tracker.hpp"

namespace {

using namespace odas;

constexpr std::size_t kHop = 128;
constexpr std::size_t kFrame = 256;
constexpr std::size_t kBins = kFrame / 2 + 1;
constexpr std::size_t kSlots = 4;
constexpr double kHopSeconds = 0.008;

PipelineConfig config_for(std::int64_t mics) {
  PipelineConfig config;
  for (std::int64_t m = 0; m < mics; ++m) {
    const Vec3 p = 0.05F * direction_of(360 * static_cast<float>(m) / static_cast<float>(mics), 0);
    config.general.mics.push_back({{p.x, p.y, p.z}, {}, {0, 0, 1}, {180, 180}});
  }
  return config;
}

Grid<float> noise(std::size_t rows, std::size_t cols) {
  std::mt19937 random(1);
  std::normal_distribution<float> normal(0, 0.1F);
  Grid<float> grid(rows, cols);
  for (std::size_t r = 0; r < rows; ++r) {
    for (float& x : grid[r]) x = normal(random);
  }
  return grid;
}

Grid<cfloat> spectra_of_noise(std::size_t rows) {
  const Grid<float> hops = noise(rows, kHop);
  Stft stft(rows, kHop, kFrame);
  Grid<cfloat> spectra(rows, kBins);
  stft.analyse(hops, spectra);
  return spectra;
}

/// Four talkers, one of whom walks.
std::vector<Track> live_tracks(std::int64_t hop) {
  std::vector<Track> tracks(kSlots);
  for (std::size_t s = 0; s < kSlots; ++s) {
    const float walk = s == 0 ? 0.1F * static_cast<float>(hop % 3600) : 0;
    tracks[s] = {s + 1, "dynamic", direction_of(90 * static_cast<float>(s) + walk, 20), 1};
  }
  return tracks;
}

void stft(benchmark::State& state) {
  const auto mics = static_cast<std::size_t>(state.range(0));
  Stft stage(mics, kHop, kFrame);
  const Grid<float> hop = noise(mics, kHop);
  Grid<cfloat> spectra(mics, kBins);
  for (auto _ : state) stage.analyse(hop, spectra);
}

void noise_estimate(benchmark::State& state) {
  const auto mics = static_cast<std::size_t>(state.range(0));
  Mcra stage({}, mics, kBins);
  const Grid<cfloat> spectra = spectra_of_noise(mics);
  for (auto _ : state) stage.update(spectra);
}

void localization(benchmark::State& state) {
  const PipelineConfig config = config_for(state.range(0));
  const auto stage = make_localizer(config.general, config.ssl);
  const Grid<cfloat> spectra = spectra_of_noise(config.general.mics.size());
  std::vector<Potential> potentials(4);
  for (auto _ : state) stage->locate(spectra, {}, potentials);
}

/// As many potentials and live tracks as the argument says.
void tracking(benchmark::State& state, const char* mode) {
  SstConfig config;
  config.mode = mode;
  config.n_tracks = static_cast<int>(state.range(0));
  config.sigma_r2_prob = config.sigma_r2_active = state.range(0) > 4 ? 0.001F : 0.0225F;
  const auto stage = make_tracker(config, {kHopSeconds, 0.5, config.slots()});
  std::vector<Track> tracks(config.slots());
  std::vector<Potential> potentials;
  for (std::size_t s = 0; s < config.slots(); ++s) {  // Fibonacci's sphere
    const float z = 1 - (2 * static_cast<float>(s) + 1) / static_cast<float>(config.slots());
    potentials.push_back({direction_of(137.50776F * static_cast<float>(s), degrees(std::asin(z))), 0.45F});
  }
  for (auto _ : state) stage->update(potentials, tracks);
  state.counters["live"] = static_cast<double>(
      std::count_if(tracks.begin(), tracks.end(), [](const Track& t) { return t.id != 0; }));
}

void separation(benchmark::State& state, const char* mode) {
  PipelineConfig config = config_for(state.range(0));
  config.sss.mode_sep = mode;
  const auto stage = make_beamformer(config.sss, config.general, kSlots);
  const Grid<cfloat> spectra = spectra_of_noise(config.general.mics.size());
  Grid<cfloat> beams(kSlots, kBins);
  std::int64_t hop = 0;
  for (auto _ : state) stage->separate(spectra, live_tracks(++hop), beams);
}

void post_filter(benchmark::State& state, const char* mode) {
  PipelineConfig config = config_for(state.range(0));
  config.sss.mode_pf = mode;
  const auto beamformer = make_beamformer(config.sss, config.general, kSlots);
  const auto stage = make_post_filter(config.sss, config.sne, config.general, kSlots);
  const Grid<cfloat> spectra = spectra_of_noise(config.general.mics.size());
  Grid<float> noise_psd(spectra.rows(), kBins);
  noise_psd.fill(0.5F);
  Grid<cfloat> beams(kSlots, kBins);
  Grid<cfloat> filtered(kSlots, kBins);
  const auto tracks = live_tracks(0);
  beamformer->separate(spectra, tracks, beams);
  for (auto _ : state) stage->apply(spectra, noise_psd, tracks, *beamformer, beams, filtered);
}

void synthesis(benchmark::State& state) {
  Istft stage(kSlots, kHop, kFrame);
  const Grid<cfloat> spectra = spectra_of_noise(kSlots);
  Grid<float> hop(kSlots, kHop);
  for (auto _ : state) stage.synthesise(spectra, hop);
}

/// Potentials, tracks and delay-and-sum streams, of sound from four fixed directions played out of a store.
void whole_pipeline(benchmark::State& state) {
  PipelineConfig config = config_for(state.range(0));
  config.wanted.postfiltered = false;
  config.sst.add = "static";
  for (const Track& t : live_tracks(0)) {
    config.sst.target.push_back({std::to_string(t.id), t.direction.x, t.direction.y, t.direction.z});
  }
  Pipeline pipeline(config);
  const Grid<float> store = noise(config.general.mics.size(), 100 * kHop);
  std::size_t hop = 0;
  for (auto _ : state) {
    pipeline.process_hop({store.data() + hop % 100 * kHop, store.rows(), kHop, store.cols()});
    ++hop;
  }
  state.counters["seconds_per_100_s"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * kHopSeconds / 100,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void start_up(benchmark::State& state) {
  const PipelineConfig config = config_for(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(Pipeline(config));
}

void arrays(benchmark::internal::Benchmark* b) {
  b->ArgName("mics")->Arg(4)->Arg(7)->Arg(8)->Arg(16)->Unit(benchmark::kMicrosecond);
}

BENCHMARK(stft)->Apply(arrays);
BENCHMARK(noise_estimate)->Apply(arrays);
BENCHMARK(localization)->Apply(arrays);
BENCHMARK_CAPTURE(tracking, kalman, "kalman")
    ->ArgName("sources")
    ->Arg(4)
    ->Arg(16)
    ->Arg(64)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(tracking, particle, "particle")
    ->ArgName("sources")
    ->Arg(4)
    ->Arg(16)
    ->Arg(64)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(separation, dds, "dds")->Apply(arrays);
BENCHMARK_CAPTURE(separation, dgss, "dgss")->Apply(arrays);
BENCHMARK_CAPTURE(post_filter, ms, "ms")->Apply(arrays);
BENCHMARK_CAPTURE(post_filter, ss, "ss")->Apply(arrays);
BENCHMARK(synthesis)->Unit(benchmark::kMicrosecond);
BENCHMARK(whole_pipeline)->Apply(arrays);
BENCHMARK(start_up)->ArgName("mics")->Arg(4)->Arg(7)->Arg(8)->Arg(16)->Unit(benchmark::kMillisecond);

}  // namespace
