// SPDX-License-Identifier: MIT
#include "odas/io/array_drawing.hpp"

#include <regex>

#include <gtest/gtest.h>

namespace odas::array_drawing_test {
namespace {

std::string drawn(const std::vector<Vec3>& positions) {
  GeneralConfig general;
  ArrayPicture picture{"My array", "four", &general, {}, nullptr};
  for (const Vec3& p : positions) {
    MicConfig mic;
    mic.mu = {p.x, p.y, p.z};
    general.mics.push_back(mic);
    picture.channels.push_back(std::to_string(general.mics.size() + 1));
  }
  const DoaError error(general, 5e-6);
  picture.error = &error;
  SvgCanvas canvas(kArrayDrawingWidth, kArrayDrawingHeight);
  draw_array(canvas, picture);
  return canvas.document();
}

const std::vector<Vec3> kSquare{{0.03F, 0, 0}, {0, 0.03F, 0}, {-0.03F, 0, 0}, {0, -0.03F, 0}};

TEST(ArrayDrawing, shows_every_microphone_with_its_channel_and_where_azimuth_0_is) {
  const std::string text = drawn(kSquare);
  for (const char* piece : {">My array<", ">From above<", ">azimuth 0<", ">ch 2<", ">ch 5<", ">x, mm<",
                            ">z, mm<", ">Expected error over the sphere<"}) {
    EXPECT_NE(text.find(piece), std::string::npos) << piece;
  }
}

TEST(ArrayDrawing, names_microphones_that_hide_each_other) {
  EXPECT_NE(drawn(kSquare).find(">2, 4<"), std::string::npos) << "from the side";
}

TEST(ArrayDrawing, stays_on_its_page_whatever_the_array) {
  for (const auto& positions : {kSquare, {{0, 0, 0}, {0.0001F, 0, 0}}, {{5, 5, 5}, {7, 5, 1}, {5, 6, 9}}}) {
    const std::string text = drawn(positions);
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(text.find("inf"), std::string::npos);
    const std::regex circle("cx=\"([-0-9.]+)\" cy=\"([-0-9.]+)\"");
    for (std::sregex_iterator at(text.begin(), text.end(), circle), end; at != end; ++at) {
      EXPECT_GT(std::stod((*at)[1]), 0);
      EXPECT_LT(std::stod((*at)[1]), kArrayDrawingWidth);
      EXPECT_GT(std::stod((*at)[2]), 0);
      EXPECT_LT(std::stod((*at)[2]), kArrayDrawingHeight);
    }
  }
}

}  // namespace
}  // namespace odas::array_drawing_test
