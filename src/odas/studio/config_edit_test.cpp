// SPDX-License-Identifier: MIT
#include "odas/studio/config_edit.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "odas/base/error.hpp"

namespace odas::config_edit_test {
namespace {

TEST(ConfigEdit, writes_values_as_a_configuration_has_them) {
  const std::string text = setting_text(nlohmann::json::parse(R"({"a":[1,2],"b":true,"c":null})"));
  EXPECT_NE(text.find("a = "), std::string::npos);
  EXPECT_NE(text.find("true"), std::string::npos);
  EXPECT_EQ(text.find("c ="), std::string::npos);
}

using nlohmann::json;

std::string changed(const std::string& text, const char* changes) {
  return with_changes(text, "text", json::parse(changes));
}

TEST(ConfigEdit, changes_a_setting_and_leaves_all_else_as_it_was) {
  const std::string text = "# mine\nsst: { N_prob = 5; # patient\n  theta_new = 0.5; };\n";
  EXPECT_EQ(changed(text, R"([{"path":"sst.N_prob","value":8}])"),
            "# mine\nsst: { N_prob = 8; # patient\n  theta_new = 0.5; };\n");
  EXPECT_EQ(changed(text, R"([{"path":"sst.theta_new","value":null}])"),
            "# mine\nsst: { N_prob = 5; # patient\n   };\n")
      << "a key that is taken out";
  EXPECT_NE(changed(text, R"([{"path":"ssl.nPots","value":3}])").find("nPots = 3"), std::string::npos);
}

TEST(ConfigEdit, reaches_into_groups_and_lists) {
  const std::string text =
      "raw: { interface: { type = \"file\"; path = \"a.wav\"; }; };\n"
      "general: { mics = ( { mu = (1.0, 0.0, 0.0); }, { mu = (2.0, 0.0, 0.0); } ); };\n";
  const auto read = [](const std::string& made) { return read_configuration_text(made, "text").config; };
  EXPECT_EQ(read(changed(text, R"([{"path":"raw.interface.path","value":"b.wav"}])")).raw.interface.path,
            "b.wav");
  EXPECT_EQ(read(changed(text, R"([{"path":"raw.interface.path","value":"b.wav"}])")).raw.interface.type,
            "file");
  const auto mics = [&](const char* changes) { return read(changed(text, changes)).pipeline.general.mics; };
  EXPECT_FLOAT_EQ(mics(R"([{"path":"general.mics[1].mu","value":[7,8,9]}])").at(1).mu[0], 7);
  EXPECT_EQ(mics(R"([{"path":"general.mics[0]","value":null}])").size(), 1U);
  EXPECT_EQ(mics(R"([{"path":"general.mics[2]","value":{"mu":[3,0,0]}}])").size(), 3U);
  EXPECT_EQ(mics(R"([{"path":"general.mics","value":[{"mu":[3,0,0]}]}])").size(), 1U);
}

TEST(ConfigEdit, refuses_paths_that_lead_nowhere) {
  for (const char* path :
       {"", "sst", "sst.", "sst.a b", "general.mics[9]", "general.mics[x]", "[0]", "a..b"}) {
    const json changes = json::array({{{"path", path}, {"value", 1}}});
    EXPECT_THROW(static_cast<void>(with_changes("general: { mics = (); };", "text", changes)), ConfigError)
        << path;
  }
}

}  // namespace
}  // namespace odas::config_edit_test
