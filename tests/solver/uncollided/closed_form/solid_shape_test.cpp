// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/closed_form/solid_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/quadrature/gauss_legendre.h"

namespace etendue::solid_shape_test {
namespace {

using std::numbers::pi;

using Tetrahedra = std::vector<std::array<Vec3, 4>>;

/// Five tetrahedra.
Tetrahedra box(const Vec3& low, const Vec3& high) {
  const auto corner = [&](int x, int y, int z) {
    return Vec3(x == 0 ? low.x() : high.x(), y == 0 ? low.y() : high.y(), z == 0 ? low.z() : high.z());
  };
  const Vec3 a = corner(0, 0, 0), b = corner(1, 1, 0), c = corner(1, 0, 1), d = corner(0, 1, 1);
  return {{a, b, c, d},
          {corner(1, 0, 0), a, b, c},
          {corner(0, 1, 0), a, b, d},
          {corner(0, 0, 1), a, c, d},
          {corner(1, 1, 1), b, c, d}};
}

/// The integral over directions of what a ray finds in the box, by a fine product rule from an eye outside.
double by_points(const Vec3& low, const Vec3& high, const Vec3& eye, double extinction, Vec3& flux) {
  const GaussRule rule = gauss_legendre(24);
  const Vec3 half = (high - low) / 2, middle = (high + low) / 2;
  double fluence = 0;
  for (std::size_t i = 0; i < 24; ++i)
    for (std::size_t j = 0; j < 24; ++j)
      for (std::size_t k = 0; k < 24; ++k) {
        const Vec3 separation =
            middle + half.cwiseProduct(Vec3(rule.nodes[i], rule.nodes[j], rule.nodes[k])) - eye;
        const double r = separation.norm();
        const double part = rule.weights[i] * rule.weights[j] * rule.weights[k] * half.prod() *
                            std::exp(-extinction * r) / (r * r);
        fluence += part;
        flux -= part / r * separation;
      }
  return fluence;
}

TEST(SolidShape, BringsWhatItsPointsBring) {
  const Vec3 low(-0.2, 0.1, 0.3), high(0.5, 0.4, 0.9);
  const SolidShape shape(box(low, high));
  EXPECT_EQ(shape.face_count(), 6);
  EXPECT_EQ(shape.edge_count(), 12);
  for (const double extinction : {0.0, 1e-9, 1e-3, 0.7, 4.0, 30.0})
    for (const Vec3& eye : {Vec3(0, 0, -0.1), Vec3(1, 1, 1.4), Vec3(-1, 0.2, 0.5), Vec3(0.2, 3, 0.3)}) {
      Vec3 flux = Vec3::Zero();
      const double fluence = by_points(low, high, eye, extinction, flux);
      const SolidShape::View view = shape.from(eye, extinction);
      EXPECT_NEAR(view.fluence, fluence, 1e-10 + 3e-8 * fluence) << extinction;
      EXPECT_LT((view.flux - flux).norm(), 1e-10 + 3e-8 * flux.norm()) << extinction;
    }
}

// Balance: div F = emission - extinction times fluence, inside and outside, near a corner too.
TEST(SolidShape, LosesWhatMatterTakes) {
  const SolidShape shape(box({0, 0, 0}, {1, 0.8, 0.6}));
  const double step = 1e-3;
  for (const double extinction : {0.0, 0.5, 8.0})
    for (const Vec3& eye : {Vec3(0.5, 0.4, 0.3), Vec3(0.02, 0.03, 0.02), Vec3(0.97, 0.5, 0.1),
                            Vec3(-0.02, 0.3, 0.3), Vec3(1.03, 0.83, 0.64), Vec3(0.5, 0.4, 2)}) {
      double divergence = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const auto at = [&](int steps) {
          return shape.from(eye + steps * step * Vec3::Unit(axis), extinction).flux[axis];
        };
        divergence += (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * step);
      }
      const bool inside = (eye.array() > 0).all() && eye.x() < 1 && eye.y() < 0.8 && eye.z() < 0.6;
      const double lost = extinction * shape.from(eye, extinction).fluence;
      EXPECT_NEAR(divergence, (inside ? 4 * pi : 0) - lost, 1e-4) << extinction << " " << eye.transpose();
    }
}

// In the middle of an optically thick medium, and where the eye lies on a face, an edge or a corner of it.
TEST(SolidShape, FillsTheSphereOrAHalfOrAQuarterOfIt) {
  const SolidShape shape(box({0, 0, 0}, {1, 1, 1}));
  constexpr double extinction = 200;
  const auto filled = [&](const Vec3& eye) {
    return shape.from(eye, extinction).fluence * extinction / (4 * pi);
  };
  EXPECT_NEAR(filled({0.5, 0.5, 0.5}), 1, 1e-9);
  EXPECT_NEAR(filled({0.5, 0.5, 0}), 1. / 2, 1e-9);
  EXPECT_NEAR(filled({1, 0.5, 1}), 1. / 4, 1e-9);
  EXPECT_NEAR(filled({0, 1, 0}), 1. / 8, 1e-9);
  EXPECT_NEAR(filled({0, 1, 1e-15}), 1. / 8, 1e-9);
  EXPECT_NEAR(shape.from({0.5, 0.5, 1}, extinction).flux.z() * extinction, pi, 1e-8);
}

// A long face of one box borders on the shorter ones of two: edges that only one face has whole.
TEST(SolidShape, AddsUpItsParts) {
  const Tetrahedra low = box({0, 0, 0}, {2, 1, 1}), high = box({0, 0, 2}, {1, 1, 3});
  Tetrahedra both = low;
  both.insert(both.end(), high.begin(), high.end());
  const SolidShape shape(both), first(low), second(high);
  for (const Vec3& eye : {Vec3(0.5, 0.5, 1.5), Vec3(1.5, 0.4, 2.5), Vec3(-1, 3, 0)}) {
    const SolidShape::View sum = shape.from(eye, 1), a = first.from(eye, 1), b = second.from(eye, 1);
    EXPECT_NEAR(sum.fluence, a.fluence + b.fluence, 1e-9);
    EXPECT_LT((sum.flux - a.flux - b.flux).norm(), 1e-9);
  }
}

TEST(SolidShape, KnowsHowFarItsSurfaceIs) {
  const SolidShape shape(box({0, 0, 0}, {1, 2, 3}));
  EXPECT_NEAR(shape.distance_to_surface({0.3, 1, 1}), 0.3, 1e-12);
  EXPECT_NEAR(shape.distance_to_surface({0.5, 1, 3.2}), 0.2, 1e-12);
  EXPECT_NEAR(shape.distance_to_surface({1.3, 1, 3.4}), 0.5, 1e-12);
  EXPECT_NEAR(shape.distance_to_surface({0.2, 2, 1}), 0, 1e-12);
}

}  // namespace
}  // namespace etendue::solid_shape_test
