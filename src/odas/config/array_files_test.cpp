// SPDX-License-Identifier: MIT
// The files in configs/: each loads without a doubt.
#include <filesystem>

#include "support/config_faults.hpp"

#include "odas/array/geometry.hpp"

namespace odas {
namespace {

namespace fs = std::filesystem;

LoadedConfiguration array_file(const std::string& name) {
  return read_configuration(fs::path(ODAS_SOURCE_DIR) / "configs" / name);
}

TEST(ArrayFiles, all_load_without_a_warning) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(ODAS_SOURCE_DIR) / "configs")) {
    EXPECT_TRUE(test::clean(read_configuration(entry.path()))) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 5U);
}

TEST(ArrayFiles, all_weight_the_bins_and_let_the_half_sphere_find_itself) {
  for (const auto& entry : fs::directory_iterator(fs::path(ODAS_SOURCE_DIR) / "configs")) {
    const PipelineConfig pipeline = read_configuration(entry.path()).config.pipeline;
    EXPECT_EQ(pipeline.ssl.weighting, "snr") << entry.path();
    EXPECT_FALSE(pipeline.general.spatialfilters.has_value()) << entry.path();
  }
}

TEST(ArrayFiles, describe_the_arrays_as_they_are_measured) {
  struct Measure {
    const char* file;
    std::size_t mics;
    float aperture;  // m
  };
  for (const Measure& array :
       {Measure{"respeaker_usb_4_mic.cfg", 4, 0.064F}, Measure{"sample.cfg", 4, 0.064F},
        Measure{"respeaker_4_mic_hat.cfg", 4, 0.0575F * std::sqrt(2.0F)},
        Measure{"minidsp_uma8.cfg", 7, 0.086F}}) {
    const auto loaded = array_file(array.file);
    const auto& mics = loaded.config.pipeline.general.mics;
    EXPECT_EQ(mics.size(), array.mics) << array.file;
    EXPECT_NEAR(aperture(mics), array.aperture, 1e-4F) << array.file;
    EXPECT_TRUE(flat_array_side(mics).has_value()) << array.file;
  }
}

TEST(ArrayFiles, point_the_microphones_of_the_closed_array_out_of_its_sides) {
  const auto loaded = array_file("azimut3_closed_16.cfg");
  const auto& mics = loaded.config.pipeline.general.mics;
  ASSERT_EQ(mics.size(), 16U);
  EXPECT_FALSE(flat_array_side(mics).has_value());
  for (const MicConfig& mic : mics) {
    const Vec3 out{mic.direction[0], mic.direction[1], mic.direction[2]};
    EXPECT_FLOAT_EQ(dot(position(mic), out), 0.125F) << "on the side that it looks out of";
  }
}

}  // namespace
}  // namespace odas
