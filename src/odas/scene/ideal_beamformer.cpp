// SPDX-License-Identifier: MIT
#include "odas/scene/ideal_beamformer.hpp"

#include <algorithm>

#include "odas/base/contract.hpp"
#include "odas/dsp/cholesky.hpp"
#include "odas/dsp/stft.hpp"
#include "odas/scene/projection.hpp"

namespace odas {
namespace {

constexpr std::size_t kFrame = 512, kHop = 128, kBins = kFrame / 2 + 1;
constexpr std::size_t kBlockHops = 31;  // a quarter of a second at 16 kHz
constexpr std::size_t kAround = 4;      // blocks before and after
constexpr float kLoading = 1e-4F;       // of the mean power: recordings are not free of noise

/// [bin][mic x mic], lower triangles.
using Covariances = std::vector<std::vector<cfloat>>;

/// What both the talker and all else are in each block of hops.
struct Block {
  Covariances talker = Covariances(kBins), rest = Covariances(kBins);
};

void add_frame(GridView<const cfloat> x, Covariances& covariances) {
  const std::size_t mics = x.rows();
  for (std::size_t k = 0; k < kBins; ++k) {
    covariances[k].resize(mics * mics);
    for (std::size_t i = 0; i < mics; ++i) {
      for (std::size_t j = 0; j <= i; ++j) covariances[k][i * mics + j] += x[i][k] * std::conj(x[j][k]);
    }
  }
}

/// Hop by hop, silence behind the end.
class Frames {
 public:
  explicit Frames(GridView<const float> sound)
      : sound_(sound),
        stft_(sound.rows(), kHop, kFrame),
        in_(sound.rows(), kHop),
        out_(sound.rows(), kBins) {}

  GridView<const cfloat> next() {
    for (std::size_t m = 0; m < sound_.rows(); ++m) {
      for (std::size_t n = 0; n < kHop; ++n) in_[m][n] = at_ + n < sound_.cols() ? sound_[m][at_ + n] : 0;
    }
    at_ += kHop;
    stft_.analyse(in_, out_);
    return out_;
  }

 private:
  GridView<const float> sound_;
  Stft stft_;
  Grid<float> in_;
  Grid<cfloat> out_;
  std::size_t at_ = 0;
};

std::vector<Block> blocks_of(GridView<const float> mics, GridView<const float> image, std::size_t hops) {
  std::vector<Block> blocks((hops + kBlockHops - 1) / kBlockHops);
  Frames all(mics), talker(image);
  Grid<cfloat> rest(mics.rows(), kBins);
  for (std::size_t h = 0; h < hops; ++h) {
    Block& block = blocks[h / kBlockHops];
    const auto x = all.next(), s = talker.next();
    for (std::size_t m = 0; m < mics.rows(); ++m) {
      for (std::size_t k = 0; k < kBins; ++k) rest[m][k] = x[m][k] - s[m][k];
    }
    add_frame(s, block.talker);
    add_frame(rest, block.rest);
  }
  return blocks;
}

std::vector<cfloat> sum_around(std::span<const Block> blocks, std::size_t b, std::size_t bin,
                               Covariances Block::*which) {
  std::vector<cfloat> sum = (blocks[b].*which)[bin];
  const std::size_t first = b - std::min(b, kAround), last = std::min(blocks.size() - 1, b + kAround);
  for (std::size_t i = first; i <= last; ++i) {
    if (i == b) continue;
    for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += (blocks[i].*which)[bin][n];
  }
  return sum;
}

/// w^H, by Souden's formula.
std::vector<cfloat> weights_of(std::vector<cfloat> talker, std::vector<cfloat> rest, std::size_t mics) {
  float power = 0, all = 0;
  for (std::size_t m = 0; m < mics; ++m) {
    power += rest[m * mics + m].real();
    all += talker[m * mics + m].real();
  }
  const float loading = kLoading * (power + kLoading * all) / static_cast<float>(mics) + 1e-20F;
  for (std::size_t m = 0; m < mics; ++m) rest[m * mics + m] += loading;
  cholesky(rest, mics, loading);
  std::vector<cfloat> weights(mics), column(mics);
  cfloat trace = 0;
  for (std::size_t j = 0; j < mics; ++j) {
    for (std::size_t i = 0; i < mics; ++i) {
      column[i] = i >= j ? talker[i * mics + j] : std::conj(talker[j * mics + i]);
    }
    whiten(rest, column);
    for (std::size_t i = mics; i-- > 0;) {  // L^H backward
      for (std::size_t n = i + 1; n < mics; ++n) column[i] -= std::conj(rest[n * mics + i]) * column[n];
      column[i] /= rest[i * mics + i].real();
    }
    trace += column[j];
    if (j == 0) weights = column;
  }
  for (cfloat& w : weights) w = std::conj(w) / std::max(trace.real(), 1e-12F);
  return weights;
}

}  // namespace

std::vector<float> ideal_beamformer_voice(GridView<const float> mics, GridView<const float> image) {
  ODAS_EXPECT(mics.rows() == image.rows() && mics.cols() == image.cols());
  constexpr std::size_t kDelay = kFrame - kHop;
  const std::size_t hops = (mics.cols() + kDelay + kHop - 1) / kHop;
  const std::vector<Block> blocks = blocks_of(mics, image, hops);
  std::vector<std::vector<cfloat>> weights(kBins);
  Frames frames(mics);
  Istft back(1, kHop, kFrame);
  Grid<cfloat> beam(1, kBins);
  Grid<float> out(1, kHop);
  std::vector<float> voice;
  voice.reserve(hops * kHop);
  for (std::size_t h = 0; h < hops; ++h) {
    const auto x = frames.next();
    for (std::size_t k = 0; k < kBins; ++k) {
      if (h % kBlockHops == 0) {
        const std::size_t b = h / kBlockHops;
        weights[k] = weights_of(sum_around(blocks, b, k, &Block::talker),
                                sum_around(blocks, b, k, &Block::rest), mics.rows());
      }
      beam[0][k] = 0;
      for (std::size_t m = 0; m < mics.rows(); ++m) beam[0][k] += weights[k][m] * x[m][k];
    }
    back.synthesise(beam, out);
    voice.insert(voice.end(), out[0].begin(), out[0].end());
  }
  return {voice.begin() + kDelay, voice.begin() + kDelay + static_cast<std::ptrdiff_t>(mics.cols())};
}

std::optional<double> ideal_beamformer_sdr_db(GridView<const float> mics,
                                              std::span<const Grid<float>> images) {
  if (images.empty()) return std::nullopt;
  double sum = 0;
  for (const Grid<float>& image : images) sum += sdr_db(ideal_beamformer_voice(mics, image), image[0]);
  return sum / static_cast<double>(images.size());
}

}  // namespace odas
