// SPDX-License-Identifier: MIT
#include "odas/config/describe.hpp"

#include "support/config_faults.hpp"

namespace odas::describe_test {
namespace {

Pipeline::Plan some_plan() {
  Pipeline::Plan plan;
  plan.pairs = 6;
  plan.pairs_used = 5;
  plan.scans = {{2, 162, 71}, {4, 2562, 1241}};
  plan.lags = 49;
  plan.transform_ms = 8;
  plan.memory_bytes = 3U << 20U;
  return plan;
}

bool has(const std::string& text, std::string_view piece) { return text.find(piece) != std::string::npos; }

TEST(Describe, names_the_array_as_it_is_built) {
  const auto loaded = test::read_with("mapping: { map = (2, 1); };");
  const std::string text = describe_plan(loaded.config, some_plan());
  EXPECT_TRUE(has(text, "microphones     2, in a plane")) << text;
  EXPECT_TRUE(has(text, "aperture        100.0 mm; closest two 100.0 mm")) << text;
  EXPECT_TRUE(has(text, "ambiguous from 1715 Hz (widest)")) << text;  // 343 / (2 * 0.1)
  EXPECT_TRUE(has(text, "1          2   50.00    0.00    0.00")) << text;
  EXPECT_TRUE(has(text, "2          1  -50.00    0.00    0.00")) << text;
  EXPECT_TRUE(has(text, "5 of 6 hear a common direction")) << text;
}

TEST(Describe, says_where_microphones_and_filters_point) {
  const auto loaded = test::read_changed(
      "{ mu = (0.05, 0.0, 0.0); }", "{ mu = (0.05, 0.0, 0.01); direction = (0, 1, 0); angle = (80, 90); }");
  std::string text = describe_plan(loaded.config, some_plan());
  EXPECT_TRUE(has(text, "90, 0     80 to 90 deg")) << text;
  EXPECT_TRUE(has(text, "directions      full sphere")) << text;
  const auto filtered = test::read_changed(
      "general: {", "general: { spatialfilters = ( { direction = (0, 0, 1); angle = (80, 90); } );");
  text = describe_plan(filtered.config, some_plan());
  EXPECT_TRUE(has(text, "80 to 90 deg around (0, 0, 1)")) << text;
  Pipeline::Plan half = some_plan();
  half.half_sphere = true;
  EXPECT_TRUE(has(describe_plan(loaded.config, half), "half sphere, for the array is flat"));
}

TEST(Describe, gives_the_step_of_each_grid) {
  const std::string text = describe_plan(test::read_with("").config, some_plan());
  EXPECT_TRUE(has(text, "2             162           71  16.0 deg")) << text;
  EXPECT_TRUE(has(text, "4            2562         1241   4.0 deg")) << text;
}

TEST(Describe, says_what_rates_and_sizes_mean) {
  const std::string text =
      describe_plan(test::read_changed("fS = 16000;", "fS = 48000;").config, some_plan());
  EXPECT_TRUE(has(text, "48000 Hz, 16 bit, 2 channels, blocks of 2.7 ms")) << text;
  EXPECT_TRUE(has(text, "16000 Hz, resampled")) << text;
  EXPECT_TRUE(has(text, "128 samples, 8.0 ms")) << text;
  EXPECT_TRUE(has(text, "256 samples, 16.0 ms, bins of 62.5 Hz")) << text;
  EXPECT_TRUE(has(text, "memory          3.0 MiB")) << text;
}

TEST(Describe, adds_up_the_delay_of_the_chain) {
  std::string text = describe_plan(test::read_with("").config, some_plan());
  EXPECT_TRUE(has(text, "8.0 ms to the tracks, 16.0 ms to the separated voices")) << text;
  EXPECT_TRUE(has(text, "8.0 ms until a block is full, 8.0 ms in the transforms\n")) << text;
  // Blocks that are no multiple of the hop wait for both: 100 samples are 6.25 ms.
  text = describe_plan(test::read_changed("fS = 16000;", "fS = 16000; hopSize = 100;").config, some_plan());
  EXPECT_TRUE(has(text, "14.2 ms to the tracks, 22.2 ms")) << text;
  // An output block of 512 samples waits for four hops.
  text = describe_plan(test::read_with("sss: { separated: { hopSize = 512; }; };").config, some_plan());
  EXPECT_TRUE(has(text, "40.0 ms to the separated voices")) << text;
}

TEST(Describe, counts_what_the_resamplers_look_ahead) {
  const std::string text =
      describe_plan(test::read_changed("fS = 16000;", "fS = 48000; hopSize = 384;").config, some_plan());
  EXPECT_TRUE(has(text, " ms resampling, ")) << text;
  EXPECT_FALSE(has(text, "8.0 ms to the tracks")) << text;
  EXPECT_TRUE(has(describe_plan(test::read_with("sss: { separated: { fS = 44100; }; };").config, some_plan()),
                  " ms resampling the output"))
      << text;
}

TEST(Describe, says_what_is_computed_and_where_it_goes) {
  const auto loaded = test::read_with(R"(
sst: { tracked: { format = "json"; interface: { type = "socket"; ip = "127.0.0.1"; port = 9000; }; };
       target = ( { tag = "fan"; x = 0.0; y = 1.0; z = 0.0; } ); };
sss: { separated: { interface: { type = "file"; path = "voices.wav"; }; }; };)");
  const std::string text = describe_plan(loaded.config, some_plan());
  EXPECT_TRUE(has(text, "source          none: give a recording")) << text;
  EXPECT_TRUE(has(text, "tracks          socket 127.0.0.1:9000, json")) << text;
  EXPECT_TRUE(has(text, "separated       file voices.wav, dds, 4 channels, 16000 Hz, 16 bit, WAV")) << text;
  EXPECT_TRUE(has(text, "postfiltered    nobody listens: not computed")) << text;
  EXPECT_TRUE(has(text, "target \"fan\" at 90, 0")) << text;
}

}  // namespace
}  // namespace odas::describe_test
