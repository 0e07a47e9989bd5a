// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/closed_form/solid_angle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "solver/uncollided/rays/attenuation.h"

namespace etendue::solid_angle_test {
namespace {

using std::numbers::pi;

std::array<Vec3, 4> seen_from(const Vec3& eye) {
  return {Vec3(0, 0, 0) - eye, Vec3(1, 0.1, 0) - eye, Vec3(0.2, 0.9, -0.1) - eye, Vec3(0.3, 0.2, 0.8) - eye};
}

/// The volume of the tetrahedron as the integral of r^2 over its wedges.
double volume_from(const Vec3& eye) {
  double volume = 0;
  std::vector<SolidAnglePoint> points;
  for (const Wedge& wedge : wedges_of(seen_from(eye))) {
    points.clear();
    append_points(wedge.directions, 0.1, TriangleRule::seven_points, points);
    for (const SolidAnglePoint& point : points) {
      const double in = wedge.distance_in(point.direction), out = wedge.distance_out(point.direction);
      EXPECT_GE(out, in - 1e-12);
      volume += point.weight * (out * out * out - in * in * in) / 3;
    }
  }
  return volume;
}

double true_volume() {
  const auto v = seen_from(Vec3::Zero());
  return std::abs((v[1] - v[0]).cross(v[2] - v[0]).dot(v[3] - v[0])) / 6;
}

TEST(Wedges, FillTheTetrahedronFromOutside) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-2, 2);
  for (int i = 0; i < 200; ++i)
    EXPECT_NEAR(volume_from({coordinate(random), coordinate(random), coordinate(random)}), true_volume(),
                2e-6);
}

TEST(Wedges, FillTheTetrahedronFromItsVerticesEdgesAndFaces) {
  const auto v = seen_from(Vec3::Zero());
  for (const Vec3& eye : {v[0], v[3], Vec3((v[0] + v[1]) / 2), Vec3((v[1] + v[2] + v[3]) / 3),
                          Vec3((v[0] + v[1] + v[2] + v[3]) / 4), Vec3(2 * v[1] - v[0])})
    EXPECT_NEAR(volume_from(eye), true_volume(), 1e-6);
}

TEST(SolidAngle, OfAnOctantIsHalfPi) {
  std::vector<SolidAnglePoint> points;
  append_points({Vec3::UnitX(), 3 * Vec3::UnitY(), Vec3::UnitZ()}, 0.35, TriangleRule::seven_points, points);
  double sum = 0;
  for (const SolidAnglePoint& point : points) sum += point.weight;
  EXPECT_NEAR(sum, pi / 2, 1e-6);
}

// The origin lies in such triangles, so a part of them around it stays as wide however often it is cut.
TEST(SolidAngle, OfTrianglesThatHoldTheOriginIsRefused) {
  const double half = 0.5, root = std::sqrt(0.75);
  for (const SphericalTriangle& triangle :
       {SphericalTriangle{Vec3(1, 0, 0), Vec3(-half, root, 0), Vec3(-half, -root, 0)},
        SphericalTriangle{Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0)}}) {
    std::vector<SphericalTriangle> parts;
    EXPECT_THROW(append_parts(triangle, 0.35, parts), std::runtime_error);
  }
}

// Simpson's rule with many intervals.
TEST(AttenuationIntegrals, IsTheIntegralAlongIt) {
  for (const double extinction : {0.0, 1e-3, 0.039, 0.041, 1.0, 30.0}) {
    const double length = 0.5;
    double constant = 0, linear = 0;
    const int n = 20000;
    for (int i = 0; i <= n; ++i) {
      const double x = length * i / n, weight = (i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2) * length / n / 3;
      constant += weight * std::exp(-extinction * x);
      linear += weight * x * std::exp(-extinction * x);
    }
    EXPECT_NEAR(attenuation_integrals(extinction, length).constant, constant, 1e-11 * constant);
    EXPECT_NEAR(attenuation_integrals(extinction, length).linear, linear, 1e-10 * linear);
  }
}

}  // namespace
}  // namespace etendue::solid_angle_test
