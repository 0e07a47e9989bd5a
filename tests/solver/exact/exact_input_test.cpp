// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/exact/exact_input.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/quadrature/cell_rule.h"
#include "solver/exact/exact_balance.h"
#include "solver/exact/exact_comparison.h"
#include "solver/transport/solve/solve.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::exact_input_test {
namespace {

const char* const linear = "3 + wx + (0.3 + wx)*x + (wy*wz - 0.7)*y + (1.1 + wz)*z";

Problem scattering_problem(const TetrahedralMesh& mesh, int bands = 1) {
  return uniform_problem(mesh, uniform_medium(bands, 0.2, 1.5, 0, PhaseHenyeyGreenstein{0.5}),
                         uniform_wall(bands, 0, 0, 0));
}

Solution solved(const Problem& problem, const DirectionSet& directions, const ExactInput& input,
                SpaceOrder order = SpaceOrder::linear) {
  SolveOptions options = tight_options();
  options.tolerance = 1e-13;
  options.order = order;
  options.angular_input = &input;
  return solve(problem, directions, options);
}

TEST(ExactInput, MakesALinearRadianceTheSolutionToRounding) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = scattering_problem(mesh, 2);
  const ExactRadiance radiance(linear);
  for (const DirectionSet& directions : {directions_product(4), directions_ldfe_sq(1)}) {
    const ExactInput input(problem, directions, radiance);
    const Solution solution = solved(problem, directions, input);
    ASSERT_TRUE(solution.converged());
    const auto errors = compare_with_exact(problem, solution, radiance, directions).fluence;
    ASSERT_EQ(errors.size(), 2U);
    for (const FluenceError& error : errors) {
      EXPECT_LT(error.l2, 1e-11);
      EXPECT_LT(error.linf, 1e-11);
    }
  }
}

TEST(ExactInput, GivesTheSourceOfAPureAbsorber) {
  // The source of this radiance is quadratic in space, so its projection has its moments exactly.
  const TetrahedralMesh mesh = cube_mesh(0.1);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.5, 0, 0), uniform_wall(1, 0, 0, 0));
  const DirectionSet directions = directions_product(2);
  const ExactInput input(problem, directions, ExactRadiance("(2 + x*y)*(2 + wz)"));
  const OrdinateIndex m(3);
  const Vec3& w = directions.direction(m);
  const CellIndex cell(0);
  std::vector<double> values(4, 7);  // what is there is added to
  input.add_source(m, cell, values);
  std::array<Vec3, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i] = mesh.point(VertexIndex(mesh.vertices(cell)[i]));
  std::array<double, 4> left{};
  for (const CellRulePoint& node : cell_rule()) {
    const Vec3 p = point_at(node.barycentric, corners);
    double difference = (w.x() * p.y() + w.y() * p.x() + 0.5 * (2 + p.x() * p.y())) * (2 + w.z());
    for (std::size_t i = 0; i < 4; ++i) difference -= node.barycentric[i] * (values[i] - 7);
    for (std::size_t i = 0; i < 4; ++i) left[i] += node.weight * node.barycentric[i] * difference;
  }
  for (const double part : left) EXPECT_NEAR(part, 0, 1e-13);
}

TEST(ExactInput, ClosesTheBalanceWithWhatItBrings) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = scattering_problem(mesh);
  const DirectionSet directions = directions_product(4);
  const ExactRadiance radiance("3 + sin(2*x)*wy");
  const ExactInput input(problem, directions, radiance);
  const Solution solution = solved(problem, directions, input);
  auto regions = region_powers(problem, solution);
  auto powers = balances(problem, solution);
  add_exact_powers(input, wall_powers(problem, solution), regions, powers);
  EXPECT_GT(powers[0].inflow, 1);
  EXPECT_LT(std::abs(powers[0].residual), 1e-11);
  EXPECT_EQ(regions[0][0].emitted, powers[0].emitted);
}

TEST(ExactInput, RefusesARadianceThatIsNotFinite) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  const Problem problem = scattering_problem(mesh);
  const DirectionSet directions = directions_product(2);
  EXPECT_THROW(ExactInput(problem, directions, ExactRadiance("1/x")), InputError);
  EXPECT_THROW(ExactInput(problem, directions, ExactRadiance("sqrt(x)")), InputError);
}

TEST(ExactComparison, KnowsWhatIsAbsorbedAndWhatArrives) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = scattering_problem(mesh);
  const DirectionSet directions = directions_product(4);
  const ExactRadiance radiance(linear);
  const ExactInput input(problem, directions, radiance);
  const Solution solution = solved(problem, directions, input);
  const ExactComparison exact = compare_with_exact(problem, solution, radiance, directions);
  EXPECT_NEAR(region_powers(problem, solution)[0][0].absorbed, exact.absorbed[0][0], 1e-11);
  const auto walls = wall_powers(problem, solution);
  ASSERT_EQ(exact.incoming.size(), walls.size());
  for (std::size_t w = 0; w < walls.size(); ++w) EXPECT_NEAR(walls[w][0].incoming, exact.incoming[w], 1e-11);
}

TEST(ExactComparison, MeasuresRelativeToTheNormOfTheExact) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  const Problem problem = scattering_problem(mesh);
  const DirectionSet directions = directions_product(2);
  Solution solution;
  solution.fluence.assign(static_cast<std::size_t>(mesh.cell_count()) * 4, 1.1 * 8 * std::acos(-1.0));
  const ExactComparison exact = compare_with_exact(problem, solution, ExactRadiance("2"), directions);
  EXPECT_NEAR(exact.fluence[0].l2, 0.1, 1e-12);
  EXPECT_NEAR(exact.fluence[0].linf, 0.1, 1e-12);
}

}  // namespace
}  // namespace etendue::exact_input_test
