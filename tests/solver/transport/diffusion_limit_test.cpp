// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/solver/transport/diffusive_slab.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::diffusion_limit_test {
namespace {

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
    const Solution solution =
        solved(diffusive_slab(mesh, epsilon), SpaceOrder::linear, diffusive_slab_tolerance(epsilon));
    EXPECT_TRUE(solution.converged()) << "epsilon " << epsilon;
    EXPECT_LE(solution.convergence[0].sweeps, 25) << "epsilon " << epsilon;
    // The mesh has five cells across: 6.5 % in the limit, which falls with the mesh (below). Transport proper
    // adds O(epsilon).
    EXPECT_LT(fluence_error(mesh, solution, 1, diffusive_slab_fluence), 0.07 + 4 * epsilon)
        << "epsilon " << epsilon;
  }
}

TEST(DiffusionLimit, ErrorFallsWithTheMesh) {
  std::vector<double> errors;
  for (const double volume : {2.4e-2, 3e-3, 3.75e-4}) {
    const TetrahedralMesh mesh = cube_mesh(volume);
    errors.push_back(fluence_error(mesh, solved(diffusive_slab(mesh, 1e-5), SpaceOrder::linear), 1,
                                   diffusive_slab_fluence));
  }
  EXPECT_GT(std::log2(errors[0] / errors[2]) / 2, 1.3) << errors[0] << " " << errors[1] << " " << errors[2];
}

TEST(DiffusionLimit, ConstantsMissIt) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  const double exact = 1 - std::tanh(std::sqrt(3.0) / 2) / (std::sqrt(3.0) / 2);
  EXPECT_LT(mean(mesh, solved(diffusive_slab(mesh, 1e-3), SpaceOrder::constant)), 0.1 * exact);
  EXPECT_NEAR(mean(mesh, solved(diffusive_slab(mesh, 1e-3), SpaceOrder::linear)), exact, 0.1 * exact);
}

}  // namespace
}  // namespace etendue::diffusion_limit_test
