// SPDX-License-Identifier: MIT
// The files in configs/: each loads without a doubt, and describes an array that can be.
#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>

#include "support/config_faults.hpp"
#include "support/scratch.hpp"

#include "odas/array/geometry.hpp"

namespace odas::array_files_test {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(ODAS_SOURCE_DIR) / "configs";

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const auto& entry : fs::directory_iterator(kFolder)) {
    if (entry.path().extension() == ".cfg") all.push_back(entry.path().stem().string());
  }
  std::sort(all.begin(), all.end());
  return all;
}

class ArrayFile : public ::testing::TestWithParam<std::string> {
 protected:
  LoadedConfiguration loaded_ = read_configuration(kFolder / (GetParam() + ".cfg"));
  const PipelineConfig& pipeline_ = loaded_.config.pipeline;
  const std::vector<MicConfig>& mics_ = pipeline_.general.mics;
};

INSTANTIATE_TEST_SUITE_P(configs, ArrayFile, ::testing::ValuesIn(names()),
                         [](const auto& name) { return name.param; });

TEST_P(ArrayFile, loads_without_a_warning) { EXPECT_TRUE(test::clean(loaded_)); }

TEST_P(ArrayFile, takes_what_all_arrays_have_in_common) {
  EXPECT_EQ(pipeline_.ssl.mode, "srp_clean");
  EXPECT_EQ(pipeline_.sss.lookback, 300);
  EXPECT_FLOAT_EQ(pipeline_.classify.voicing_min, 0.35F);
  EXPECT_FLOAT_EQ(pipeline_.sst.active.at(0).mu, 0.16F);
  EXPECT_FLOAT_EQ(pipeline_.sst.inactive.at(0).mu, 0.06F);
}

TEST_P(ArrayFile, has_microphones_at_distances_that_boards_and_robots_have) {
  for (const auto& [i, j] : all_pairs(mics_.size())) {
    const float distance = norm(position(mics_[i]) - position(mics_[j]));
    EXPECT_GT(distance, 0.015F) << i + 1 << " " << j + 1;
    EXPECT_LT(distance, 0.45F) << i + 1 << " " << j + 1;
  }
}

TEST_P(ArrayFile, has_a_channel_for_each_microphone_and_none_twice) {
  const std::vector<int>& map = loaded_.config.mapping.map;
  const std::set<int> different(map.begin(), map.end());
  EXPECT_EQ(different.size(), map.size());
  if (!map.empty()) return;
  EXPECT_EQ(static_cast<std::size_t>(loaded_.config.raw.n_channels), mics_.size());
}

TEST_P(ArrayFile, says_where_azimuth_0_is_and_where_its_numbers_come_from) {
  const std::string text = test::content(kFolder / (GetParam() + ".cfg"));
  EXPECT_NE(text.find("\n# Azimuth 0 "), std::string::npos);
  if (GetParam() == "sample") return;  // an array that was never built
  EXPECT_TRUE(text.find("ODAS's ") != text.npos || text.find("Positions") != text.npos) << text;
}

/// What a ruler says: the microphones, the largest distance, and whether they are in one plane.
struct Measure {
  std::size_t mics;
  float aperture;  // m
  bool flat = true;
};

TEST_P(ArrayFile, is_as_large_as_the_array_that_it_describes) {
  static const std::map<std::string, Measure> measures{{"azimut3_closed_16", {16, 0.3233F, false}},
                                                       {"azimut3_open_16", {16, 0.250F}},
                                                       {"azure_kinect", {7, 0.080F}},
                                                       {"beam_8soundsusb", {8, 0.1754F}},
                                                       {"matrix_creator", {8, 0.105F}},
                                                       {"matrix_voice", {8, 0.0747F}},
                                                       {"minidsp_uma16", {16, 0.1782F}},
                                                       {"minidsp_uma8", {7, 0.086F}},
                                                       {"pepper", {4, 0.0899F}},
                                                       {"ps3_eye", {4, 0.060F}},
                                                       {"respeaker_4_mic_hat", {4, 0.0813F}},
                                                       {"respeaker_6_mic", {6, 0.0926F}},
                                                       {"respeaker_core_v2", {6, 0.0926F}},
                                                       {"respeaker_usb_4_mic", {4, 0.064F}},
                                                       {"sample", {4, 0.064F}},
                                                       {"securbot_pioneer", {16, 0.3951F, false}},
                                                       {"securbot_turtlebot", {16, 0.3246F, false}},
                                                       {"t_top", {16, 0.2703F, false}},
                                                       {"xmos_xcore_7_mic", {7, 0.086F}}};
  const auto measure = measures.find(GetParam());
  ASSERT_NE(measure, measures.end()) << "a new file wants its measure here";
  EXPECT_EQ(mics_.size(), measure->second.mics);
  EXPECT_NEAR(aperture(mics_), measure->second.aperture, 2e-4F);
  EXPECT_EQ(flat_array_side(mics_).has_value(), measure->second.flat);
}

TEST_P(ArrayFile, lets_flat_arrays_find_their_half_sphere) {
  if (GetParam() == "ps3_eye") return;  // a line: its band is given
  EXPECT_NE(flat_array_side(mics_).has_value(),
            pipeline_.general.spatialfilters.has_value() || GetParam() == "azimut3_closed_16");
}

TEST_P(ArrayFile, points_the_microphones_of_a_body_out_of_it) {
  if (mics_.front().angle[0] >= 180) return;
  Vec3 middle{};
  for (const MicConfig& mic : mics_) middle = middle + (1 / static_cast<float>(mics_.size())) * position(mic);
  for (const MicConfig& mic : mics_) {
    const Vec3 out{mic.direction[0], mic.direction[1], mic.direction[2]};
    EXPECT_GT(dot(position(mic) - middle, out), 0.1F) << "on the side that it looks out of";
  }
}

}  // namespace
}  // namespace odas::array_files_test
