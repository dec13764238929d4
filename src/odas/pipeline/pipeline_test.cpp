// SPDX-License-Identifier: MIT
#include "odas/pipeline/pipeline.hpp"

#include <array>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <random>

#include "support/allocation_counter.hpp"
#include "support/plane_wave.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::pipeline_test {
namespace {

using test::angle_deg;

PipelineConfig tetrahedron_config() {
  PipelineConfig config;
  config.general = test::tetrahedron(0.12F);
  config.sss.mode_pf = "ss";
  return config;
}

/// White sound from one direction, hop by hop, as the microphones hear it: sinc-interpolated delays.
class FarSource {
 public:
  FarSource(const GeneralConfig& config, Vec3 u, std::size_t hops, float level = 0.1F, unsigned seed = 1)
      : FarSource(config, u,
                  white(hops * static_cast<std::size_t>(config.size.hop_size) + 200, level, seed)) {}
  /// Of the sound `dry`, 200 samples longer than what is heard.
  FarSource(const GeneralConfig& config, Vec3 u, const std::vector<float>& dry)
      : hop_(static_cast<std::size_t>(config.size.hop_size)), mics_(config.mics.size(), dry.size() - 200) {
    const float per_metre = static_cast<float>(config.samplerate.mu) / config.speedofsound.mu;
    for (std::size_t m = 0; m < mics_.rows(); ++m) {
      const auto& p = config.mics[m].mu;
      const double at = 100 + static_cast<double>(per_metre * dot({p[0], p[1], p[2]}, u));
      const std::size_t first = static_cast<std::size_t>(at) - 15;
      std::array<double, 32> taps{};
      for (std::size_t k = 0; k < taps.size(); ++k) {
        const double x = std::numbers::pi * (at - static_cast<double>(first + k));
        taps[k] = (std::abs(x) < 1e-9 ? 1 : std::sin(x) / x) * (0.5 + 0.5 * std::cos(x / 16));
      }
      for (std::size_t n = 0; n < mics_.cols(); ++n) {
        double sum = 0;
        for (std::size_t k = 0; k < taps.size(); ++k)
          sum += taps[k] * static_cast<double>(dry[n + first + k]);
        mics_[m][n] = static_cast<float>(sum);
      }
    }
  }
  [[nodiscard]] GridView<float> hop(std::size_t h) {
    return {mics_.data() + h * hop_, mics_.rows(), hop_, mics_.cols()};
  }
  [[nodiscard]] std::size_t hops() const { return mics_.cols() / hop_; }

 private:
  static std::vector<float> white(std::size_t size, float level, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<float> normal;
    std::vector<float> out(size);
    for (float& x : out) x = level * normal(random);
    return out;
  }

