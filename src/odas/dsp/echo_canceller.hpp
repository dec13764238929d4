// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "odas/array/types.hpp"
#include "odas/dsp/real_fft.hpp"

namespace odas {

/// Takes out of the microphones what the machine itself plays, knowing what it plays.
///
/// Method: a Kalman filter over the echo path, in the frequency domain and in partitions of one hop, bin by
/// bin (overlap-save, N = 2 hops). With X_b the reference b hops ago, for each microphone:
///   e = y - last half of IFFT(sum_b X_b W_b),  E = FFT(0, e),
///   D = c sum_b |X_b|^2 P_b + Psi,  W_b <- W_b + (P_b / D) conj(X_b) E,
///   P_b <- A^2 (1 - 1/2 P_b |X_b|^2 / D) P_b + (1 - A^2) mean_m |W_b|^2,
///   and each hop some partitions are cut back to the hop of taps that they stand for.
/// Double talk: Psi is the power of what the microphones hear beside the echo, followed from the error within
/// tens of milliseconds: where somebody else speaks D grows and the filter holds still, bin by bin, with no
/// switch. What of the error goes with the estimated echo, sum E conj(Y), is no talk but a path that has
/// changed: it is left out of Psi, so that the filter follows.
/// Harm: where the microphones become louder for a tenth of a second, all is learned anew.
/// Symbols: y, e: a hop before and after; W_b, P_b: filter and its variance; A: how fast a path drifts.
/// Source: Kuech, Mabande and Enzner, "State-space architecture of the partitioned-block-based acoustic echo
///   controller", ICASSP 2014. Departs: P and Psi are common to all microphones (means over them), which
///   costs less and trembles less; the coherent part of the error does not count as near-end; c is 1.3, not
///   1/2, for the partitions are not all cut back in each hop.
/// Shapes: references [reference][hop], microphones [mic][hop], full scale 1, in place.
/// Cost per hop: (2 mics + 3) transforms of 2 hops, 16 flops per mic, partition and bin, 12 per partition and
///   bin; partitions = references * length / hop.
/// Delay: none.
/// Errors: a reference sample that is not finite counts as silence; a microphone's hop that is not finite
///   goes through as it is, and teaches nothing. A reference under -84 dB of full scale is silence, and while
///   it has been silent for the filter's length nothing is touched, bit by bit.
/// Fails: an echo longer than the filter, or from another clock than the microphones'; distortion of the
///   loudspeaker stays. References that are the same signal share one path at will, which does no harm.
class EchoCanceller {
 public:
  /// `length`: samples of the echo's path, the delay of the playing included; at least 1.
  EchoCanceller(std::size_t mics, std::size_t references, std::size_t hop_size, std::size_t length,
                int sample_rate);

  void cancel(GridView<const float> references, GridView<float> mics) noexcept;

  /// The state after construction, exactly.
  void reset() noexcept;

  /// By how much the microphones became quieter over the last seconds in which the machine was heard, dB;
  /// what others say at the same time lowers it (ERLE). 0 before.
  [[nodiscard]] double return_loss_db() const noexcept;

 private:
  [[nodiscard]] bool listen(GridView<const float> references) noexcept;
  void predict() noexcept;
  void subtract(std::span<float> mic, std::size_t m) noexcept;
  void fade() noexcept;
  [[nodiscard]] bool does_harm() const noexcept;
  void judge() noexcept;
  void learn() noexcept;
  void forget() noexcept;
  void constrain(std::size_t partition) noexcept;
  [[nodiscard]] std::span<const cfloat> reference(std::size_t partition) const noexcept;

  std::size_t hop_size_, references_, blocks_;  // partitions of one reference
  float drift_;                                 // A^2
  float near_memory_;                           // of a hop
  double loss_memory_, harm_memory_;
  RealFft fft_;

  Grid<float> frames_;      // [reference][2 hops]
  Grid<cfloat> spectra_;    // [reference * blocks + ring][bin]: X
  std::size_t head_ = 0;    // the newest of the ring
  std::size_t silent_for_;  // hops
  std::size_t constrained_ = 0;

  std::vector<Grid<cfloat>> filters_;                   // [mic][partition][bin]: W
  Grid<float> variance_;                                // [partition][bin]: P
  Grid<float> path_power_;                              // [partition][bin]: mean over mics of |W|^2
  Grid<cfloat> echoes_, errors_;                        // [mic][bin]: of this hop
  std::vector<float> gain_, spread_;                    // [bin]: 1 / D, c sum |X|^2 P
  std::vector<float> error_power_, echo_power_, near_;  // [bin], smoothed; Psi
  std::vector<cfloat> cross_, sum_;                     // [bin]: sum E conj(Y), smoothed; scratch
  std::vector<std::uint8_t> usable_;                    // [mic]: its hop is finite
  std::vector<float> error_;                            // e
  // Power of the microphones before and after, and of e, smoothed.
  double heard_ = 0, left_ = 0, heard_of_late_ = 0, error_of_late_ = 0;
};

}  // namespace odas
