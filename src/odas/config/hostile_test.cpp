// SPDX-License-Identifier: MIT
// Whatever a file holds: it gives faults or a configuration, never a crash, never an exit.
#include "support/config_faults.hpp"
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "odas/config/reader.hpp"

namespace odas::hostile_test {
namespace {

const std::string& whole() {
  static const std::string text = std::string(test::kLeast) + R"(
version = "2.1";
mapping: { map: (1, 2); };
ssl: { nPots = 4; scans = ( { level = 2; delta = -1; }, { level = 4; delta = -1; } );
       potential: { format = "json"; interface: { type = "terminal"; }; }; };
sst: { mode = "kalman"; add = "dynamic"; active = ( { weight = 1.0; mu = 0.4; sigma2 = 0.0025 } );
       N_inactive = [ 150, 200 ]; kalman: { sigmaQ = 0.001; }; /* targets */ target: ( { tag = "fan"; z = 1.0; } ); };
sss: { mode_sep = "dds"; separated: { fS = 44100; interface: { type = "file"; path = "out.raw"; }; }; }; # end
)";
  return text;
}

/// Either it can be run, or it is said why not.
void expect_verdict(const std::string& text) {
  const auto loaded = read_configuration_text(text, "x.cfg");
  if (loaded.ok()) {
    RC_ASSERT(loaded.config.pipeline.general.mics.size() >= 2U);
    RC_ASSERT(loaded.config.raw.n_channels >= 1);
  } else {
    RC_ASSERT(!loaded.faults.empty());
  }
}

TEST(Hostile, the_file_that_is_spoilt_below_is_whole) {
  ASSERT_TRUE(test::clean(read_configuration_text(whole(), "x.cfg")));
}

RC_GTEST_PROP(Hostile, a_file_that_is_cut_gives_a_verdict, ()) {
  const auto length = *rc::gen::inRange<std::size_t>(0, whole().size());
  expect_verdict(whole().substr(0, length));
}

RC_GTEST_PROP(Hostile, a_file_with_strange_bytes_gives_a_verdict, ()) {
  std::string text = whole();
  const auto changes = *rc::gen::container<std::vector<std::pair<std::size_t, char>>>(
      rc::gen::pair(rc::gen::inRange<std::size_t>(0, text.size()), rc::gen::arbitrary<char>()));
  for (const auto& [at, byte] : changes) text[at] = byte;
  expect_verdict(text);
}

RC_GTEST_PROP(Hostile, a_file_with_pieces_put_elsewhere_gives_a_verdict, ()) {
  std::string text = whole();
  const auto from = *rc::gen::inRange<std::size_t>(0, text.size());
  const auto length = *rc::gen::inRange<std::size_t>(0, 40);
  const auto to = *rc::gen::inRange<std::size_t>(0, text.size());
  text.insert(to, text.substr(from, length));
  expect_verdict(text);
}

RC_GTEST_PROP(Hostile, tokens_in_any_order_give_a_verdict, ()) {
  const auto tokens = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
      "raw", "general", "mics", "mu", "{", "}", "(", ")", "[", "]", "=", ":", ";", ",", "1", "-1e999", "0x",
      "\"", "\\", "\"a\"", "true", "#", "//", "/*", "*/", "@include \"/\"", "\n@include \"/\"\n", "\n", " ",
      "1L", "99999999999"));
  std::string text;
  for (const std::string& token : tokens) text += token;
  expect_verdict(text);
}

RC_GTEST_PROP(Hostile, any_number_in_any_place_gives_a_verdict, ()) {
  std::string text = whole();
  std::vector<std::size_t> digits;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] >= '0' && text[i] <= '9') digits.push_back(i);
  }
  const auto at = *rc::gen::elementOf(digits);
  const auto number =
      *rc::gen::element<std::string>("0", "-1", "2147483648", "-2147483649", "1e39", "1e-60", "1e400",
                                     "0xFFFFFFFFFFFFFFFFFF", "9e9", "65536", "1000000", "nan", "inf");
  text.replace(at, 1, number);
  expect_verdict(text);
}

TEST(Hostile, deep_nesting_is_refused_in_words) {
  for (const std::size_t depth : {65U, 5000U, 1000000U}) {
    const auto loaded =
        read_configuration_text("a = " + std::string(depth, '(') + std::string(depth, ')') + ";", "x.cfg");
    ASSERT_FALSE(loaded.ok());
    EXPECT_NE(loaded.faults.front().what.find("nested deeper"), std::string::npos);
  }
}

TEST(Hostile, a_huge_list_is_read_and_judged) {
  std::string list = "1";
  for (int i = 0; i < 100000; ++i) list += ",1";
  const auto loaded = test::read_with("mapping: { map = (" + list + "); };");
  EXPECT_TRUE(test::errs(loaded, "mapping.map", "has 100001 entries for the 2 microphones"));
}

TEST(Hostile, many_faults_are_not_hidden_and_not_without_end) {
  std::string mics;
  for (int i = 0; i < 5000; ++i) mics += "{ mu = (0, 0); }, ";
  const auto loaded = test::read_changed("mics = (", "mics = (" + mics);
  EXPECT_TRUE(test::errs(loaded, "general.mics[4999].mu", "has 2 numbers"));
}

TEST(Hostile, an_empty_file_says_what_it_must_hold) {
  EXPECT_TRUE(test::errs(read_configuration_text("", "x.cfg"), "general.mics", "is missing"));
}

TEST(Hostile, text_that_is_not_UTF8_is_carried_or_refused) {
  const auto carried =
      test::read_with("sss: { separated: { interface: { type = \"file\"; path = \"caf\xE9.raw\"; }; }; };");
  EXPECT_TRUE(test::clean(carried));
  EXPECT_EQ(carried.config.separated.interface.path, "caf\xE9.raw");
  EXPECT_FALSE(read_configuration_text("\xFF\xFE\x72", "x.cfg").ok());
}

}  // namespace
}  // namespace odas::hostile_test
