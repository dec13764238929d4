// SPDX-License-Identifier: MIT
// A robot's own program with odas_core alone: a sound comes from azimuth 40 degrees. Where does odas hear it?
#include <cmath>
#include <cstdio>

#include "odas/pipeline/pipeline.hpp"

// A sound with something in every band; t in seconds.
double sound(double t) {
  double sum = 0;
  for (int i = 1; i <= 50; ++i) sum += std::sin(2 * 3.141592653589793 * 139.7 * i * t + i * i);
  return 0.01 * sum;
}

int main() {
  odas::PipelineConfig config;
  config.wanted = {.potentials = true, .tracks = false, .separated = false, .postfiltered = false};
  for (const float x : {-0.03F, 0.03F}) {
    for (const float y : {-0.03F, 0.03F}) config.general.mics.push_back({.mu = {x, y, 0}});
  }
  odas::Pipeline pipeline(config);

  const odas::Vec3 source = odas::direction_of(40, 0);
  odas::Grid<float> samples(pipeline.mics(), pipeline.hop_size());
  for (std::size_t hop = 0; hop < 50; ++hop) {
    for (std::size_t mic = 0; mic < samples.rows(); ++mic) {
      const auto& p = config.general.mics[mic].mu;  // the nearer to the source, the earlier it hears
      const double ahead = odas::dot({p[0], p[1], p[2]}, source) / 343.0;
      for (std::size_t i = 0; i < samples.cols(); ++i) {
        const double t = static_cast<double>(hop * samples.cols() + i) / pipeline.sample_rate();
        samples[mic][i] = static_cast<float>(sound(t + ahead));
      }
    }
    const odas::HopResult heard = pipeline.process_hop(samples);
    if (hop % 10 != 9) continue;
    const odas::Potential& strongest = heard.potentials.front();
    std::printf("hop %zu: azimuth %.0f, elevation %.0f degrees\n", hop + 1,
                static_cast<double>(odas::azimuth_deg(strongest.direction)),
                static_cast<double>(odas::elevation_deg(strongest.direction)));
  }
}
