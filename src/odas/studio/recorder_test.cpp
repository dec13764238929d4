// SPDX-License-Identifier: MIT
#include "odas/studio/recorder.hpp"

#include <cstring>

#include "support/hop_maker.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sndfile.hh>

#include "odas/base/error.hpp"

namespace odas::recorder_test {
namespace {

using What = Recorder::What;

/// The samples of a file of one voice of 16 bits.
std::vector<std::int16_t> samples(const test::Scratch& scratch, const std::string& name) {
  SndfileHandle file((scratch / name).string());
  EXPECT_EQ(file.error(), 0);
  std::vector<std::int16_t> all(static_cast<std::size_t>(file.frames()));
  EXPECT_EQ(file.readf(all.data(), file.frames()), file.frames());
  return all;
}

/// Samples of the voice `id` from sample `first` of the run on.
std::vector<std::int16_t> tone(std::uint64_t id, std::uint64_t first, std::size_t count) {
  std::vector<std::int16_t> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = test::tone_sample(id, first + i);
  return all;
}

class Recording : public testing::Test {
 protected:
  Recording() { recorder.begin(hops.info()); }
  void play(int count, const std::vector<std::uint64_t>& ids) {
    for (int i = 0; i < count; ++i) recorder.hop(hops.next(ids));
  }
  std::string only(const std::optional<std::vector<std::string>>& names) {
    EXPECT_TRUE(names && names->size() == 1);
    return names && !names->empty() ? names->front() : "";
  }
  test::Scratch scratch;
  test::HopMaker hops;
  Recorder recorder{scratch.folder(), 1.0};
};

TEST_F(Recording, of_a_voice_begins_with_its_lookback_to_the_sample) {
  play(250, {1, 2});
  recorder.start(7, {What::track, AudioStream::separated, 2, 0.5});
  play(100, {1, 2});
  const std::string name = only(recorder.stop(7));
  EXPECT_EQ(samples(scratch, name), tone(2, 250 * 128 - 8000, 8000 + 100 * 128));
  const auto told = nlohmann::json::parse(test::content((scratch / name).replace_extension(".json")));
  EXPECT_NEAR(told["start"].get<double>(), 250 * 0.008 - 0.5 - 0.016, 0.001) << "of its sound";
}

TEST_F(Recording, never_looks_back_beyond_the_birth_of_its_voice) {
  play(100, {1, 0});
  play(20, {2, 0});
  recorder.start(1, {What::track, AudioStream::separated, 2, 1.0});
  play(10, {2, 0});
  EXPECT_EQ(samples(scratch, only(recorder.stop(1))), tone(2, 100 * 128, 30 * 128));
}

TEST_F(Recording, of_a_voice_ends_with_it) {
  play(10, {1, 2});
  recorder.start(1, {What::track, AudioStream::separated, 1, 0});
  const std::string name = recorder.jobs().at(1).names.front();
  play(10, {1, 2});
  play(10, {3, 2});
  EXPECT_TRUE(recorder.jobs().empty());
  EXPECT_FALSE(recorder.stop(1).has_value());
  EXPECT_EQ(samples(scratch, name), tone(1, 10 * 128, 10 * 128));
}

TEST_F(Recording, of_all_has_each_voice_from_its_birth_in_a_file_of_its_own) {
  play(10, {1, 0});
  recorder.start(1, {What::all, AudioStream::separated, 0, 0});
  play(10, {1, 0});
  play(10, {1, 2});
  play(10, {3, 2});
  const auto names = recorder.stop(1);
  ASSERT_TRUE(names && names->size() == 3);
  EXPECT_EQ(samples(scratch, names->at(0)), tone(1, 10 * 128, 20 * 128));
  EXPECT_EQ(samples(scratch, names->at(1)), tone(2, 20 * 128, 20 * 128));
  EXPECT_EQ(samples(scratch, names->at(2)), tone(3, 30 * 128, 10 * 128));
}

// Eight slots, births and deaths at random: each file holds its own tone, from its birth to its death.
TEST_F(Recording, never_has_a_sample_of_another_voice) {
  hops = test::HopMaker(8);
  recorder.begin(hops.info());
  recorder.start(1, {What::all, AudioStream::separated, 0, 0.3});
  std::vector<std::uint64_t> ids(8, 0);
  std::uint64_t next = 1;
  std::map<std::uint64_t, std::pair<std::uint64_t, std::size_t>> expected;  // first sample, count
  std::uint32_t random = 12345;
  for (int hop = 0; hop < 400; ++hop) {
    for (auto& id : ids) {
      random = random * 1664525U + 1013904223U;
      if ((random >> 16) % 20 == 0) id = (random >> 24) % 3 == 0 ? 0 : next++;
      if (id == 0) continue;
      auto& [first, count] = expected[id];
      if (count == 0) first = static_cast<std::uint64_t>(hop) * 128;
      count += 128;
    }
    play(1, ids);
  }
  const auto names = recorder.stop(1);
  ASSERT_TRUE(names.has_value());
  EXPECT_EQ(names->size(), expected.size());
  EXPECT_GT(names->size(), 50U);
  for (const std::string& name : *names) {
    const std::uint64_t id = std::stoull(name.substr(name.find("source_") + 7));
    EXPECT_EQ(samples(scratch, name), tone(id, expected.at(id).first, expected.at(id).second)) << name;
  }
}

TEST_F(Recording, of_the_microphones_is_one_file_with_all_of_them) {
  play(50, {1, 0});
  recorder.start(1, {What::raw, AudioStream::raw, 0, 0.25});
  play(50, {1, 0});
  SndfileHandle file((scratch / only(recorder.stop(1))).string());
  ASSERT_EQ(file.channels(), 3);
  ASSERT_EQ(file.frames(), 4000 + 50 * 128);
  EXPECT_EQ(file.format() & SF_FORMAT_SUBMASK, SF_FORMAT_PCM_24);
  std::vector<float> all(static_cast<std::size_t>(file.frames()) * 3);
  file.readf(all.data(), file.frames());
  for (std::size_t i = 0; i < all.size(); ++i) {
    ASSERT_NEAR(all[i], test::tone_of(i % 3 + 1, 50 * 128 - 4000 + i / 3), 1e-6) << i;
  }
}

TEST_F(Recording, has_silence_where_hops_were_lost_and_keeps_its_time) {
  play(10, {1, 2});
  recorder.start(1, {What::track, AudioStream::separated, 1, 0});
  play(5, {1, 2});
  hops.time += 3;
  play(5, {1, 2});
  hops.with_voices = false;  // the tracks go on without sound
  play(2, {1, 2});
  hops.with_voices = true;
  play(1, {1, 2});
  const std::vector<std::int16_t> got = samples(scratch, only(recorder.stop(1)));
  std::vector<std::int16_t> expected = tone(1, 10 * 128, 16 * 128);
  std::fill(expected.begin() + 5 * 128, expected.begin() + 8 * 128, std::int16_t{0});
  std::fill(expected.begin() + 13 * 128, expected.begin() + 15 * 128, std::int16_t{0});
  EXPECT_EQ(got, expected);
}

TEST_F(Recording, goes_on_in_new_files_when_the_pipeline_is_another_one) {
  play(10, {1, 0});
  recorder.start(1, {What::all, AudioStream::separated, 0, 0});
  recorder.start(2, {What::track, AudioStream::separated, 1, 0});
  play(10, {1, 0});
  hops.time = 0;
  recorder.begin(hops.info());
  EXPECT_EQ(recorder.jobs().size(), 1U) << "voice 1 is no more";
  play(10, {1, 0});
  EXPECT_EQ(recorder.stop(1)->size(), 2U);
}

TEST_F(Recording, of_what_is_not_there_is_refused) {
  play(1, {1, 0});
  EXPECT_THROW(recorder.start(1, {What::track, AudioStream::separated, 9, 0}), IoError);
  EXPECT_THROW(recorder.start(1, {What::track, AudioStream::postfiltered, 1, 0}), IoError);
  EXPECT_TRUE(recorder.jobs().empty());
  recorder.end();
  EXPECT_THROW(recorder.start(1, {What::raw, AudioStream::raw, 0, 0}), IoError);
}

TEST_F(Recording, of_microphones_that_never_come_ends_and_says_so) {
  hops.with_mics = false;
  recorder.start(1, {What::raw, AudioStream::raw, 0, 0});
  play(1, {1, 0});
  EXPECT_TRUE(recorder.jobs().empty());
  ASSERT_EQ(recorder.take_faults().size(), 1U);
}

TEST_F(Recording, on_a_full_disk_ends_says_so_once_and_leaves_the_rest_alone) {
  play(10, {1, 2});
  recorder.start(1, {What::track, AudioStream::separated, 1, 0});
  {
    const test::FileSizeLimit limit(4000);
    play(50, {1, 2});
    recorder.flush();
  }
  EXPECT_TRUE(recorder.jobs().empty());
  EXPECT_EQ(recorder.take_faults().size(), 1U);
  recorder.start(2, {What::track, AudioStream::separated, 2, 0});
  play(1, {1, 2});
  EXPECT_TRUE(recorder.stop(2).has_value());
}

TEST_F(Recording, takes_words_while_it_goes_on_and_afterwards) {
  play(10, {1, 2});
  recorder.start(1, {What::all, AudioStream::separated, 0, 0});
  play(10, {1, 2});
  recorder.add(2, {0.1, 0.2, "hello"});
  const auto names = recorder.stop(1);
  recorder.add(2, {0.2, 0.3, "world"});
  const auto told = nlohmann::json::parse(test::content((scratch / names->at(1)).replace_extension(".json")));
  ASSERT_EQ(told["transcript"].size(), 2U);
  EXPECT_EQ(told["transcript"][1]["text"], "world");
  EXPECT_TRUE(recorder.take_faults().empty());
}

}  // namespace
}  // namespace odas::recorder_test
