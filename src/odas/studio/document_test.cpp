// SPDX-License-Identifier: MIT
#include "odas/studio/document.hpp"

#include "support/scratch.hpp"
#include "support/studio_parts.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::document_test {
namespace {

TEST(Document, is_read_and_checked) {
  Document document = test::sample_document();
  EXPECT_EQ(document.name, "sample");
  const CheckedDocument checked = check_document(document, Outputs::network);
  EXPECT_NE(checked.pipeline, nullptr);
  EXPECT_TRUE(checked.config.pipeline.wanted.mics && checked.config.pipeline.wanted.power_map);
  document.text = "raw: { fS = 5; };";
  EXPECT_THROW(static_cast<void>(check_document(document, Outputs::network)), ConfigError);
}

TEST(Document, has_a_hash_that_tells_texts_apart) {
  EXPECT_EQ(hash_of("a").size(), 16U);
  EXPECT_EQ(hash_of("a"), hash_of("a"));
  EXPECT_NE(hash_of("a"), hash_of("b"));
}

TEST(Document, is_saved_whole_or_not_at_all) {
  const test::Scratch scratch;
  save_text(scratch / "a.cfg", "one");
  save_text(scratch / "a.cfg", "two");
  EXPECT_EQ(test::content(scratch / "a.cfg"), "two");
}

}  // namespace
}  // namespace odas::document_test
