// SPDX-License-Identifier: MIT
#include "odas/separation/mask_filter.hpp"

#include <cmath>

#include "support/wave_field.hpp"
#include <gtest/gtest.h>

namespace odas::mask_filter_test {
namespace {

constexpr std::size_t kBins = 129;

/// Says that its first slot's talker is in the lower half of the bins.
class HalfMask final : public Beamformer {
 public:
  HalfMask() {
    for (std::size_t k = 0; k < kBins; ++k) mask_[k] = k < 64 ? 1.F : 0.F;
  }
  void separate(GridView<const cfloat>, std::span<const Track>, GridView<cfloat>) noexcept override {}
  [[nodiscard]] GridView<const cfloat> weights(std::size_t) const noexcept override { return {}; }
  [[nodiscard]] std::span<const float> mask(std::size_t) const noexcept override { return mask_; }
  void reset() noexcept override {}

 private:
  std::vector<float> mask_ = std::vector<float>(kBins);
};

TEST(MaskFilter, passes_what_is_the_talkers_and_holds_the_rest_at_the_floor) {
  MaskFilterConfig config;
  config.g_min = 0.1F;
  MaskFilter filter(config, test::ring(4), 1);
  const HalfMask beamformer;
  const std::vector<Track> tracks{test::track(1, {1, 0, 0})};
  Grid<cfloat> beams(1, kBins);
  beams.fill({1, 0});
  Grid<cfloat> filtered(1, kBins);
  for (int hop = 0; hop < 50; ++hop) filter.apply({}, {}, tracks, beamformer, beams, filtered);
  EXPECT_NEAR(std::abs(filtered[0][20]), 1, 1e-3);
  EXPECT_NEAR(std::abs(filtered[0][100]), 0.1, 1e-3);
}

}  // namespace
}  // namespace odas::mask_filter_test
