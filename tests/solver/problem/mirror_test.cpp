// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/mirror.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace etendue {
namespace {

Wall refracting(double index) {
  Wall wall;
  wall.radiance = wall.diffuse = wall.specular = {0};
  wall.refractive_index = index;
  return wall;
}

TEST(Fresnel, KnowsNormalIncidenceBrewstersAngleAndTotalReflection) {
  for (const double n : {1.33, 1.5, 2.4}) {
    const double straight = (n - 1) * (n - 1) / ((n + 1) * (n + 1));
    EXPECT_NEAR(fresnel_reflectance(1, n), straight, 1e-15);
    EXPECT_NEAR(fresnel_reflectance(1, 1 / n), straight, 1e-15);
    // At Brewster's angle only light that swings across the plane is reflected: ((n^2 - 1)/(n^2 + 1))^2.
    const double across = (n * n - 1) / (n * n + 1);
    EXPECT_NEAR(fresnel_reflectance(n / std::sqrt(1 + n * n), n), across * across / 2, 1e-14);
    const double critical = std::sqrt(1 - 1 / (n * n));
    EXPECT_EQ(fresnel_reflectance(critical - 1e-9, n), 1);
    EXPECT_LT(fresnel_reflectance(critical + 1e-9, n), 1);
  }
  EXPECT_NEAR(fresnel_reflectance(1e-12, 0.7), 1, 1e-10);
}

TEST(Fresnel, IsTheSameBothWays) {
  for (const double n : {1.2, 1.5})
    for (const double cosine : {0.2, 0.5, 0.9}) {
      const double behind = std::sqrt(1 - (1 - cosine * cosine) / (n * n));
      EXPECT_NEAR(fresnel_reflectance(cosine, 1 / n), fresnel_reflectance(behind, n), 1e-14);
    }
}

// What goes through is the same both ways: n^2 (1 - r of the denser side) = 1 - r of the other. Of glass 9.18
// % of diffuse light is reflected outside (Duntley 1942).
TEST(Fresnel, OfIsotropicLightKeepsEtendue) {
  for (const double n : {1.1, 1.5, 2.0})
    EXPECT_NEAR(n * n * (1 - mirrored_part_of_isotropic(refracting(n), 0)),
                1 - mirrored_part_of_isotropic(refracting(1 / n), 0), 2e-4);
  EXPECT_NEAR(mirrored_part_of_isotropic(refracting(1 / 1.5), 0), 0.0918, 1e-4);
}

// Cones that fill the half space without gaps give what isotropic light sees; a narrow one gives its axis.
TEST(Fresnel, OverAConeIsItsMean) {
  EXPECT_NEAR(mean_fresnel_reflectance(1, 2 * std::numbers::pi, 1.5),
              mirrored_part_of_isotropic(refracting(1.5), 0), 1e-3);
  for (const double cosine : {0.1, 0.5, 0.8, 1.0})
    EXPECT_NEAR(mean_fresnel_reflectance(cosine, 1e-8, 1.5), fresnel_reflectance(cosine, 1.5), 1e-4);
  // Half of a narrow cone about the critical angle is reflected totally.
  const double critical = std::sqrt(1 - 1 / 2.25), inside = mean_fresnel_reflectance(critical, 1e-6, 1.5);
  EXPECT_GT(inside, 0.5);
  EXPECT_LT(inside, 1);
}

}  // namespace
}  // namespace etendue
