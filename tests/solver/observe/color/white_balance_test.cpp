// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/color/white_balance.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/blackbody.h"

namespace etendue::white_balance_test {
namespace {

/// Largest primary less the smallest one, of their mean.
double hue_of(const LinearColor& color) {
  const auto [low, high] = std::ranges::minmax(color);
  return 3 * (high - low) / (color[0] + color[1] + color[2]);
}

// B. Lindbloom, Chromatic Adaptation (brucelindbloom.com): Bradford's matrices, whites of ASTM E308-01.
TEST(ChromaticAdaptation, HasThePublishedMatrices) {
  const Vec3 a(1.09850, 1, 0.35585), e(1, 1, 1), d65(0.95047, 1, 1.08883);
  Eigen::Matrix3d a_to_d65, e_to_d65;
  a_to_d65 << 0.8446965, -0.1179225, 0.3948108, -0.1366303, 1.1041226, 0.1291718, 0.0798489, -0.1348999,
      3.1924009;
  e_to_d65 << 0.9531874, -0.0265906, 0.0238731, -0.0382467, 1.0288406, 0.0094060, 0.0026068, -0.0030332,
      1.0892565;
  EXPECT_LT((chromatic_adaptation(a, d65) - a_to_d65).cwiseAbs().maxCoeff(), 1e-5);
  EXPECT_LT((chromatic_adaptation(e, d65) - e_to_d65).cwiseAbs().maxCoeff(), 1e-5);
}

// Equal energy is pink on a display of white D65 (R 1.205, G 0.948, B 0.909).
TEST(WhiteBalance, ShowsGreyBandsNeutral) {
  const std::vector<double> one = {1}, same_per_nm = {90, 100, 100, 180};
  for (const Bands& bands : {Bands{{"grey"}, {380, 780}}, Bands{{"laser"}, {632, 634}}}) {
    const LinearColor seen = BandColor(bands).of(one), shown = WhiteBalance(bands).of(seen);
    EXPECT_GT(hue_of(seen), 0.1);
    EXPECT_LT(hue_of(shown), 1e-9);
    EXPECT_NEAR(luminance(shown), luminance(seen), 1e-12);
    EXPECT_EQ(WhiteBalance(bands, {White::Kind::d65}).of(seen), seen);
  }
  const Bands four{{"a", "b", "c", "d"}, {360, 450, 550, 650, 830}};
  EXPECT_LT(hue_of(WhiteBalance(four).of(BandColor(four).of(same_per_nm))), 1e-6);
}

TEST(WhiteBalance, ShowsTheChosenBlackBodyNeutral) {
  Bands bands{{}, {360}};
  std::vector<double> radiance;
  for (int nm = 365; nm <= 830; nm += 5) {
    bands.names.push_back(std::to_string(nm));
    bands.edges.push_back(nm);
    radiance.push_back(planck_fraction(nm, 2856) - planck_fraction(nm - 5, 2856));
  }
  const LinearColor seen = BandColor(bands).of(radiance);
  EXPECT_GT(hue_of(seen), 1);
  EXPECT_LT(hue_of(WhiteBalance(bands, {White::Kind::black_body, 2856}).of(seen)), 2e-3);
}

TEST(WhiteBalance, LeavesPrimariesAndGreyAsTheyAre) {
  for (const Bands& bands : {Bands{{"red", "green", "blue"}, {700, 600, 500, 400}}, Bands{{"a", "b"}, {}}})
    EXPECT_EQ(WhiteBalance(bands).of({1, 2, 3}), (LinearColor{1, 2, 3}));
}

// Infrared has no color: it is shown as grey, not black.
TEST(BandColor, ShowsBandsThatTheEyeDoesNotSeeAsGrey) {
  const BandColor color(Bands{{"a", "b"}, {900, 1000, 1100}});
  EXPECT_EQ(color.of(std::vector<double>{1, 3}), (LinearColor{2, 2, 2}));
}

}  // namespace
}  // namespace etendue::white_balance_test
