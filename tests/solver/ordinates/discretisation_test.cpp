// SPDX-License-Identifier: AGPL-3.0-or-later
//
// What the discretisation must reproduce: exactly where the solution is in the space, at its order elsewhere.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/ordinates/solve.h"
#include "tests/solver/ordinates/sample_problems.h"

namespace etendue {
namespace {

/// Fluence of a radiance that is known at every point and direction.
std::function<double(const Vec3&)> exact_fluence(const DirectionSet& directions,
                                                 const ManufacturedInput::Field& radiance) {
  return [&directions, radiance](const Vec3& point) {
    double sum = 0;
    for (std::int32_t m = 0; m < directions.count(); ++m)
      sum += directions.weight(OrdinateIndex(m)) * radiance(point, directions.direction(OrdinateIndex(m)));
    return sum;
  };
}

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

TEST(Patch, ConstantRadianceIsReproducedByConstants) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.7, 0, 0.7 * 2), uniform_wall(1, 2, 0, 0));
  SolveOptions options = tight_options();
  options.order = SpaceOrder::constant;
  const Solution solution = solve(problem, directions_triangular(4), options);
  EXPECT_LT(largest_deviation(solution.fluence, 4 * std::numbers::pi * 2), 1e-12);
}

/// Errors for u = exp(-sigma w.x), which a pure absorber carries exactly, on finer and finer meshes.
std::vector<std::pair<double, double>> absorber_errors(SpaceOrder order) {
  const DirectionSet directions = directions_triangular(2);
  const double sigma = 1;
  const auto radiance = [&](const Vec3& x, const Vec3& w) { return std::exp(-sigma * w.dot(x)); };
  std::vector<std::pair<double, double>> errors;
  for (const double volume : {8e-3, 1e-3, 1.25e-4}) {
    const TetrahedralMesh mesh = cube_mesh(volume);
    const Problem problem = uniform_problem(mesh, uniform_medium(1, sigma, 0, 0), uniform_wall(1, 0, 0, 0));
    const ManufacturedInput input(mesh, directions, 1, radiance,
                                  [](const Vec3&, const Vec3&) { return 0.0; });
    SolveOptions options = tight_options();
    options.order = order;
    options.angular_input = &input;
    const Solution solution = solve(problem, directions, options);
    errors.emplace_back(std::cbrt(1.0 / mesh.cell_count()),
                        fluence_error(mesh, solution, 1, exact_fluence(directions, radiance)));
  }
  return errors;
}

double observed_order(const std::vector<std::pair<double, double>>& errors) {
  return std::log(errors.front().second / errors.back().second) /
         std::log(errors.front().first / errors.back().first);
}

TEST(Convergence, LinearElementsAreOfSecondOrderInAPureAbsorber) {
  const auto errors = absorber_errors(SpaceOrder::linear);
  EXPECT_GE(observed_order(errors), 1.9);
  EXPECT_LT(errors.back().second, 2e-3);
}

TEST(Convergence, ConstantElementsAreOfFirstOrderInAPureAbsorber) {
  EXPECT_GE(observed_order(absorber_errors(SpaceOrder::constant)), 0.85);
}

TEST(Convergence, VaryingExtinctionKeepsTheOrder) {
  // sigma(x) = 1 + x as cell means: u = exp(-(integral along the ray)) has w.grad u = -sigma u for this u.
  const DirectionSet directions = directions_triangular(2);
  const auto radiance = [](const Vec3& x, const Vec3& w) {
    return std::exp(-(w.dot(x) + w.x() * x.x() * x.x() / 2));
  };
  const auto source = [&](const Vec3& x, const Vec3& w) {
    // w.grad(w.x + w_x x^2/2) = 1 + w_x^2 x, so the source makes up for sigma = 1 + x.
    return (1 + x.x() - 1 - w.x() * w.x() * x.x()) * radiance(x, w);
  };
  std::vector<std::pair<double, double>> errors;
  for (const double volume : {8e-3, 1e-3, 1.25e-4}) {
    const TetrahedralMesh mesh = cube_mesh(volume);
    Medium medium = uniform_medium(1, 0, 0, 0);
    medium.absorption[0] = Coefficient(Expression("1 + x", {"x", "y", "z"}));
    const Problem problem = uniform_problem(mesh, medium, uniform_wall(1, 0, 0, 0));
    const ManufacturedInput input(mesh, directions, 1, radiance, source);
    SolveOptions options = tight_options();
    options.angular_input = &input;
    const Solution solution = solve(problem, directions, options);
    errors.emplace_back(std::cbrt(1.0 / mesh.cell_count()),
                        fluence_error(mesh, solution, 1, exact_fluence(directions, radiance)));
  }
  EXPECT_GE(observed_order(errors), 1.85);
}

TEST(Convergence, StronglyVaryingExtinctionIsStillOfSecondOrder) {
  // sigma runs between 1 and 21 along x; u = exp(-w.x) with the source (sigma - 1) u.
  const DirectionSet directions = directions_triangular(2);
  const auto radiance = [](const Vec3& x, const Vec3& w) { return std::exp(-w.dot(x)); };
  const auto source = [&](const Vec3& x, const Vec3& w) {
    return 10 * (1 + std::sin(12 * x.x())) * radiance(x, w);
  };
  std::vector<std::pair<double, double>> errors;
  for (const double volume : {8e-3, 1e-3, 1.25e-4}) {
    const TetrahedralMesh mesh = cube_mesh(volume);
    Medium medium = uniform_medium(1, 0, 0, 0);
    medium.absorption[0] = Coefficient(Expression("1 + 10*(1 + sin(12*x))", {"x", "y", "z"}));
    const Problem problem = uniform_problem(mesh, medium, uniform_wall(1, 0, 0, 0));
    const ManufacturedInput input(mesh, directions, 1, radiance, source);
    SolveOptions options = tight_options();
    options.angular_input = &input;
    const Solution solution = solve(problem, directions, options);
    errors.emplace_back(std::cbrt(1.0 / mesh.cell_count()),
                        fluence_error(mesh, solution, 1, exact_fluence(directions, radiance)));
  }
  EXPECT_GE(observed_order(errors), 1.8);
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
}  // namespace etendue
