// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "odas/array/types.hpp"
#include "odas/dsp/noise_dictionary.hpp"
#include "odas/dsp/noise_model.hpp"

namespace odas {

/// Makes a dictionary of what a machine sounds like while nobody speaks.
///
/// Method: covariances over segments of a quarter of a second, R_s; the entries are centroids: a segment
///   belongs to the entry under which it is likeliest (NoiseModel), an entry is the mean of its segments,
///   each bin of each segment counting alike; a new entry starts from the segment that is least likely, and
///   stays if all become likelier by kWorth.
/// Source: Lagace, Ferland and Grondin, "Ego-noise reduction of a mobile robot using noise spatial covariance
///   matrix learning and minimum variance distortionless response", 2023: a dictionary of covariances,
///   learned once. Departs: segments are grouped by likelihood and not kept one by one, so that it stays
///   small.
/// Shapes: spectra [mic][bin] of each hop.
/// Cost: 512 segments and 512 hops are kept at most; longer recordings have longer segments.
/// Errors: a hop that is not finite, or silent, is passed over.
/// Fails: with speech in the recording, which becomes noise: see `uneven`.
class NoiseLearner {
 public:
  NoiseLearner(int sample_rate, std::size_t hop_size, std::size_t frame_size, std::vector<Vec3> mics);

  void hear(GridView<const cfloat> spectra);

  [[nodiscard]] double seconds() const noexcept;  // heard so far
  /// The seconds, from 0, whose level goes up and down by more than machines do: 2.5 dB (standard deviation).
  [[nodiscard]] const std::vector<std::size_t>& uneven() const noexcept { return uneven_; }

  /// `most`: entries, 1 to NoiseDictionary::kMostEntries. Empty where next to nothing was heard.
  [[nodiscard]] NoiseDictionary learn(std::size_t most) const;

 private:
  using Scm = std::vector<cfloat>;  // [bin][mic][mic]
  struct Segment {
    Scm scm;
    std::size_t hops = 0;
  };

  void keep(GridView<const cfloat> spectra);
  void watch_level(GridView<const cfloat> spectra);
  [[nodiscard]] Scm mean_of(const std::vector<std::size_t>& owner, std::size_t entry) const;
  double assign(const std::vector<NoiseModel>& models, std::vector<std::size_t>& owner) const;
  [[nodiscard]] std::size_t least_likely(const std::vector<NoiseModel>& models) const;
  void describe_hops(NoiseDictionary& dictionary) const;

  int sample_rate_;
  std::size_t hop_size_, frame_size_;
  std::vector<Vec3> mics_;
  BinRange bins_;
  std::size_t segment_hops_, hops_a_second_;
  std::vector<Segment> segments_;
  std::vector<Grid<cfloat>> kept_;  // some of the hops
  std::size_t keep_every_ = 1;
  std::size_t hops_ = 0;
  std::vector<double> levels_;  // dB, of the hops of this second
  std::vector<std::size_t> uneven_;
};

}  // namespace odas
