// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/solver/ordinates/sample_problems.h"

namespace etendue {
namespace {

/// A slab 0 < x < 1 between black walls, mirrors at its other sides: sigma_t = 1/epsilon, sigma_a = epsilon,
/// q = epsilon/(4 pi). As epsilon -> 0 the fluence tends to the solution of -phi''/3 + phi = 1, phi = 0 at
/// both ends (Larsen and Keller 1974).
Problem slab(const TetrahedralMesh& mesh, double epsilon) {
  const Medium medium = uniform_medium(1, epsilon, 1 / epsilon - epsilon, epsilon / (4 * M_PI));
  std::vector<Medium> media;
  for (const std::string& name : mesh.region_names()) {
    media.push_back(medium);
    media.back().name = name;
  }
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, 0, 0, name == "xmin" || name == "xmax" ? 0 : 1));
    walls.back().name = name;
  }
  return Problem(mesh, Bands{}, media, walls);
}

double diffusion(const Vec3& at) {
  const double k = std::sqrt(3.0);
  return 1 - std::cosh(k * (at.x() - 0.5)) / std::cosh(k / 2);
}

Solution solved(const Problem& problem, SpaceOrder order, double tolerance = 1e-6) {
  SolveOptions options = tight_options(Lumping::automatic);
  options.order = order;
  options.tolerance = tolerance;
  return solve(problem, directions_triangular(4), options);
}

double mean(const TetrahedralMesh& mesh, const Solution& solution) {
  double sum = 0;
  for (std::size_t i = 0; i < solution.fluence.size(); ++i)
    sum += mesh.volumes()[i / 4] * solution.fluence[i] / 4;
  return sum;
}

TEST(DiffusionLimit, ErrorOfLinearElementsIsBounded) {
  const TetrahedralMesh mesh = cube_mesh(3e-3);
  for (const double epsilon : {1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    // The sweep's rounding, 1e-16, is an error of 1e-16/epsilon^2 in the fluence.
    const double tolerance = std::max(1e-6, 1e-15 / (epsilon * epsilon));
    const Solution solution = solved(slab(mesh, epsilon), SpaceOrder::linear, tolerance);
    EXPECT_TRUE(solution.converged()) << "epsilon " << epsilon;
    EXPECT_LE(solution.convergence[0].sweeps, 25) << "epsilon " << epsilon;
    // The mesh has five cells across: 6.5 % in the limit, which falls with the mesh (below). Transport proper
    // adds O(epsilon).
    EXPECT_LT(fluence_error(mesh, solution, 1, diffusion), 0.07 + 4 * epsilon) << "epsilon " << epsilon;
  }
}

TEST(DiffusionLimit, ErrorFallsWithTheMesh) {
  std::vector<double> errors;
  for (const double volume : {2.4e-2, 3e-3, 3.75e-4}) {
    const TetrahedralMesh mesh = cube_mesh(volume);
    errors.push_back(fluence_error(mesh, solved(slab(mesh, 1e-5), SpaceOrder::linear), 1, diffusion));
  }
  EXPECT_GT(std::log2(errors[0] / errors[2]) / 2, 1.3) << errors[0] << " " << errors[1] << " " << errors[2];
}

TEST(DiffusionLimit, ConstantsMissIt) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  const double exact = 1 - std::tanh(std::sqrt(3.0) / 2) / (std::sqrt(3.0) / 2);
  EXPECT_LT(mean(mesh, solved(slab(mesh, 1e-3), SpaceOrder::constant)), 0.1 * exact);
  EXPECT_NEAR(mean(mesh, solved(slab(mesh, 1e-3), SpaceOrder::linear)), exact, 0.1 * exact);
}

}  // namespace
}  // namespace etendue
