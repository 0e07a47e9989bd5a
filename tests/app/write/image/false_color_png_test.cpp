// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/image/false_color_png.h"

#include <gtest/gtest.h>
#include <png.h>

#include <limits>
#include <vector>

#include "app/write/image/raster.h"
#include "app/write/image/viridis.h"

namespace etendue::false_color_png_test {
namespace {

struct Image {
  int across, down;
  std::vector<std::uint8_t> rgb;
  RgbColor at(int column, int row) const {
    const auto first = 3 * static_cast<std::size_t>(row * across + column);
    return {rgb[first], rgb[first + 1], rgb[first + 2]};
  }
};

Image read_png(const std::string& bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()));
  image.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> rgb(PNG_IMAGE_SIZE(image));
  EXPECT_TRUE(png_image_finish_read(&image, nullptr, rgb.data(), 0, nullptr));
  return {static_cast<int>(image.width), static_cast<int>(image.height), rgb};
}

FalseColor up_to(double most) {
  FalseColor scale;
  scale.most = most;
  return scale;
}

FalseColor logarithmic() {
  FalseColor scale;
  scale.logarithmic = true;
  return scale;
}

// Ends of the map as matplotlib prints them: #440154 and #fde725; in the middle #21918c, here within 1.
TEST(Viridis, HasTheColorsOfItsAuthors) {
  EXPECT_EQ(viridis(0), (RgbColor{0x44, 0x01, 0x54}));
  EXPECT_EQ(viridis(1), (RgbColor{0xfd, 0xe7, 0x25}));
  EXPECT_EQ(viridis(2), viridis(1));
  EXPECT_EQ(viridis(-std::numeric_limits<double>::infinity()), viridis(0));
  const RgbColor middle = viridis(0.5), known = {0x21, 0x91, 0x8c};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(middle[i], known[i], 1);
}

TEST(FalseColors, HaveTheColorsOfTheirScale) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> values = {0, 50, 100, 200, nan, 10};
  const Image image = read_png(false_color_png({3, 2}, values, up_to(100), "luminance [cd/m^2]"));
  EXPECT_EQ(image.at(0, 0), viridis(0));
  EXPECT_EQ(image.at(1, 0), viridis(0.5));
  EXPECT_EQ(image.at(2, 0), viridis(1));
  EXPECT_EQ(image.at(0, 1), viridis(1));
  EXPECT_EQ(image.at(1, 1), (RgbColor{128, 128, 128}));
  EXPECT_EQ(image.at(2, 1), viridis(0.1));
  EXPECT_GT(image.across, 3 + text_width("luminance [cd/m^2]", 1));
  EXPECT_GT(image.down, 100);
}

TEST(FalseColors, EndAtTheLargestValueUnlessTheySayWhere) {
  const Image image =
      read_png(false_color_png({2, 1}, std::vector<double>{2.0, 2000.0}, logarithmic(), "radiance"));
  EXPECT_EQ(image.at(0, 0), viridis(0));
  EXPECT_EQ(image.at(1, 0), viridis(1));
}

// The bar falls from yellow to blue, and numbers are beside it.
TEST(FalseColors, HaveTheirScaleBesideThem) {
  const std::vector<double> values(400 * 300, 1.0);
  const Image image = read_png(false_color_png({400, 300}, values, up_to(10), "luminance [cd/m^2]"));
  ASSERT_EQ(image.down, 300);
  const int bar = 400 + 6 + 3;
  double last = 1000;
  int steps = 0;
  for (int row = 25; row < 280; row += 5) {
    const RgbColor color = image.at(bar, row);
    const double luminance = 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
    EXPECT_LE(luminance, last) << row;
    steps += luminance < last ? 1 : 0;
    last = luminance;
  }
  EXPECT_GT(steps, 40);
  int dark = 0;
  for (int row = 0; row < 300; ++row)
    for (int column = 424; column < image.across; ++column)
      if (image.at(column, row) == RgbColor{0, 0, 0}) ++dark;
  EXPECT_GT(dark, 100);
}

TEST(FalseColors, OfADarkPictureHaveAScale) {
  const Image image = read_png(false_color_png({1, 1}, std::vector<double>{0.0}, logarithmic(), "radiance"));
  EXPECT_EQ(image.at(0, 0), viridis(0));
}

// An L of 5 x 7 dots: its left column and its lowest row.
TEST(Raster, WritesCharacters) {
  Raster raster(12, 16, {255, 255, 255});
  raster.write(1, 1, "L", 2, {0, 0, 0});
  int dark = 0;
  for (std::size_t i = 0; i < raster.bytes().size(); i += 3) dark += raster.bytes()[i] == 0 ? 1 : 0;
  EXPECT_EQ(dark, 4 * (7 + 4));
  const auto is_dark = [&](int column, int row) {
    return raster.bytes()[3 * static_cast<std::size_t>(row * 12 + column)] == 0;
  };
  EXPECT_TRUE(is_dark(1, 1) && is_dark(2, 14) && is_dark(10, 14));
  EXPECT_FALSE(is_dark(3, 1) || is_dark(11, 14) || is_dark(10, 12));
}

}  // namespace
}  // namespace etendue::false_color_png_test
