// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/quadrature/cell_rule.h"
#include "base/quadrature/collapsed_rule.h"
#include "solver/uncollided/closed_form/exponential_integrals.h"

namespace etendue::collapsed_rule_test {
namespace {

// E_2(x) = e^-x - x E_1(x), of which rounding leaves little where x is large; there it lies between
// e^-x / (x + 2) and e^-x / (x + 1) (Abramowitz and Stegun 1964, eq. 5.1.19).
TEST(ExponentialIntegrals, AreThoseOfTheStandardLibrary) {
  double farthest = 0;
  for (double x = 1e-12; x < 20; x *= 1.05) {
    Eight arguments;
    for (Eigen::Index i = 0; i < 8; ++i) arguments[i] = x * (1 + 0.3 * static_cast<double>(i));
    const auto [first, second, third] = exponential_integrals(arguments);
    for (Eigen::Index i = 0; i < 8; ++i) {
      const double y = arguments[i], left = std::exp(-y);
      if (y < 10) {
        farthest = std::max(farthest, std::abs(first[i] / -std::expint(-y) - 1));
        farthest = std::max(farthest, std::abs(second[i] / left - (1 + y * std::expint(-y) / left)));
      }
      EXPECT_GE(second[i], left / (y + 2) * (1 - 1e-12)) << y;
      EXPECT_LE(second[i], left / (y + 1) * (1 + 1e-12)) << y;
      EXPECT_NEAR(third[i] / left, (1 - y * second[i] / left) / 2, 1e-12) << y;
    }
  }
  EXPECT_LT(farthest, 1e-11);
}

TEST(ExponentialIntegrals, AreOnesOverNMinusOneAtZeroAndNothingInTheThick) {
  const auto [first, second, third] = exponential_integrals(Eight::Zero());
  EXPECT_TRUE(std::isfinite(first[0]));
  EXPECT_EQ(second[0], 1);
  EXPECT_EQ(third[0], 0.5);
  const auto thick = exponential_integrals(Eight::Constant(1e9));
  EXPECT_LT(thick.second[0], 1e-300);
  EXPECT_GE(thick.third[0], 0);
}

/// Integral of the product of powers of barycentric coordinates over a simplex of measure 1.
template <std::size_t corners>
double product(const std::array<std::size_t, corners>& powers) {
  const std::size_t degree = std::accumulate(powers.begin(), powers.end(), std::size_t{0});
  double value = std::tgamma(corners) / std::tgamma(corners + degree);
  for (const std::size_t n : powers) value *= std::tgamma(n + 1);
  return value;
}

template <std::size_t corners>
double by_rule(const SteepCorners<corners>& steep, const std::array<std::size_t, corners>& powers) {
  double sum = 0;
  for (const auto& point : collapsed_rule(steep)) {
    double value = point.weight;
    for (std::size_t i = 0; i < corners; ++i) value *= std::pow(point.barycentric[i], powers[i]);
    sum += value;
  }
  return sum;
}

template <std::size_t corners>
void expect_exact_to_degree_two() {
  constexpr std::size_t sets = std::size_t{1} << corners;
  for (std::size_t surface = 0; surface < sets; ++surface)
    for (std::size_t rim = 0; rim < sets; ++rim) {
      const SteepCorners<corners> steep{surface, rim};
      const auto near = rim > 0 ? rim : surface;
      if (near == 0 || near == sets - 1) {
        EXPECT_TRUE(collapsed_rule(steep).empty());
        continue;
      }
      for (const auto& point : collapsed_rule(steep)) {
        EXPECT_GT(point.weight, 0);
        for (const double coordinate : point.barycentric) EXPECT_GE(coordinate, 0);
      }
      for (std::size_t i = 0; i < corners; ++i)
        for (std::size_t k = 0; k < corners; ++k) {
          std::array<std::size_t, corners> powers{};
          ++powers[i];
          EXPECT_NEAR(by_rule(steep, powers), product(powers), 1e-14) << surface << " " << rim;
          ++powers[k];
          EXPECT_NEAR(by_rule(steep, powers), product(powers), 1e-14) << surface << " " << rim;
        }
    }
}

TEST(CollapsedRule, IsExactToDegreeTwoTowardsAnyCorners) {
  expect_exact_to_degree_two<3>();
  expect_exact_to_degree_two<4>();
}

// Above a face that shines: the integral of h log h over a tetrahedron of volume and height 1, with
// 3 (1 - h)^2 dh, is -13/48.
TEST(CollapsedRule, SeesALogarithmAboveAFace) {
  const auto by = [](const auto& rule) {
    double sum = 0;
    for (const auto& point : rule)
      sum += point.weight * point.barycentric[3] * std::log(point.barycentric[3]);
    return sum;
  };
  EXPECT_NEAR(by(collapsed_rule<4>({0b0111, 0})), -13. / 48, 5e-6);
  EXPECT_GT(std::abs(by(cell_rule()) + 13. / 48), 2e-4);
}

// Beside an edge at the rim light depends on the angle about it, steeply beside the surface: here like the
// root of u = z / (y + z), which is uniform between 0 and 1.
TEST(CollapsedRule, SeesTheAngleAboutAnEdge) {
  double sum = 0;
  for (const auto& point : collapsed_rule<4>({0b0111, 0b0011})) {
    const double y = point.barycentric[2], z = point.barycentric[3];
    sum += point.weight * std::sqrt(z / (y + z));
  }
  EXPECT_NEAR(sum, 2. / 3, 1e-7);
}

}  // namespace
}  // namespace etendue::collapsed_rule_test
