// SPDX-License-Identifier: MIT
#include "odas/io/canvas.hpp"

#include <array>

#include <gtest/gtest.h>

namespace odas::canvas_test {
namespace {

TEST(SvgCanvas, is_a_whole_document_of_its_size) {
  const std::string text = SvgCanvas(300, 200).document();
  EXPECT_TRUE(text.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"300\" height=\"200\""))
      << text;
  EXPECT_TRUE(text.ends_with("</svg>\n"));
}

TEST(SvgCanvas, draws_lines_areas_circles_and_words) {
  SvgCanvas canvas(10, 10);
  const std::array spots{Spot{1, 2}, Spot{3, 4.5}};
  canvas.polyline(spots, false, {.line = {1, 0, 0, 1}, .width = 2, .dashed = true});
  canvas.polyline(spots, true, {.fill = {0, 0, 1, 0.5}});
  canvas.circle({5, 6}, 7, {.fill = {0, 1, 0, 1}});
  canvas.text({8, 9}, "a < b & c", {.size = 11, .anchor = Canvas::Anchor::right, .bold = true});
  const std::string text = canvas.document();
  for (const char* piece :
       {"<polyline points=\"1.00,2.00 3.00,4.50\" fill=\"none\" stroke=\"#ff0000\" stroke-width=\"2\" "
        "stroke-dasharray",
        "<polygon points=\"1.00,2.00 3.00,4.50\" fill=\"#0000ff\" fill-opacity=\"0.50\"/>",
        "<circle cx=\"5.00\" cy=\"6.00\" r=\"7.00\" fill=\"#00ff00\"/>",
        "text-anchor=\"end\" font-weight=\"bold\"", ">a &lt; b &amp; c</text>"}) {
    EXPECT_NE(text.find(piece), std::string::npos) << piece << '\n' << text;
  }
}

}  // namespace
}  // namespace odas::canvas_test
