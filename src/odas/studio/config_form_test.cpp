// SPDX-License-Identifier: MIT
#include "odas/studio/config_form.hpp"

#include "support/studio_parts.hpp"
#include <gtest/gtest.h>

namespace odas::config_form_test {
namespace {

using nlohmann::json;

/// The field of this path; null: there is none.
json find(const json& fields, const std::string& path) {
  for (const json& field : fields) {
    if (field.at("path") == path) return field;
    if (field.contains("fields")) {
      if (json inner = find(field.at("fields"), path); !inner.is_null()) return inner;
    }
  }
  return nullptr;
}

json field(const json& form, const std::string& path) {
  for (const json& section : form.at("sections")) {
    if (json found = find(section.at("fields"), path); !found.is_null()) return found;
  }
  return nullptr;
}

TEST(ConfigForm, describes_each_key_from_its_own_field) {
  const Document sample = test::sample_document();
  const json form = config_form(read_configuration_text(sample.text, sample.source_name()));
  const json rate = field(form, "raw.fS");
  EXPECT_EQ(rate.at("kind"), "int");
  EXPECT_EQ(rate.at("unit"), "Hz");
  EXPECT_EQ(rate.at("value"), 16000);
  EXPECT_TRUE(rate.at("written").get<bool>());
  EXPECT_GT(rate.at("line").get<int>(), 0);
  EXPECT_FALSE(rate.at("meaning").get<std::string>().empty());
  const json type = field(form, "raw.interface.type");
  EXPECT_EQ(type.at("value"), "file");
  EXPECT_FALSE(type.at("choices").empty());
  const json camera = field(form, "studio.camera.fx");
  EXPECT_FALSE(camera.at("written").get<bool>());
  EXPECT_EQ(camera.at("value"), camera.at("default"));
  EXPECT_TRUE(camera.at("line").is_null());
}

TEST(ConfigForm, has_the_items_of_lists_and_one_that_is_new) {
  const Document sample = test::sample_document();
  const json form = config_form(read_configuration_text(sample.text, sample.source_name()));
  const json mics = field(form, "general.mics");
  EXPECT_EQ(mics.at("kind"), "list");
  ASSERT_EQ(mics.at("items").size(), 4U);
  EXPECT_EQ(find(mics.at("items").at(1), "general.mics[1].mu").at("value").at(1), -0.032);
  EXPECT_EQ(find(mics.at("item"), "general.mics[].mu").at("length"), 3);
}

TEST(ConfigForm, tells_what_is_written_from_what_holds) {
  LoadedConfiguration loaded =
      read_configuration_text("raw: { interface: { type = \"file\"; path = \"a.wav\"; }; };\n", "text");
  EXPECT_EQ(written_value(loaded, "raw", "interface"), (json{{"type", "file"}, {"path", "a.wav"}}));
  EXPECT_TRUE(written_value(loaded, "raw", "fS").is_null());
  EXPECT_TRUE(written_value(loaded, "sst", "no_such_key").is_null());
}

}  // namespace
}  // namespace odas::config_form_test
