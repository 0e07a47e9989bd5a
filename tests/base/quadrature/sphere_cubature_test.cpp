// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/quadrature/sphere_cubature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace etendue::sphere_cubature_test {
namespace {

using std::numbers::pi;

const Vec3 oblique = Vec3(0.3, -0.5, 0.7).normalized();

/// A function and its first moment about an oblique axis.
PairOnSphere of_cosine(double (*f)(double)) {
  return [f](const Vec3& w) -> std::array<double, 2> {
    const double value = f(oblique.dot(w));
    return {value, value * (1 - oblique.dot(w))};
  };
}

TEST(SphereCubature, IsExactForPolynomials) {
  const SphereIntegrals found = integrate_over_sphere(of_cosine([](double c) { return c * c; }), {}, 1e-10);
  EXPECT_NEAR(found.values[0], 4 * pi / 3, 1e-12);
  EXPECT_NEAR(found.values[1], 4 * pi / 3, 1e-12);
  EXPECT_LT(found.errors[0], 1e-9);
}

TEST(SphereCubature, SaysHowFarKinksAndStepsMayBeOff) {
  const SphereIntegrals kink =
      integrate_over_sphere(of_cosine([](double c) { return std::max(0.0, c); }), {}, 1e-12);
  EXPECT_LT(std::abs(kink.values[0] - pi), kink.errors[0]);
  EXPECT_LT(std::abs(kink.values[1] - (pi - 2 * pi / 3)), kink.errors[1]);
  EXPECT_LT(kink.errors[0], 1e-4 * pi);
  const SphereIntegrals step =
      integrate_over_sphere(of_cosine([](double c) { return c > 0.2 ? 1.0 : 0.0; }), {}, 1e-12);
  EXPECT_LT(std::abs(step.values[0] - 2 * pi * 0.8), step.errors[0]);
  EXPECT_LT(step.errors[0], 0.05);
}

TEST(SphereCubature, FindsAPeakWhereItIsSuspected) {
  const auto peak = of_cosine([](double c) { return std::exp(-1e4 * (1 - c)); });
  EXPECT_NEAR(integrate_over_sphere(peak, {oblique}, 1e-9).values[0], 2 * pi / 1e4, 1e-12);
}

}  // namespace
}  // namespace etendue::sphere_cubature_test
