// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/image/color.h"

#include <gtest/gtest.h>

#include <limits>

namespace etendue::color_test {
namespace {

TEST(Color, OfBandsFollowsTheRuleOfPictures) {
  const std::vector<double> values = {1, 2, 3, 4, 5, 6};
  EXPECT_EQ(linear_colors(BandColor({{"red", "green", "blue"}, {}}),
                          WhiteBalance({{"red", "green", "blue"}, {}}), values, 3),
            values);
  EXPECT_EQ(
      linear_colors(BandColor({{"grey"}, {}}), WhiteBalance({{"grey"}, {}}), std::vector<double>{1, 2}, 1),
      (std::vector<double>{1, 1, 1, 2, 2, 2}));
  EXPECT_EQ(linear_colors(BandColor({{"a", "b"}, {}}), WhiteBalance({{"a", "b"}, {}}),
                          std::vector<double>{1, 2}, 2),
            (std::vector<double>{1.5, 1.5, 1.5}));
}

TEST(Color, FollowsTheSrgbTransferFunction) {
  const Exposure exposure{2};
  EXPECT_EQ(display_value(0, exposure), 0);
  EXPECT_EQ(display_value(2, exposure), 255);
  // 18 % grey is 46.1 % of the code range (IEC 61966-2-1); 0.2 % lies on the linear part: 12.92 * 0.002 *
  // 255.
  EXPECT_EQ(display_value(0.36, exposure), 118);
  EXPECT_EQ(display_value(0.004, exposure), 7);
}

TEST(Color, ClipsWhatIsNegativeBrighterThanWhiteOrNotANumber) {
  const Exposure exposure{1};
  EXPECT_EQ(display_value(-1, exposure), 0);
  EXPECT_EQ(display_value(1e300, exposure), 255);
  EXPECT_EQ(display_value(std::numeric_limits<double>::infinity(), exposure), 255);
  EXPECT_EQ(display_value(std::numeric_limits<double>::quiet_NaN(), exposure), 0);
}

TEST(Color, WhiteIsExceededByFivePercentOfTheVolume) {
  std::vector<double> rgb;
  std::vector<double> volumes;
  for (int cell = 1; cell <= 100; ++cell) {
    rgb.insert(rgb.end(), 3, cell);  // grey, so that the luminance is the value
    volumes.push_back(1);
  }
  EXPECT_NEAR(exposure_of(rgb, volumes, 1).white, 95, 1.001);
}

TEST(Color, WhiteDoesNotDependOnHowFineTheBrightPartIsMeshed) {
  // 98 % of the volume at 1 in one cell, and 2 % of it at 10 in a thousand cells.
  std::vector<double> rgb(3, 1);
  std::vector<double> volumes = {0.98};
  rgb.insert(rgb.end(), 3000, 10);
  volumes.insert(volumes.end(), 1000, 0.02 / 1000);
  EXPECT_NEAR(exposure_of(rgb, volumes, 1).white, 1, 1e-12);
}

TEST(Color, BlackIsExposedToo) {
  const std::vector<double> rgb(12, 0);
  const std::vector<double> volumes = {1};
  EXPECT_EQ(exposure_of(rgb, volumes, 4).white, 1);
}

}  // namespace
}  // namespace etendue::color_test
