// SPDX-License-Identifier: AGPL-3.0-or-later
//
// What the discretisation must reproduce exactly, and what lumping does.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/transport/solve/solve.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::discretisation_test {
namespace {

TEST(Patch, LinearRadianceIsReproducedToRounding) {
  const TetrahedralMesh mesh = cube_mesh(2e-3);
  const DirectionSet directions = directions_triangular(4);
  const Vec3 slope(0.3, -0.7, 1.1);
  // Linear in space, different in every direction, through absorption and void alike.
  const auto radiance = [&](const Vec3& x, const Vec3& w) { return 3 + w.x() + (slope + w).dot(x); };
  for (const double absorption : {0.0, 0.1, 5.0}) {
    const Problem problem =
        uniform_problem(mesh, uniform_medium(1, absorption, 0, 0), uniform_wall(1, 0, 0, 0));
    const ManufacturedInput input(mesh, directions, 1, radiance, [&](const Vec3& x, const Vec3& w) {
      return w.dot(slope + w) + absorption * radiance(x, w);
    });
    SolveOptions options = tight_options();
    options.angular_input = &input;
    options.keep_ordinates = {0, 7};
    const Solution solution = solve(problem, directions, options);
    ASSERT_EQ(solution.radiance.size(), options.keep_ordinates.size());
    ASSERT_GT(mesh.cell_count(), 100);
    for (const OrdinateRadiance& kept : solution.radiance)
      for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
        for (std::size_t i = 0; i < 4; ++i) {
          const Vec3& x = mesh.point(VertexIndex(mesh.vertices(CellIndex(c))[i]));
          const double expected = radiance(x, directions.direction(OrdinateIndex(kept.ordinate)));
          EXPECT_NEAR(kept.values[static_cast<std::size_t>(4 * c) + i], expected, 1e-12);
        }
    EXPECT_LT(fluence_error(mesh, solution, 1, exact_fluence(directions, radiance)), 1e-13);
  }
}

TEST(Patch, LinearFluenceSurvivesScattering) {
  // A radiance 1 + s.x, the same in all directions: scattering gives back what it takes.
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const DirectionSet directions = directions_ldfe_sq(1);
  const Vec3 slope(0.5, 0.2, -0.1);
  const auto radiance = [&](const Vec3& x, const Vec3&) { return 1 + slope.dot(x); };
  const double absorption = 0.2, scattering = 1.5;
  const Problem problem =
      uniform_problem(mesh, uniform_medium(1, absorption, scattering, 0, PhaseHenyeyGreenstein{0.5}),
                      uniform_wall(1, 0, 0, 0));
  const ManufacturedInput input(mesh, directions, 1, radiance, [&](const Vec3& x, const Vec3& w) {
    return w.dot(slope) + absorption * radiance(x, w);
  });
  SolveOptions options = tight_options();
  options.angular_input = &input;
  const Solution solution = solve(problem, directions, options);
  ASSERT_TRUE(solution.converged());
  EXPECT_LT(fluence_error(mesh, solution, 1, exact_fluence(directions, radiance)), 1e-11);
}

TEST(Patch, LinearEmissionIsLinearWithinCells) {
  // The radiance of a blackbody a + s.x, the same in all directions, needs only w.s beside emission.
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const DirectionSet directions = directions_ldfe_sq(1);
  const Vec3 slope(0.5, 0.2, -0.1);
  const auto radiance = [&](const Vec3& x, const Vec3&) { return 1 + slope.dot(x); };
  const Coefficient blackbody(Expression("1 + 0.5*x + 0.2*y - 0.1*z", {"x", "y", "z"}));
  for (const double absorption : {0.3, 40.0})
    for (const Lumping lumping : {Lumping::none, Lumping::mass}) {
      Medium medium = uniform_medium(1, absorption, 0.5, 0);
      medium.blackbody = {blackbody};
      const Problem problem = uniform_problem(mesh, medium, uniform_wall(1, 0, 0, 0));
      const ManufacturedInput input(mesh, directions, 1, radiance,
                                    [&](const Vec3&, const Vec3& w) { return w.dot(slope); });
      SolveOptions options = tight_options(lumping);
      options.angular_input = &input;
      const Solution solution = solve(problem, directions, options);
      ASSERT_TRUE(solution.converged());
      EXPECT_LT(fluence_error(mesh, solution, 1, exact_fluence(directions, radiance)), 1e-11)
          << absorption << ", lumping " << static_cast<int>(lumping);
    }
}

TEST(Patch, ConstantRadianceIsReproducedByConstants) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.7, 0, 0.7 * 2), uniform_wall(1, 2, 0, 0));
  SolveOptions options = tight_options();
  options.order = SpaceOrder::constant;
  const Solution solution = solve(problem, directions_triangular(4), options);
  EXPECT_LT(largest_deviation(solution.fluence, 4 * std::numbers::pi * 2), 1e-12);
}

TEST(Lumping, KeepsTheOrderNearTwoAndRaisesTheMinimum) {
  const TetrahedralMesh mesh = cube_mesh(2e-3);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 100, 0, 0), uniform_wall(1, 1, 0, 0));
  const auto smallest = [&](Lumping lumping) {
    const Solution solution = solve(problem, directions_triangular(4), tight_options(lumping));
    return *std::min_element(solution.fluence.begin(), solution.fluence.end());
  };
  const double consistent = smallest(Lumping::none);
  EXPECT_LT(consistent, -0.5);
  EXPECT_GT(smallest(Lumping::mass), 0.05 * consistent);
  EXPECT_EQ(smallest(Lumping::automatic), smallest(Lumping::mass));
}

}  // namespace
}  // namespace etendue::discretisation_test
