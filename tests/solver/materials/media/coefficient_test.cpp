// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/media/coefficient.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace etendue::coefficient_test {
namespace {

Coefficient formula(const std::string& text) { return Coefficient(Expression(text, {"x", "y", "z"})); }

const std::array<Vec3, 4> unit_tetrahedron = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};

/// Mean of x^i y^j z^k over the unit tetrahedron: 6 i! j! k! / (i + j + k + 3)!
double monomial_mean(int i, int j, int k) {
  return 6 * std::tgamma(i + 1) * std::tgamma(j + 1) * std::tgamma(k + 1) / std::tgamma(i + j + k + 4);
}

double measured_mean(int i, int j, int k) {
  const auto power = [](const char* name, int n) { return std::string(name) + "^" + std::to_string(n); };
  return formula(power("x", i) + "*" + power("y", j) + "*" + power("z", k)).cell_mean(unit_tetrahedron);
}

TEST(Coefficient, MeanIsExactForPolynomialsUpToDegreeFive) {
  for (int i = 0; i <= 5; ++i)
    for (int j = 0; i + j <= 5; ++j)
      for (int k = 0; i + j + k <= 5; ++k)
        EXPECT_NEAR(measured_mean(i, j, k), monomial_mean(i, j, k), 2e-16) << i << j << k;
  EXPECT_GT(std::abs(measured_mean(6, 0, 0) - monomial_mean(6, 0, 0)), 1e-6);
}

TEST(Coefficient, MeanFollowsTheCell) {
  const std::array<Vec3, 4> cell = {Vec3(1, 2, 3), Vec3(2, 2, 3.5), Vec3(1.2, 4, 3), Vec3(0.8, 2.5, 5)};
  const Vec3 center = (cell[0] + cell[1] + cell[2] + cell[3]) / 4;
  EXPECT_NEAR(formula("2*x - y + 3*z + 1").cell_mean(cell), 2 * center.x() - center.y() + 3 * center.z() + 1,
              1e-14);
  EXPECT_EQ(Coefficient(0.7).cell_mean(cell), 0.7);
}

TEST(Coefficient, MeanOfWhatIsNowhereNegativeIsNotNegative) {
  // A spike at the centroid, where Keast's 11-point rule has a negative weight.
  const Coefficient spike = formula("(x-0.25)^2 + (y-0.25)^2 + (z-0.25)^2 < 0.04 ? 1 : 0");
  EXPECT_GE(spike.cell_mean(unit_tetrahedron), 0);
}

TEST(Coefficient, SampleFindsTheSmallestValueAndItsPlace) {
  const CellSample sample = formula("x - 0.1").sample(unit_tetrahedron);
  EXPECT_LT(sample.smallest, 0);
  EXPECT_NEAR(sample.where.x() - 0.1, sample.smallest, 1e-16);
  EXPECT_NEAR(sample.mean, 0.15, 1e-15);
}

TEST(Coefficient, SampleShowsValuesThatAreNotFinite) {
  EXPECT_TRUE(std::isnan(formula("sqrt(x - 0.1)").sample(unit_tetrahedron).smallest));
  EXPECT_TRUE(std::isinf(formula("1/(x - x)").sample(unit_tetrahedron).smallest));
}

TEST(Coefficient, HasAValueAtEachPoint) {
  EXPECT_DOUBLE_EQ(formula("x + 10*y + 100*z").at(Vec3(1, 2, 3)), 321);
  EXPECT_TRUE(Coefficient(2.0).is_constant());
  EXPECT_FALSE(formula("2").is_constant());
}

TEST(Coefficient, SlopeIsThatOfALinearFormula) {
  const std::array<Vec3, 4> cell = {Vec3(1, 2, 3), Vec3(2, 2, 3.5), Vec3(1.2, 4, 3), Vec3(0.8, 2.5, 5)};
  const Coefficient linear = formula("2*x - y + 3*z + 1");
  const CellSample sample = linear.sample(cell);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(sample.mean + sample.slope[i], linear.at(cell[i]), 1e-13);
  EXPECT_EQ(Coefficient(0.7).sample(cell).slope, (std::array<double, 4>{}));
}

// The rest of the closest linear function is orthogonal to all of them.
TEST(Coefficient, SlopeIsThatOfTheClosestLinearFunction) {
  const Coefficient curved = formula("1 + x^2*y + z^3");
  const CellSample sample = curved.sample(unit_tetrahedron);
  std::array<double, 4> rest = {};
  for (const CellRulePoint& node : cell_rule()) {
    double linear = sample.mean;
    for (std::size_t i = 0; i < 4; ++i) linear += sample.slope[i] * node.barycentric[i];
    for (std::size_t i = 0; i < 4; ++i)
      rest[i] += node.weight * node.barycentric[i] *
                 (curved.at(point_at(node.barycentric, unit_tetrahedron)) - linear);
  }
  for (const double value : rest) EXPECT_NEAR(value, 0, 1e-15);
  EXPECT_NE(sample.slope[0], 0);
}

TEST(Coefficient, SlopeOfWhatIsNowhereNegativeReachesNoNegativeValue) {
  const CellSample sample = formula("x^8").sample(unit_tetrahedron);
  const auto [lowest, highest] = std::ranges::minmax(sample.slope);
  EXPECT_NEAR(sample.mean + lowest, 0, 1e-15);
  EXPECT_GT(highest, 0);
  EXPECT_NEAR(sample.slope[0] + sample.slope[1] + sample.slope[2] + sample.slope[3], 0, 1e-15);
}

}  // namespace
}  // namespace etendue::coefficient_test
