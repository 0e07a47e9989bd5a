// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/expression/differentiable.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/errors.h"
#include "base/expression/expression.h"

namespace etendue::differentiable_test {
namespace {

const std::vector<std::string> names = {"x", "y", "z"};

const std::vector<std::string> formulas = {
    "1",
    "x",
    "-x^2",
    "2^-x",
    "2^3^x",
    "x - y - z",
    "x/y/z*2",
    "-x*-y",
    "+x + +y",
    "3.5e-1*x + .5*y + 2.*z",
    "(x + y)*(y - z)",
    "x < y",
    "x <= y == 1",
    "x > 0.5 && y > 0.5 || z > 0.5",
    "x > 0.5 ? y : z > 1 ? x : x*y",
    "x > 5 ? y : 1 + (z > 1 ? x : x*y)",
    "(x > y) + (x >= y) + (x != y)",
    "sin(x) + cos(y) + tan(z)",
    "asin(x) + acos(x/2) + atan(y)",
    "sinh(x) + cosh(y) + tanh(z)",
    "asinh(x) + acosh(1 + y) + atanh(x)",
    "log2(y) + log10(z) + log(x) + ln(y)",
    "exp(-x*y) + sqrt(x + z)",
    "sign(x - 0.5) + rint(3*y) + abs(x - y)",
    "atan2(x, y) + atan2(-y, -z)",
    "sum(x, y, z) + avg(x, y, z*2)",
    "min(x, y, z) + 2*max(x, y, z)",
    "polynomial(x*y, 1, z, -2, 0.5*x)",
    "x^y + (x + 1)^3 + y^0.5 + z^2",
    "(x - 1)^3 + (x - 1)^-2",
    "pi*x + e^y",
    "3 + sin(2*x + 1)*cos(2*y - z)*(1 + 0.5*x + 0.3*y*z) + 0.5*cos(3*z)*x^2",
};

const std::vector<Vec3> points = {Vec3(0.3, 0.8, 1.7), Vec3(0.7, 0.6, 0.4), Vec3(0.51, 1.9, 0.05)};

Dual dual_at(const DifferentiableExpression& formula, const Vec3& p) {
  const std::array<Dual, 3> values = {Dual{p.x(), Vec3::UnitX()}, Dual{p.y(), Vec3::UnitY()},
                                      Dual{p.z(), Vec3::UnitZ()}};
  return formula(std::span<const Dual>(values));
}

double value_at(const DifferentiableExpression& formula, const Vec3& p) {
  return formula(std::span<const double>(p.data(), 3));
}

TEST(DifferentiableExpression, HasTheValuesOfMuParser) {
  for (const std::string& text : formulas) {
    const DifferentiableExpression formula(text, names);
    const Expression reference(text, names);
    for (const Vec3& p : points) {
      const double expected = reference(std::span<const double>(p.data(), 3));
      EXPECT_NEAR(value_at(formula, p), expected, 1e-13 * (1 + std::abs(expected))) << text;
      EXPECT_NEAR(dual_at(formula, p).value, expected, 1e-13 * (1 + std::abs(expected))) << text;
    }
  }
}

TEST(DifferentiableExpression, HasTheDerivativesThatDifferencesApproach) {
  for (const std::string& text : formulas) {
    const DifferentiableExpression formula(text, names);
    for (const Vec3& p : points) {
      const Vec3 gradient = dual_at(formula, p).gradient;
      for (int axis = 0; axis < 3; ++axis) {
        const Vec3 step = 1e-5 * Vec3::Unit(axis);
        const double difference = (value_at(formula, p + step) - value_at(formula, p - step)) / 2e-5;
        EXPECT_NEAR(gradient[axis], difference, 1e-7 * (1 + std::abs(difference))) << text;
      }
    }
  }
}

TEST(DifferentiableExpression, IsExactWhereDifferencesAreNot) {
  const DifferentiableExpression formula("exp(20*x)*sin(y) + x^3", names);
  const Vec3 gradient = dual_at(formula, Vec3(1, 2, 0)).gradient;
  EXPECT_DOUBLE_EQ(gradient.x(), 20 * std::exp(20.0) * std::sin(2.0) + 3);
  EXPECT_DOUBLE_EQ(gradient.y(), std::exp(20.0) * std::cos(2.0));
  EXPECT_EQ(gradient.z(), 0);
}

TEST(DifferentiableExpression, HasNoGradientWhereNothingVaries) {
  const DifferentiableExpression formula("sqrt(0) + x^0 + abs(0)", names);
  EXPECT_TRUE(dual_at(formula, Vec3::Zero()).gradient.isZero(0));
}

TEST(DifferentiableExpression, RefusesWhatIsNoFormula) {
  for (const char* text : {"x +", "sin(", "u", "x = 1", "x, y", "frobnicate(x)", ""})
    EXPECT_THROW(DifferentiableExpression(text, names), InputError) << text;
}

}  // namespace
}  // namespace etendue::differentiable_test
