// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/solve/radiosity_equation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/radiosity/exchange/exchange_matrix.h"
#include "solver/radiosity/exchange/factor_checks.h"
#include "tests/solver/radiosity/reference_shapes.h"

namespace etendue::radiosity_equation_test {
namespace {

/// The upper half shines and reflects 0.8, the lower reflects 0.3.
RadiosityEquation half_and_half(const Exchange& exchange) {
  RadiosityEquation equation{exchange, 1, {}, {}};
  for (const FlatPatch& patch : exchange.patches()) {
    const bool upper = patch.centroid()[2] > 0;
    equation.emission.push_back(upper ? 2 : 0);
    equation.reflectance.push_back(upper ? 0.8 : 0.3);
  }
  return equation;
}

double total_area(const std::vector<FlatPatch>& patches) {
  double area = 0;
  for (const FlatPatch& patch : patches) area += patch.area();
  return area;
}

/// In a sphere each patch sends to each in proportion to its area: F_jk = A_k / A.
ExchangeMatrix exact_sphere(const std::vector<FlatPatch>& patches) {
  std::vector<double> values;
  const double area = total_area(patches);
  for (const FlatPatch& j : patches)
    for (const FlatPatch& k : patches) values.push_back(j.area() * k.area() / area);
  return {patches, std::move(values)};
}

// With mean emission 1 and mean reflectance 0.55 pass n brings 0.55^(n-1) to every patch.
TEST(RadiosityEquation, GatheringNTimesIsTheSeriesOfNBouncesInASphere) {
  const std::vector<FlatPatch> patches = sphere_patches(3);
  const ExchangeMatrix exchange = exact_sphere(patches);
  const RadiosityState state =
      solve_by_gathering(half_and_half(exchange), {1e-10, 100}, [&](const RadiosityState& now) {
        const double n = now.passes;
        EXPECT_EQ(now.irradiance.size(), patches.size());
        for (const double irradiance : now.irradiance)
          EXPECT_NEAR(irradiance, (1 - std::pow(0.55, n)) / (1 - 0.55), 1e-13) << n;
        const Bounce& bounce = now.bounces.back();
        EXPECT_NEAR(bounce.incident, total_area(patches) * std::pow(0.55, n - 1), 1e-12);
        EXPECT_NEAR(bounce.deposit, 0.45 * bounce.incident, 1e-12);
        return true;
      });
  EXPECT_TRUE(state.converged);
  EXPECT_NEAR(state.passes, std::log(1e-10) / std::log(0.55), 2);
}

TEST(RadiosityEquation, AllThreeSolutionsAreTheSame) {
  const std::vector<FlatPatch> patches = sphere_patches(2);
  ExchangeMatrix exchange(patches, 1, 1);
  const FactorChecks checks = check_and_close(exchange, 1e-13);
  EXPECT_LT(checks.closed_row_sum, 1e-12);
  const RadiosityEquation equation = half_and_half(exchange);
  const RadiosityState direct = solve_directly(equation);
  const RadiosityState gathered = solve_by_gathering(equation, {1e-12, 200});
  const RadiosityState shot = solve_by_shooting(equation, {1e-12, 200});
  EXPECT_TRUE(gathered.converged);
  EXPECT_TRUE(shot.converged);
  for (std::size_t j = 0; j < patches.size(); ++j) {
    EXPECT_NEAR(gathered.irradiance[j], direct.irradiance[j], 1e-10);
    EXPECT_NEAR(shot.irradiance[j], direct.irradiance[j], 1e-10);
  }
}

TEST(RadiosityEquation, AMatrixThatIsNotKeptGivesTheSame) {
  const std::vector<FlatPatch> patches = sphere_patches(1);
  const ExchangeMatrix kept(patches, 1, 1), anew(patches, 1, 2, 0);
  EXPECT_FALSE(anew.is_kept());
  EXPECT_EQ(solve_by_gathering(half_and_half(kept), {1e-6, 50}).irradiance,
            solve_by_gathering(half_and_half(anew), {1e-6, 50}).irradiance);
}

// Closing makes rows sum to one and keeps A_j F_jk = A_k F_kj.
TEST(ExchangeMatrix, ClosingKeepsReciprocity) {
  const std::vector<FlatPatch> patches = sphere_patches(2);
  std::vector<double> values;
  for (std::size_t j = 0; j < patches.size(); ++j)
    for (std::size_t k = 0; k < patches.size(); ++k)
      values.push_back(j == k ? 0 : 0.1 + 0.05 * std::cos(static_cast<double>(j * k)));
  ExchangeMatrix exchange(patches, values);
  EXPECT_GT(exchange.row_sums().largest, 0.1);
  exchange.close(1e-13);
  EXPECT_LT(exchange.row_sums().largest, 1e-12);
  for (std::size_t j = 0; j < patches.size(); ++j)
    for (std::size_t k = 0; k < patches.size(); ++k)
      EXPECT_NEAR(exchange.value(j, k), exchange.value(k, j), 1e-16);
}

}  // namespace
}  // namespace etendue::radiosity_equation_test