  std::size_t hop_;
  Grid<float> mics_;
};

float power(std::span<const float> x) {
  float sum = 0;
  for (const float v : x) sum += v * v;
  return sum / static_cast<float>(x.size());
}

TEST(Pipeline, Locates_follows_and_separates_a_source) {
  const PipelineConfig config = tetrahedron_config();
  Pipeline pipeline(config);
  const Vec3 u = direction_of(35, 20);
  FarSource source(config.general, u, 60);
  for (std::size_t h = 0; h < source.hops(); ++h) {
    const HopResult result = pipeline.process_hop(source.hop(h));
    EXPECT_EQ(result.time, h + 1);
    ASSERT_EQ(result.potentials.size(), 4U);
    ASSERT_EQ(result.tracks.size(), 4U);
    if (h < 20) continue;
    EXPECT_LT(angle_deg(result.potentials[0].direction, u), 6);
    ASSERT_NE(result.tracks[0].id, 0U) << "clean and loud, where ODAS's hypotheses underflow (B5)";
    EXPECT_LT(angle_deg(result.tracks[0].direction, u), 6);
    EXPECT_NEAR(power(result.separated[0]), 0.01F, 0.004F) << "unit gain towards the source";
    EXPECT_EQ(power(result.separated[1]), 0);
    if (result.time != 60) continue;
    EXPECT_EQ(result.reports[0].id, result.tracks[0].id) << "the report is about this voice";
    EXPECT_TRUE(std::isfinite(result.reports[0].white_noise_gain_db));
    EXPECT_EQ(result.reports[1].id, 0U);
  }
}

TEST(Pipeline, Computes_what_is_wanted_and_nothing_else) {
  PipelineConfig config = tetrahedron_config();
  config.wanted = {.potentials = true, .tracks = false, .separated = false, .postfiltered = false};
  Pipeline pipeline(config);
  FarSource source(config.general, direction_of(0, 0), 30);
  for (std::size_t h = 0; h < source.hops(); ++h) {
    const HopResult result = pipeline.process_hop(source.hop(h));
    EXPECT_EQ(result.potentials.size(), 4U);
    EXPECT_EQ(result.tracks[0].id, 0U) << "nobody wants tracks";
    EXPECT_TRUE(result.separated.empty());
    EXPECT_TRUE(result.postfiltered.empty());
  }
}

/// A voice of ten harmonics whose pitch swings, as that of a talker does.
std::vector<float> talker(std::size_t size) {
  std::vector<float> out(size);
  double phase = 0;
  for (std::size_t n = 0; n < size; ++n) {
    phase += 2 * M_PI * (140 + 30 * std::sin(2 * M_PI * 1.5 * static_cast<double>(n) / 16000)) / 16000;
    for (int h = 1; h <= 20; ++h) out[n] += static_cast<float>(0.03 * std::cos(h * phase + h * h));
  }
  return out;
}

TEST(Pipeline, Hands_out_microphones_and_power_map_where_they_are_asked_for) {
  PipelineConfig config = tetrahedron_config();
  FarSource source(config.general, direction_of(30, 10), 20);
  Pipeline without(config);
  EXPECT_TRUE(without.process_hop(source.hop(0)).mics.empty());
  EXPECT_TRUE(without.process_hop(source.hop(0)).power.empty());
  EXPECT_TRUE(without.power_grid().empty());

  config.wanted = {false, false, false, false, false, true, true};
  Pipeline with(config);
  HopResult heard;
  for (std::size_t h = 0; h < source.hops(); ++h) heard = with.process_hop(source.hop(h));
  EXPECT_EQ(heard.mics[2][17], source.hop(source.hops() - 1)[2][17]);
  ASSERT_EQ(heard.power.size(), with.power_grid().size());
  EXPECT_GT(*std::max_element(heard.power.begin(), heard.power.end()), 0.5F);
}

TEST(Pipeline, Writes_into_each_track_whether_it_speaks_where_somebody_asks) {
  PipelineConfig config = tetrahedron_config();
  config.wanted = {.potentials = false, .tracks = false, .separated = false, .postfiltered = false};
  config.wanted.categories = true;
  config.classify.voicing_min = 0.35F;
  for (const auto& [speaks, said] : {std::pair{true, Category::speech}, {false, Category::nonspeech}}) {
    Pipeline pipeline(config);
    FarSource noise(config.general, direction_of(35, 20), 150);
    const auto voice = talker(noise.hops() * pipeline.hop_size() + 200);
    FarSource source = speaks ? FarSource(config.general, direction_of(35, 20), voice) : noise;
    HopResult result;
    for (std::size_t h = 0; h < source.hops(); ++h) result = pipeline.process_hop(source.hop(h));
    ASSERT_NE(result.tracks[0].id, 0U);
    EXPECT_EQ(result.tracks[0].category, said);
    EXPECT_EQ(result.tracks[1].category, Category::undefined) << "empty";
  }
}

// The first syllable: without a look-back the voice begins with the track, some hops too late.
TEST(Pipeline, Gives_a_voice_from_before_its_track_was_found) {
  constexpr std::size_t kOnset = 100;  // hops of silence, then sound
  const auto onset_of_voice = [&](float lookback) {
    PipelineConfig config = tetrahedron_config();
    config.sss.lookback = lookback;
    Pipeline pipeline(config);
    FarSource source(config.general, direction_of(35, 20), 250);
    for (std::size_t h = 0; h < kOnset; ++h) {
      for (std::size_t m = 0; m < 4; ++m) std::fill(source.hop(h)[m].begin(), source.hop(h)[m].end(), 0.F);
    }
    for (std::size_t h = 0; h < source.hops(); ++h) {
      const HopResult result = pipeline.process_hop(source.hop(h));
      if (power(result.separated[0]) > 0.002F) return static_cast<double>(h - pipeline.lookback_hops());
    }
    return 1e9;
  };
  EXPECT_GE(onset_of_voice(0), kOnset + 5) << "N_prob hops go by";
  EXPECT_LE(onset_of_voice(300), kOnset + 1) << "that of the transforms";
}

TEST(Pipeline, Delays_the_voices_by_the_look_back_and_changes_nothing_else) {
  PipelineConfig config = tetrahedron_config();
  Pipeline prompt(config);
  config.sss.lookback = 80;
  Pipeline patient(config);
  EXPECT_EQ(patient.lookback_hops(), 10U);
  EXPECT_DOUBLE_EQ(patient.plan().lookback_ms, 80);
  FarSource source(config.general, direction_of(35, 20), 80);
  std::vector<std::vector<float>> voice;
  for (std::size_t h = 0; h < source.hops(); ++h) {
    const HopResult now = prompt.process_hop(source.hop(h));
    voice.emplace_back(now.separated[0].begin(), now.separated[0].end());
    const Track track = now.tracks[0];
    const HopResult later = patient.process_hop(source.hop(h));
    EXPECT_EQ(track.direction, later.tracks[0].direction);
    if (h < 40) continue;
    ASSERT_TRUE(std::equal(voice[h - 10].begin(), voice[h - 10].end(), later.separated[0].begin())) << h;
  }
}

struct Methods {
  const char *sep, *pf, *weighting;
  float lookback;
  int frame = 0;  // of separation
};
class PipelineMethods : public ::testing::TestWithParam<Methods> {
 protected:
  PipelineMethods() : config(tetrahedron_config()) {
    config.sss.mode_sep = GetParam().sep;
    config.sss.mode_pf = GetParam().pf;
    config.ssl.weighting = GetParam().weighting;
    config.wanted.categories = true;
    config.sss.lookback = GetParam().lookback;
    config.sss.frame_size = GetParam().frame;
  }
  PipelineConfig config;
};

TEST_P(PipelineMethods, Allocates_nothing_in_a_hop) {
  const auto counted = test::allocations();
  void* volatile probe = std::malloc(1);  // volatile, or the compiler sees that nobody needs it
  std::free(probe);
  if (test::allocations() == counted) GTEST_SKIP() << "this build brings its own malloc";
  Pipeline pipeline(config);
  FarSource source(config.general, direction_of(35, 20), 60);
  const auto before = test::allocations();
  for (std::size_t h = 0; h < source.hops(); ++h) pipeline.process_hop(source.hop(h));
  EXPECT_EQ(test::allocations(), before);
}

TEST_P(PipelineMethods, Gives_the_same_bits_again_after_reset_and_from_a_new_one) {
  Pipeline used(config);
  Pipeline fresh(config);
  FarSource other(config.general, direction_of(-80, 0), 40, 0.2F, 9);
  for (std::size_t h = 0; h < other.hops(); ++h) used.process_hop(other.hop(h));
  used.reset();
  FarSource source(config.general, direction_of(35, 20), 40);
  for (std::size_t h = 0; h < source.hops(); ++h) {
    const HopResult a = used.process_hop(source.hop(h));
    const HopResult b = fresh.process_hop(source.hop(h));
    ASSERT_EQ(a.time, b.time);
    for (std::size_t s = 0; s < a.tracks.size(); ++s) {
      ASSERT_EQ(a.tracks[s].id, b.tracks[s].id);
      ASSERT_EQ(a.tracks[s].direction, b.tracks[s].direction);
      ASSERT_TRUE(std::equal(a.separated[s].begin(), a.separated[s].end(), b.separated[s].begin()));
      ASSERT_TRUE(std::equal(a.postfiltered[s].begin(), a.postfiltered[s].end(), b.postfiltered[s].begin()));
    }
  }
}

TEST_P(PipelineMethods, Contains_samples_that_are_no_numbers) {
  Pipeline pipeline(config);
  FarSource source(config.general, direction_of(35, 20), 60);
  source.hop(30)[1][5] = std::numeric_limits<float>::quiet_NaN();
  source.hop(31)[0][0] = std::numeric_limits<float>::infinity();
  source.hop(32)[2][7] = 3e30F;
  for (std::size_t h = 0; h < source.hops(); ++h) {
    const HopResult result = pipeline.process_hop(source.hop(h));
    for (const Potential& p : result.potentials) ASSERT_TRUE(std::isfinite(p.energy));
    for (std::size_t s = 0; s < result.tracks.size(); ++s) {
      ASSERT_TRUE(std::isfinite(result.tracks[s].direction.x));
      for (const float x : result.separated[s]) ASSERT_TRUE(std::isfinite(x));
      for (const float x : result.postfiltered[s]) ASSERT_TRUE(std::isfinite(x));
    }
    const bool stands_out = config.ssl.weighting == "none";  // a steady source is noise to the weights
    if (h > 20 && stands_out) { ASSERT_NE(result.tracks[0].id, 0U); }
  }
  EXPECT_EQ(pipeline.non_finite_samples(), 3U);
}

INSTANTIATE_TEST_SUITE_P(All, PipelineMethods,
                         ::testing::Values(Methods{"dds", "ss", "none", 0}, Methods{"dds", "ms", "snr", 40},
                                           Methods{"dgss", "ms", "none", 40},
                                           Methods{"dmvdr", "mask", "none", 40, 512},
                                           Methods{"dgss", "ms", "none", 0, 384}),
                         [](const auto& methods) {
                           return std::string(methods.param.sep) + "_" + methods.param.pf + "_" +
                                  methods.param.weighting + "_" + std::to_string(methods.param.frame);
                         });

TEST(Pipeline, Delays_the_voices_by_the_frame_of_separation_and_finds_the_same_tracks) {
  const PipelineConfig plain = tetrahedron_config();
  PipelineConfig config = plain;
  config.sss.frame_size = 512;
  Pipeline pipeline(config);
  Pipeline before(plain);
  EXPECT_DOUBLE_EQ(pipeline.plan().transform_ms, 24);
  EXPECT_DOUBLE_EQ(before.plan().transform_ms, 8);
  FarSource source(config.general, direction_of(35, 20), 60);
  for (std::size_t h = 0; h < source.hops(); ++h) {
    const HopResult a = pipeline.process_hop(source.hop(h));
    const HopResult b = before.process_hop(source.hop(h));
    ASSERT_EQ(a.tracks[0].id, b.tracks[0].id);
    ASSERT_EQ(a.tracks[0].direction, b.tracks[0].direction);
  }
}

TEST(Pipeline, Works_at_other_sizes) {
  for (const auto& [hop, frame] :
       {std::pair{64, 256}, std::pair{100, 300}, std::pair{256, 512}, std::pair{128, 255}}) {
    PipelineConfig config = tetrahedron_config();
    config.general.size = {hop, frame};
    Pipeline pipeline(config);
    const Vec3 u = direction_of(-110, -15);
    FarSource source(config.general, u, 60);
    HopResult result;
    for (std::size_t h = 0; h < source.hops(); ++h) result = pipeline.process_hop(source.hop(h));
    ASSERT_NE(result.tracks[0].id, 0U) << hop << "/" << frame;
    EXPECT_LT(angle_deg(result.tracks[0].direction, u), 6);
  }
}

TEST(Pipeline, Has_as_many_channels_as_tracks_whatever_their_number) {
  for (const auto& [sep, tracks] : {std::pair{"dds", 1}, {"dds", 20}, {"dgss", 1}, {"dgss", 20}}) {
    PipelineConfig config = tetrahedron_config();
    config.sst.n_tracks = tracks;
    config.sss.mode_sep = sep;
    config.sss.mode_pf = "ms";
    config.wanted.categories = true;
    Pipeline pipeline(config);
    EXPECT_EQ(pipeline.slots(), static_cast<std::size_t>(tracks));
    FarSource source(config.general, direction_of(35, 20), 40);
    HopResult result;
    for (std::size_t h = 0; h < source.hops(); ++h) result = pipeline.process_hop(source.hop(h));
    EXPECT_EQ(result.tracks.size(), static_cast<std::size_t>(tracks));
    EXPECT_EQ(result.separated.rows(), static_cast<std::size_t>(tracks));
    EXPECT_EQ(result.postfiltered.rows(), static_cast<std::size_t>(tracks));
    EXPECT_NE(result.tracks[0].id, 0U);
    EXPECT_GT(power(result.separated[0]), 0.001F) << sep;
  }
}

// ODAS fault B7: a target that no microphone hears ended the program.
TEST(Pipeline, Gives_silence_for_a_target_that_no_microphone_hears) {
  PipelineConfig config = tetrahedron_config();
  for (MicConfig& mic : config.general.mics) mic.angle = {80, 90};
  config.sst.add = "static";
  config.sst.target = {{"below", 0, 0, -1}};
  Pipeline pipeline(config);
  FarSource source(config.general, direction_of(0, 40), 20);
  for (std::size_t h = 0; h < source.hops(); ++h) {
    const HopResult result = pipeline.process_hop(source.hop(h));
    EXPECT_EQ(result.tracks[0].tag.view(), "below");
    EXPECT_EQ(power(result.separated[0]), 0);
  }
}

TEST(Pipeline, Follows_the_targets_that_it_is_given_between_hops) {
  PipelineConfig config = tetrahedron_config();
  config.sst.add = "static";
  Pipeline pipeline(config);
  FarSource source(config.general, direction_of(30, 40), 30);
  EXPECT_EQ(pipeline.process_hop(source.hop(0)).tracks[0].id, 0U);
  std::vector<Target> targets{{"here", direction_of(30, 40)}};
  for (int i = 0; i < 4; ++i) targets.push_back({std::string_view(std::to_string(i)), {0, 0, -1}});
  pipeline.set_targets(targets);
  for (std::size_t h = 1; h < 29; ++h) pipeline.process_hop(source.hop(h));
  const HopResult result = pipeline.process_hop(source.hop(29));
  EXPECT_EQ(result.tracks[0].tag.view(), "here");
  EXPECT_GT(result.tracks[0].activity, 0.9F);
  EXPECT_GT(power(result.separated[0]), 0);
  EXPECT_EQ(pipeline.unfollowed_targets(), 1U) << "five for four slots";
  pipeline.reset();
  EXPECT_EQ(pipeline.process_hop(source.hop(0)).tracks[0].id, 0U);
  EXPECT_EQ(pipeline.unfollowed_targets(), 0U);
}

TEST(Pipeline, Hears_nobody_where_it_is_muted) {
  Pipeline pipeline(tetrahedron_config());
  FarSource source(tetrahedron_config().general, direction_of(30, 40), 80);
  for (std::size_t h = 0; h < 40; ++h) pipeline.process_hop(source.hop(h));
  ASSERT_NE(pipeline.process_hop(source.hop(40)).tracks[0].id, 0U);
  pipeline.set_muted(std::vector<Target>{{"fan", direction_of(35, 38)}});
  for (std::size_t h = 41; h < source.hops(); ++h) {
    const HopResult result = pipeline.process_hop(source.hop(h));
    EXPECT_EQ(result.potentials[0].energy, 0);
    for (const Track& track : result.tracks) EXPECT_EQ(track.id, 0U);
  }
}

TEST(Pipeline, Takes_the_place_of_another_without_a_break_in_time_sound_or_tracks) {
  PipelineConfig config = tetrahedron_config();
  FarSource source(config.general, direction_of(30, 40), 80);
  Pipeline undisturbed(config), running(config);
  for (std::size_t h = 0; h < 80; ++h) {
    if (h == 50) {
      Pipeline next(config);
      ASSERT_TRUE(next.can_continue(running));
      next.continue_from(running);
      running = std::move(next);
    }
    const HopResult expected = undisturbed.process_hop(source.hop(h));
    const HopResult result = running.process_hop(source.hop(h));
    EXPECT_EQ(result.time, expected.time);
    ASSERT_EQ(result.tracks[0].id, expected.tracks[0].id);
    if (expected.tracks[0].id == 0) continue;
    EXPECT_LT(angle_deg(result.tracks[0].direction, expected.tracks[0].direction), 3);
    for (std::size_t n = 0; n < result.separated.cols(); ++n) {
      EXPECT_NEAR(result.separated[0][n], expected.separated[0][n], 0.02F);
    }
  }
}

TEST(Pipeline, Cannot_take_the_place_of_one_of_another_shape) {
  const PipelineConfig config = tetrahedron_config();
  const Pipeline running(config);
  PipelineConfig other = config;
  other.sst.n_tracks = 7;
  EXPECT_FALSE(Pipeline(other).can_continue(running));
  other = config;
  other.ssl.n_pots = 2;
  EXPECT_FALSE(Pipeline(other).can_continue(running));
  other = config;
  other.sst.theta_new = 0.5F;
  EXPECT_TRUE(Pipeline(other).can_continue(running));
}

TEST(Pipeline, Says_its_plan) {
  PipelineConfig config;
  config.general = test::ring(8, 0.1F);
  config.general.spatialfilters.reset();
  const Pipeline::Plan plan = Pipeline(config).plan();
  EXPECT_EQ(plan.pairs, 28U);
  EXPECT_EQ(plan.pairs_used, 28U);
  ASSERT_EQ(plan.scans.size(), 2U);
  EXPECT_EQ(plan.scans[1].points, 2562U);
  EXPECT_TRUE(plan.half_sphere);
  EXPECT_DOUBLE_EQ(plan.transform_ms, 8);
  EXPECT_GT(plan.memory_bytes, 100000U);
}

TEST(Pipeline, Refuses_methods_that_it_does_not_know) {
  PipelineConfig config = tetrahedron_config();
  config.sss.mode_sep = "magic";
  EXPECT_THROW(Pipeline{config}, ConfigError);
  config = tetrahedron_config();
  config.ssl.mode = "music";
  EXPECT_THROW(Pipeline{config}, ConfigError);
}

}  // namespace
}  // namespace odas::pipeline_test
