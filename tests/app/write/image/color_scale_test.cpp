// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/image/color_scale.h"

#include <gtest/gtest.h>

namespace etendue::color_scale_test {
namespace {

std::string labels(const ColorScale& scale) {
  std::string text;
  for (const ColorScale::Tick& tick : scale.ticks()) text += (text.empty() ? "" : " ") + tick.label;
  return text;
}

TEST(ColorScale, GoesFromItsLeastToItsMost) {
  const ColorScale linear(10, 30, false), logarithmic(1, 100, true);
  EXPECT_NEAR(linear.place_of(15), 0.25, 1e-15);
  EXPECT_NEAR(logarithmic.place_of(10), 0.5, 1e-15);
  EXPECT_LT(logarithmic.place_of(0), 0);
  EXPECT_GT(linear.place_of(31), 1);
}

TEST(ColorScale, HasRoundNumbers) {
  EXPECT_EQ(labels({0, 1000, false}), "0 100 200 300 400 500 600 700 800 900 1000");
  EXPECT_EQ(labels({0, 7, false}), "0 1 2 3 4 5 6 7");
  EXPECT_EQ(labels({0.13, 0.29, false}), "0.14 0.16 0.18 0.2 0.22 0.24 0.26 0.28");
  EXPECT_EQ(labels({1, 1000, true}), "1 2 5 10 20 50 100 200 500 1000");
  EXPECT_EQ(labels({0.03, 4000, true}), "0.1 1 10 100 1000");
  EXPECT_EQ(labels({1e-30, 1, true}), "1e-30 1e-27 1e-24 1e-21 1e-18 1e-15 1e-12 1e-09 1e-06 0.001 1");
}

}  // namespace
}  // namespace etendue::color_scale_test
