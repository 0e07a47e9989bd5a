// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/color/tone.h"

#include <gtest/gtest.h>

namespace etendue::tone_test {
namespace {

TEST(Tone, RisesFromBlackToWhite) {
  for (const Tone tone : {Tone::linear, Tone::reinhard, Tone::aces}) {
    EXPECT_EQ(toned({0, 0, 0}, tone), (LinearColor{0, 0, 0}));
    double last = 0;
    for (double value = 0.01; value < 0.9; value += 0.01) {
      const double now = toned({value, value, value}, tone)[1];
      EXPECT_GT(now, last);
      last = now;
    }
    EXPECT_EQ(toned({1e6, 1e6, 1e6}, tone), (LinearColor{1, 1, 1}));
  }
}

TEST(Tone, OfReinhardIsWhiteAtFour) {
  EXPECT_NEAR(toned({4, 4, 4}, Tone::reinhard)[0], 1, 1e-8);
  EXPECT_NEAR(toned({1, 1, 1}, Tone::reinhard)[0], 17. / 32, 1e-8);
}

TEST(Tone, BringsColorsThatAreNotThereIntoRange) {
  const LinearColor shown = toned({0.5, -0.1, 0.2}, Tone::linear);
  EXPECT_NEAR(shown[1], 0, 1e-15);
  EXPECT_NEAR(luminance(shown), luminance({0.5, -0.1, 0.2}), 1e-12);
  EXPECT_EQ(toned({-1, -1, -1}, Tone::linear), (LinearColor{0, 0, 0}));
}

TEST(Tone, IsExposedForMostOfThePicture) {
  std::vector<LinearColor> colors;
  for (int i = 1; i <= 1000; ++i) colors.push_back({0.01 * i, 0.01 * i, 0.01 * i});
  colors.insert(colors.end(), 5000, {0, 0, 0});
  EXPECT_NEAR(1 / automatic_exposure(colors), 9.5, 0.02);
  EXPECT_EQ(automatic_exposure(std::vector<LinearColor>(3)), 1);
}

}  // namespace
}  // namespace etendue::tone_test
