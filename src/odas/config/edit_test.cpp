// SPDX-License-Identifier: MIT
#include "odas/config/edit.hpp"

#include "support/config_faults.hpp"

namespace odas::edit_test {
namespace {

std::string edited(std::string_view text) { return with_setting(text, "sst", "active", "(NEW)"); }

TEST(Edit, writes_the_value_of_a_setting_otherwise_and_leaves_all_else) {
  EXPECT_EQ(edited("a = 1; # one\nsst: {\n  active = ( { mu = 0.1; } ); # old\n  add = \"static\";\n};\n"),
            "a = 1; # one\nsst: {\n  active = (NEW); # old\n  add = \"static\";\n};\n");
}

TEST(Edit, takes_the_grammar_as_libconfig_does) {
  EXPECT_EQ(edited("sst = { active : [1, 2] }"), "sst = { active : (NEW) }");
  EXPECT_EQ(edited("sst: { active = ( {mu = 1} )\n inactive = ( {mu = 2} ) }"),
            "sst: { active = (NEW)\n inactive = ( {mu = 2} ) }");
  EXPECT_EQ(edited("sst: { active = 1 inactive = 2 }"), "sst: { active = (NEW) inactive = 2 }");
  EXPECT_EQ(edited("sst: { active = 1 }"), "sst: { active = (NEW) }");
  EXPECT_EQ(edited("sst: { active = 1, }"), "sst: { active = (NEW), }");
}

TEST(Edit, is_not_led_astray_by_comments_strings_and_namesakes) {
  const std::string before =
      "# sst: { active = 1; }\n/* sst: { active = 2; } */ // sst: { active = 3; }\n"
      "a = \"sst: { active = 4; } \\\" \";\nother: { active = 5; sst: { active = 6; }; };\nactive = 7;\n"
      "list = ( { active = 8; } );\n";
  EXPECT_EQ(edited(before + "sst: { k: { active = 9; }; inactive = 10; active = 11; };"),
            before + "sst: { k: { active = 9; }; inactive = 10; active = (NEW); };");
}

TEST(Edit, puts_in_what_is_absent) {
  EXPECT_EQ(edited("sst: { add = 1; };"), "sst: {\n  active = (NEW); add = 1; };");
  EXPECT_EQ(edited("a = 1;\n"), "a = 1;\n\nsst: {\n  active = (NEW);\n};\n");
}

TEST(Edit, takes_a_setting_out) {
  const auto without = [](std::string_view text) { return without_setting(text, "sst", "active"); };
  EXPECT_EQ(without("sst: {\n  a = 1;\n  active = (1, 2);\n  b = 2;\n};\n"),
            "sst: {\n  a = 1;\n  b = 2;\n};\n");
  EXPECT_EQ(without("sst: { a = 1; active: { mu = 1; }; b = 2; }"), "sst: { a = 1;  b = 2; }");
  EXPECT_EQ(without("sst: { active = 1 }"), "sst: {  }");
  EXPECT_EQ(without("active = 1; sst: { a = 1; }"), "active = 1; sst: { a = 1; }");
}

TEST(Edit, gives_a_text_that_reads_as_it_was_meant) {
  const std::string text = with_setting(
      std::string(test::kLeast) + "sst: { add = \"dynamic\" active = (\n{ mu = 0.3; }\n) N_prob = 4 }", "sst",
      "active", "( { weight = 1.0; mu = 0.7; sigma2 = 0.01; } )");
  const auto loaded = read_configuration_text(text, "edited.cfg");
  EXPECT_TRUE(test::clean(loaded)) << text;
  EXPECT_FLOAT_EQ(loaded.config.pipeline.sst.active.at(0).mu, 0.7F);
  EXPECT_EQ(loaded.config.pipeline.sst.n_prob, 4);
}

}  // namespace
}  // namespace odas::edit_test
