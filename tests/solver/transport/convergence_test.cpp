// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The order at which errors fall on finer and finer meshes.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/transport/solve/solve.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::convergence_test {
namespace {

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

}  // namespace
}  // namespace etendue::convergence_test
