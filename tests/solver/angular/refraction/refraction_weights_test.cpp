// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/refraction/refraction_weights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/angular/refraction/ordinate_reflectance.h"
#include "solver/angular/refraction/polar_levels.h"
#include "solver/problem/mirror.h"
#include "tests/solver/angular/sets/sets_to_test.h"

namespace etendue::refraction_weights_test {
namespace {

using std::numbers::pi;

const double diagonal = std::sqrt(0.5);

/// Sets that are fine enough for every index below.
std::vector<DirectionSet> fine_sets() {
  return {directions_product(16), directions_double_gauss(8), directions_ldfe_sq(2),
          directions_triangular(16), directions_thurgood(8)};
}

/// Walls of a slab across z, of a box, and across the diagonals of x and y.
std::vector<std::vector<Vec3>> normals_to_test() {
  return {{Vec3::UnitZ()},
          {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()},
          {Vec3(diagonal, diagonal, 0), Vec3(diagonal, -diagonal, 0)}};
}

std::vector<SmoothPlane> planes_of(const std::vector<Vec3>& normals, double index) {
  std::vector<SmoothPlane> planes;
  for (const Vec3& normal : normals) planes.push_back({normal, index});
  return planes;
}

Wall refracting(double index) {
  Wall wall;
  wall.radiance = wall.diffuse = wall.specular = {0};
  wall.refractive_index = index;
  return wall;
}

template <class Function>
double moment(const DirectionSet& set, const Function& function) {
  double sum = 0;
  for (std::size_t m = 0; m < set.weights().size(); ++m)
    sum += set.weights()[m] * function(set.directions()[m]);
  return sum;
}

template <class Test>
void for_fitted_sets(const Test& test) {
  for (const DirectionSet& set : fine_sets())
    for (const std::vector<Vec3>& normals : normals_to_test())
      for (const double index : {0.75, 1.33, 1.5, 2.0})
        test(set, fitted_to_refraction(set, planes_of(normals, index)), normals, index,
             label(set) + ", index " + std::to_string(index) + ", normals " + std::to_string(normals.size()));
}

/// Absorbed and leaving parts of isotropic light from outside a slab with two faces that refract, over n^2,
/// all internal reflections summed.
struct SlabPowers {
  double absorbed = 0, outflow = 0;

  void add(double weight, double cosine, double reflected, double thickness) {
    const double passed = std::exp(-thickness / cosine), in = 2 * weight * cosine * (1 - reflected);
    absorbed += in * (1 - passed) / (1 - reflected * passed);
    outflow += in * (1 - reflected) * passed / (1 - reflected * passed);
  }
};

/// By the midpoint rule in t, mu = critical cosine + (1 - critical cosine) t^2.
SlabPowers exact_slab(double index, double thickness) {
  constexpr int steps = 20000;
  const double critical = critical_cosine(index);
  SlabPowers powers;
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) / steps, cosine = critical + (1 - critical) * t * t;
    powers.add(2 * t * (1 - critical) / steps, cosine, fresnel_reflectance(cosine, index), thickness);
  }
  return powers;
}

SlabPowers discrete_slab(const DirectionSet& set, const Vec3& normal, double index, double thickness) {
  const std::vector<double> reflected = ordinate_reflectances(set, refracting(index), normal);
  SlabPowers powers;
  for (std::size_t m = 0; m < reflected.size(); ++m)
    if (const double cosine = set.directions()[m].dot(normal); cosine > 0)
      powers.add(set.weights()[m] / (2 * pi), cosine, reflected[m], thickness);
  return powers;
}

// The weights of the ordinates that let light through are the solid angle of the cone and its flux.
TEST(RefractionWeights, HaveTheMomentsOfTheConeAndOfTheRest) {
  for_fitted_sets([](const DirectionSet&, const DirectionSet& set, const std::vector<Vec3>& normals,
                     double index, const std::string& name) {
    const double critical = critical_cosine(index);
    for (const Vec3& normal : normals) {
      EXPECT_NEAR(set.half_range(normal), pi, 1e-10) << name;
      const std::vector<double> reflected = ordinate_reflectances(set, refracting(index), normal);
      double solid_angle = 0, flux = 0;
      for (std::size_t m = 0; m < reflected.size(); ++m) {
        // Without a critical angle only light along the surface is reflected totally.
        if (critical > 0 && reflected[m] > 1 - 1e-9) continue;
        solid_angle += set.weights()[m];
        flux += set.weights()[m] * std::abs(set.directions()[m].dot(normal));
      }
      EXPECT_NEAR(solid_angle, 4 * pi * (1 - critical), 1e-9) << name;
      EXPECT_NEAR(flux, 2 * pi * (1 - critical * critical), 1e-9) << name;
    }
  });
}

TEST(RefractionWeights, KeepDirectionsSecondMomentsAndMirrorImages) {
  for_fitted_sets([](const DirectionSet& before, const DirectionSet& set, const std::vector<Vec3>& normals,
                     double, const std::string& name) {
    ASSERT_EQ(set.count(), before.count());
    for (int m = 0; m < set.count(); ++m) {
      ASSERT_EQ(set.direction(OrdinateIndex(m)), before.direction(OrdinateIndex(m))) << name;
      EXPECT_GT(set.weight(OrdinateIndex(m)), 0.19 * before.weight(OrdinateIndex(m))) << name;
      for (const Vec3& normal : normals) ASSERT_GE(set.mirrored(OrdinateIndex(m), normal), 0) << name;
      for (int axis = 0; axis < 3; ++axis)
        ASSERT_GE(set.mirrored(OrdinateIndex(m), Vec3::Unit(axis)), 0) << name;
    }
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j)
        EXPECT_NEAR(moment(set, [&](const Vec3& w) { return w[i] * w[j]; }), i == j ? 4 * pi / 3 : 0, 1e-10)
            << name;
  });
}

