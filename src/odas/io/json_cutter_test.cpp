// SPDX-License-Identifier: MIT
#include "odas/io/json_cutter.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace odas::json_cutter_test {
namespace {

/// "{...}" of what is good, "!fault <excerpt>" of what is not, in pieces of `size` bytes.
std::vector<std::string> cuts(std::string_view stream, std::size_t size) {
  JsonCutter cutter;
  std::vector<std::string> all;
  for (std::size_t at = 0; at < stream.size(); at += size) {
    cutter.push(stream.substr(at, size));
    while (const auto cut = cutter.next()) {
      all.push_back(cut->fault == nullptr
                        ? std::string(cut->text)
                        : "!" + std::string(cut->fault) + " <" + std::string(cut->text) + ">");
    }
  }
  return all;
}

using Texts = std::vector<std::string>;

TEST(JsonCutter, gives_each_object_whatever_stands_between_and_however_it_is_chopped) {
  const std::string stream =
      "{\n  \"a\": 1\n}\n{\"b\":{\"c\":[{},{}]}}{}\r\n " + std::string(1, '\0') + "{\"d\":\"}{\\\"}\"}";
  for (const std::size_t size : {1U, 2U, 3U, 5U, 7U, 1000U}) {
    EXPECT_EQ(cuts(stream, size),
              (Texts{"{\n  \"a\": 1\n}", "{\"b\":{\"c\":[{},{}]}}", "{}", "{\"d\":\"}{\\\"}\"}"}))
        << size;
  }
}

TEST(JsonCutter, says_garbage_once_and_shows_how_it_begins) {
  EXPECT_EQ(cuts("GET / HTTP/1.1\r\n\r\n{}xy", 1000),
            (Texts{"!is no JSON object <GET / HTTP/1.1\r\n\r\n{}xy>", "{}", "!is no JSON object <xy>"}));
  EXPECT_EQ(cuts("}\n}\n}\n", 2), (Texts{"!is no JSON object <}\n>"}));
}

TEST(JsonCutter, an_object_that_was_cut_off_costs_only_itself) {
  EXPECT_EQ(cuts("{\"a\": [ {\"b\"{\"c\":1}", 1000), (Texts{"!is cut off <{\"a\": [ {\"b\">", "{\"c\":1}"}));
}

TEST(JsonCutter, a_string_that_was_cut_off_ends_with_its_line) {
  EXPECT_EQ(cuts("{\"a\":\"b\n{\"c\":1}", 1000), (Texts{"!is cut off <{\"a\":\"b>", "{\"c\":1}"}));
}

TEST(JsonCutter, holds_no_object_without_an_end) {
  const std::string endless = "{\"a\":[" + std::string(2 * JsonCutter::kLongest, '1');
  const Texts all = cuts(endless + "{\"b\":2}", 4096);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_TRUE(all[0].starts_with("!has more than 65536 bytes <{\"a\":[111")) << all[0];
  EXPECT_EQ(all[1], "{\"b\":2}");
}

RC_GTEST_PROP(JsonCutter, cuts_alike_however_the_stream_is_chopped,
              (const std::vector<std::uint8_t>& picks)) {
  static constexpr const char* kParts[]{"{", "}", "\"", "\\", "[", "]",
                                        ",", ":", " ",  "\n", "x", "{\"a\":1}"};
  std::string stream;
  for (const std::uint8_t pick : picks) stream += kParts[pick % std::size(kParts)];
  const auto without_excerpts = [&](std::size_t size) {
    Texts all = cuts(stream, size);
    for (std::string& text : all) {
      if (text[0] == '!') text.resize(text.find(" <"));
    }
    return all;
  };
  RC_ASSERT(without_excerpts(1) == without_excerpts(stream.size() + 1));
}

}  // namespace
}  // namespace odas::json_cutter_test
