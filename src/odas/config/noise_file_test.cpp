// SPDX-License-Identifier: MIT
#include "odas/config/noise_file.hpp"

#include <fstream>
#include <functional>

#include "support/config_faults.hpp"
#include "support/machine_noise.hpp"
#include "support/scratch.hpp"

#include "odas/config/describe.hpp"

namespace odas::noise_file_test {
namespace {

using test::Machine;

class NoiseFile : public ::testing::Test {
 protected:
  std::filesystem::path file() { return scratch_ / "machine.noise"; }
  std::string bytes() {
    std::ifstream in(file(), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void put(const std::string& text) { std::ofstream(file(), std::ios::binary) << text; }
  std::string fault() {
    try {
      (void)read_noise_file(file());
    } catch (const IoError& error) { return error.what(); }
    return "";
  }

  test::Scratch scratch_;
};

/// Of two microphones, as test::kLeast has them.
NoiseDictionary small() {
  NoiseDictionary dictionary{16000, 128, 256, {{0.05F, 0, 0}, {-0.05F, 0, 0}}, {{1, 0.5F, 0.1F, {}}}};
  for (std::size_t k = 0; k < dictionary.bins(); ++k) {
    dictionary.entries[0].scm.insert(dictionary.entries[0].scm.end(), {1, {0, 0.5F}, {0, -0.5F}, 1});
  }
  return dictionary;
}

TEST_F(NoiseFile, gives_back_what_was_written) {
  const NoiseDictionary written = Machine::dictionary();
  write_noise_file(written, file());
  const NoiseDictionary read = read_noise_file(file());
  EXPECT_EQ(read.sample_rate, written.sample_rate);
  EXPECT_EQ(read.hop_size, written.hop_size);
  EXPECT_EQ(read.frame_size, written.frame_size);
  EXPECT_EQ(read.mics, written.mics);
  ASSERT_EQ(read.entries.size(), written.entries.size());
  for (std::size_t e = 0; e < read.entries.size(); ++e) {
    EXPECT_EQ(read.entries[e].share, written.entries[e].share);
    EXPECT_EQ(read.entries[e].likeness, written.entries[e].likeness);
    EXPECT_EQ(read.entries[e].deviation, written.entries[e].deviation);
    ASSERT_EQ(read.entries[e].scm.size(), written.entries[e].scm.size());
    for (std::size_t i = 0; i < read.entries[e].scm.size(); ++i) {
      EXPECT_LT(std::abs(read.entries[e].scm[i] - written.entries[e].scm[i]), 1e-5F);
    }
  }
}

TEST_F(NoiseFile, says_what_is_wrong_with_a_file) {
  EXPECT_NE(fault().find("make it with odas learn-noise"), std::string::npos);
  put("a recipe for soup\n");
  EXPECT_NE(fault().find("is no noise dictionary"), std::string::npos);
  write_noise_file(small(), file());
  const std::string whole = bytes();
  put(whole.substr(0, whole.size() - 1));
  EXPECT_NE(fault().find("is cut short"), std::string::npos);
  for (const auto& [from, to] : {std::pair{"mics 2", "mics 0"},
                                 {"mics 2", "mics 3"},
                                 {"entries 1", "entries 900"},
                                 {"frame 256", "frame -1"},
                                 {"hop 128", "hip 128"}}) {
    std::string text = whole;
    text.replace(text.find(from), std::string(from).size(), to);
    put(text);
    EXPECT_NE(fault().find("is damaged"), std::string::npos) << to;
  }
  std::string text = whole;
  for (int i = 1; i <= 4; ++i) text[text.size() - static_cast<std::size_t>(i)] = '\xFF';  // NaN
  put(text);
  EXPECT_NE(fault().find("holds what is no covariance"), std::string::npos);
}

TEST_F(NoiseFile, of_any_first_part_is_refused_in_words) {
  write_noise_file(small(), file());
  const std::string whole = bytes();
  for (std::size_t length = 0; length < 200; ++length) {
    put(whole.substr(0, length));
    EXPECT_FALSE(fault().empty()) << length;
  }
}

TEST_F(NoiseFile, is_read_from_beside_the_configuration_and_must_fit_it) {
  const std::filesystem::path cfg = scratch_ / "robot.cfg";
  const auto configured = [&](const NoiseDictionary& dictionary) {
    write_noise_file(dictionary, file());
    std::ofstream(cfg) << test::kLeast << "sss: { noise = \"machine.noise\"; };\n";
    return read_configuration(cfg);
  };
  const LoadedConfiguration loaded = configured(small());
  EXPECT_TRUE(loaded.ok()) << test::all_of(loaded.faults);
  EXPECT_EQ(loaded.config.pipeline.known_noise.entries.size(), 1U);
  EXPECT_NE(describe_plan(loaded.config, {}).find("known noise     machine.noise, 1 state"),
            std::string::npos);

  const auto refused = [&](const std::function<void(NoiseDictionary&)>& change, std::string_view why) {
    NoiseDictionary other = small();
    change(other);
    return test::errs(configured(other), "sss.noise", why);
  };
  EXPECT_TRUE(refused([](auto& d) { d.sample_rate = 48000; }, "a rate of 48000, not 16000"));
  EXPECT_TRUE(refused([](auto& d) { d.hop_size = 64; }, "a hop of 64, not 128"));
  EXPECT_TRUE(refused([](auto& d) { d.mics[1].x = -0.06F; }, "microphone 2 at another place"));
  EXPECT_TRUE(test::errs(configured(Machine::dictionary()), "sss.noise", "microphones: 4, not 2"));
  std::filesystem::remove(file());
  EXPECT_TRUE(test::errs(read_configuration(cfg), "sss.noise", "cannot read"));
}

}  // namespace
}  // namespace odas::noise_file_test