TEST(RefractionWeights, StayWhereNothingRefractsOrTooFewDirectionsDo) {
  const DirectionSet set = directions_product(4);
  for (const std::vector<SmoothPlane>& planes :
       {std::vector<SmoothPlane>(), planes_of({Vec3::UnitX()}, 1), planes_of({Vec3::UnitZ()}, 2),
        planes_of({Vec3(0.6, 0.8, 0)}, 1.5)})
    EXPECT_TRUE(std::ranges::equal(fitted_to_refraction(set, planes).weights(), set.weights()));
}

TEST(RefractionWeights, PartAtTheCriticalAngle) {
  const SmoothPlane glass{Vec3::UnitZ(), 1.5};
  const DirectionSet fine = directions_product(16), coarse = directions_product(4);
  EXPECT_FALSE(parts_at_critical_angle(fine, glass));
  EXPECT_TRUE(parts_at_critical_angle(fitted_to_refraction(fine, std::vector{glass}), glass));
  EXPECT_FALSE(parts_at_critical_angle(fitted_to_refraction(coarse, std::vector{glass}), glass));
  EXPECT_TRUE(parts_at_critical_angle(coarse, {Vec3::UnitZ(), 0.75}));
}

// Rotated by a right angle the set is the same, and so are its weights for walls that turn with it.
TEST(RefractionWeights, TurnWithTheSet) {
  const DirectionSet set = directions_product(8);
  Rotation turn;
  turn << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  const Vec3 normal = Vec3::UnitX();
  const DirectionSet fitted = fitted_to_refraction(set, planes_of({normal}, 1.5));
  const DirectionSet turned = fitted_to_refraction(rotated(set, turn), planes_of({turn * normal}, 1.5));
  for (int power = 1; power <= 4; ++power)
    EXPECT_NEAR(
        moment(fitted, [&](const Vec3& w) { return std::pow(std::abs(w.dot(normal)), power); }),
        moment(turned, [&](const Vec3& w) { return std::pow(std::abs(w.dot(turn * normal)), power); }), 1e-9);
}

// Of isotropic light the flux of the sphere passes, whatever the set; between 0 and all of each ordinate.
TEST(OrdinateReflectance, PassesTheFluxOfIsotropicLightOnEverySet) {
  for (const DirectionSet& set : sets_to_test())
    for (const double index : {0.5, 0.75, 1.1, 1.5, 2.5}) {
      const Vec3 normal = Vec3(0.3, -0.5, 0.8).normalized();
      for (const Vec3& n : {Vec3(Vec3::UnitZ()), Vec3(Vec3::UnitX()), normal}) {
        const std::vector<double> reflected = ordinate_reflectances(set, refracting(index), n);
        double passed = 0;
        for (std::size_t m = 0; m < reflected.size(); ++m) {
          EXPECT_GE(reflected[m], 0);
          EXPECT_LE(reflected[m], 1);
          EXPECT_EQ(reflected[m], reflected[m ^ 1]);
          passed += set.weights()[m] * (1 - reflected[m]) * std::abs(set.directions()[m].dot(n)) / 2;
        }
        EXPECT_NEAR(passed / set.half_range(n), 1 - mirrored_part_of_isotropic(refracting(index), 0), 1e-12)
            << label(set) << " " << index;
      }
    }
}

// Light from outside and, since the surfaces are reciprocal, the light of a slab that emits itself: it leaves
// with the part that a slab of no scattering absorbs (Kirchhoff).
TEST(OrdinateReflectance, FindsWhatASlabAbsorbsAndLetsThrough) {
  for (const DirectionSet& set : {directions_product(16), directions_double_gauss(8), directions_ldfe_sq(2)})
    for (const std::vector<Vec3>& normals : normals_to_test())
      for (const double index : {1.33, 1.5, 2.0}) {
        const DirectionSet fitted = fitted_to_refraction(set, planes_of(normals, index));
        for (const double thickness : {0.1, 1.0, 5.0}) {
          const SlabPowers exact = exact_slab(index, thickness);
          const SlabPowers found = discrete_slab(fitted, normals.front(), index, thickness);
          const double inflow = exact.absorbed + exact.outflow;
          EXPECT_NEAR(found.absorbed / exact.absorbed, 1, 5e-3)
              << label(set) << ", index " << index << ", thickness " << thickness;
          EXPECT_NEAR(found.outflow, exact.outflow, 5e-3 * inflow)
              << label(set) << ", index " << index << ", thickness " << thickness;
        }
      }
}

TEST(PolarLevels, AreTheDirectionsOfOneAngle) {
  const PolarLevels levels(directions_product(8), Vec3::UnitZ());
  ASSERT_EQ(levels.levels().size(), 4u);
  double sum = 0;
  for (const PolarLevel& level : levels.levels()) sum += level.weight;
  EXPECT_NEAR(sum, 4 * pi, 1e-12);
  EXPECT_GT(levels.levels().front().cosine, levels.levels().back().cosine);
}

}  // namespace
}  // namespace etendue::refraction_weights_test
