// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/mirror.h"

#include <gtest/gtest.h>

#include <cmath>

namespace etendue::mirror_test {
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
  for (const double n : {1.1, 1.5, 2.0, 4.0})
    EXPECT_NEAR(n * n * (1 - mirrored_part_of_isotropic(refracting(n), 0)),
                1 - mirrored_part_of_isotropic(refracting(1 / n), 0), 1e-9);
  EXPECT_NEAR(mirrored_part_of_isotropic(refracting(1 / 1.5), 0), 0.0918, 1e-4);
}

// By a midpoint rule of many steps that knows nothing of the critical angle.
TEST(Fresnel, TransmittedMomentsAreTheIntegrals) {
  constexpr int steps = 1000000;
  for (const double n : {0.7, 1.0, 1.33, 2.5})
    for (const double cosine : {0.3, 0.8, 1.0}) {
      double zeroth = 0, first = 0;
      for (int i = 0; i < steps; ++i) {
        const double mu = (i + 0.5) * cosine / steps, part = 1 - fresnel_reflectance(mu, n);
        zeroth += part * cosine / steps;
        first += mu * part * cosine / steps;
      }
      EXPECT_NEAR(transmitted_moment(cosine, 0, n), zeroth, 1e-8) << n << " " << cosine;
      EXPECT_NEAR(transmitted_moment(cosine, 1, n), first, 1e-8) << n << " " << cosine;
    }
}

}  // namespace
}  // namespace etendue::mirror_test
