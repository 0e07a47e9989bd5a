// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Acceleration by diffusion where scattering prefers directions.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/transport/acceleration/diffusion_acceleration.h"
#include "solver/transport/acceleration/diffusive_medium.h"
#include "solver/transport/sweep/transport_sweep.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::anisotropic_acceleration_test {
namespace {

constexpr ScatteringChoice dense{ScatteringBackend::dense};
constexpr ScatteringChoice moments{ScatteringBackend::moments, 7};

SolveOptions options_of(Method method, Acceleration acceleration, double tolerance = 1e-8) {
  SolveOptions options = tight_options();
  options.method = method;
  options.acceleration = acceleration;
  options.tolerance = tolerance;
  return options;
}

/// Bright in a cold box; cells are `thickness` free paths large.
Problem box(const TetrahedralMesh& mesh, double thickness, Medium medium) {
  const double extinction = thickness / std::cbrt(6 * std::sqrt(2.0) / mesh.cell_count());
  medium.scattering = {Coefficient(0.999 * extinction)};
  medium.absorption = {Coefficient(0.001 * extinction)};
  return uniform_problem(mesh, medium, uniform_wall(1, 0, 0, 0));
}

Medium forward(double asymmetry, ScatteringChoice choice) {
  Medium medium = uniform_medium(1, 0, 0, 1, PhaseHenyeyGreenstein{asymmetry});
  medium.choice = {choice};
  return medium;
}

Medium directional(DirectionalScattering law) {
  Medium medium = uniform_medium(1, 0, 0, 1);
  medium.directional = {std::move(law)};
  return medium;
}

int sweeps_of(const Problem& problem, Method method = Method::gmres) {
  const Solution solution =
      solve(problem, directions_ldfe_sq(1), options_of(method, Acceleration::diffusion));
  EXPECT_TRUE(solution.converged());
  return solution.convergence[0].sweeps;
}

TEST(AnisotropicAcceleration, ForwardScatteringTakesFewSweeps) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  for (const double thickness : {10.0, 100.0}) {
    EXPECT_LE(sweeps_of(box(mesh, thickness, forward(0.5, dense))), 18);
    EXPECT_LE(sweeps_of(box(mesh, thickness, forward(0.8, dense))), 28);
    EXPECT_LE(sweeps_of(box(mesh, thickness, forward(0.9, dense))), 35);
    EXPECT_LE(sweeps_of(box(mesh, thickness, forward(0.9, moments))), 45);
  }
}

/// A void inside a medium that scatters by a matrix.
Problem hollow_box(const TetrahedralMesh& mesh, double scattering, double asymmetry) {
  Medium medium = forward(asymmetry, dense), gap = uniform_medium(1, 0, 0, 0);
  medium.scattering = {Coefficient(scattering)};
  medium.absorption = {Coefficient(0.2 * scattering)};
  gap.name = "inner";
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, 1, 0, 0));
    walls.back().name = name;
  }
  return {mesh, Bands{}, {medium, gap}, walls};
}

TEST(AnisotropicAcceleration, VoidsBesideMatricesTakeFewSweeps) {
  const TetrahedralMesh mesh = two_region_mesh(3e-2);
  for (const double scattering : {3.5, 50.0})
    for (const double asymmetry : {0.5, 0.9})
      EXPECT_LE(sweeps_of(hollow_box(mesh, scattering, asymmetry)), 35);
}

TEST(AnisotropicAcceleration, UnitSourceGivesTheFreePathBesideVoids) {
  const TetrahedralMesh mesh = two_region_mesh(3e-2);
  const Problem problem = hollow_box(mesh, 1000, 0.9);
  const DirectionSet directions = directions_ldfe_sq(1);
  const std::vector<double> extinction = extinction_of(problem);
  TransportSweep sweep(problem, directions, extinction, options_of(Method::gmres, Acceleration::diffusion));
  TransportState path(sweep.layout());
  sweep.apply_to_unit_source(path);
  const std::vector<double> seen = effective_extinction(
      problem, extinction, sweep.discretization().scattering.plan, sweep.discretization().scattering.groups);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    double mean = 0;
    for (std::size_t i = 0; i < 4; ++i) mean += path.fluence()[4 * static_cast<std::size_t>(c) + i] / 4;
    mean /= full_range(problem.space());
    // Cells at the void have light from far away.
    bool at_void = false;
    for (const std::int32_t v : mesh.vertices(CellIndex(c)))
      at_void = at_void || (mesh.point(VertexIndex(v)).array() - 0.5).abs().maxCoeff() < 0.2501;
    if (!at_void)
      EXPECT_NEAR(mean * seen[static_cast<std::size_t>(c)], 1, 0.25) << c;
    else
      EXPECT_TRUE(mean > 0 && mean < 1) << mean;
  }
}

TEST(AnisotropicAcceleration, SourceIterationConvergesWithIt) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  for (const ScatteringChoice choice : {dense, moments})
    EXPECT_LE(sweeps_of(box(mesh, 10, forward(0.9, choice)), Method::source_iteration), 200);
}

TEST(AnisotropicAcceleration, LeavesAndFlakesTakeFewSweeps) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  for (const double thickness : {1.0, 10.0}) {
    EXPECT_LE(sweeps_of(box(mesh, thickness, directional(LeafCanopy{LeafAngles::planophile, 0.5, 0.5}))), 30);
    EXPECT_LE(sweeps_of(box(mesh, thickness, directional(MicroFlakes{Vec3(0.6, 0, 0.8), 0.3, 1, 1}))), 30);
  }
}

TEST(AnisotropicAcceleration, EveryPathGivesTheSameAnswer) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  for (const Medium& medium : {forward(0.8, dense), forward(0.8, moments),
                               directional(LeafCanopy{LeafAngles::planophile, 0.4, 0.4})}) {
    Medium bright = medium;
    bright.absorption = {Coefficient(0.5)};
    bright.scattering = {Coefficient(3)};
    const Problem problem = uniform_problem(mesh, bright, uniform_wall(1, 0.3, 0.4, 0.3));
    const Solution plain = solve(problem, directions_triangular(4),
                                 options_of(Method::source_iteration, Acceleration::none, 1e-9));
    ASSERT_TRUE(plain.converged());
    for (const Method method : {Method::gmres, Method::source_iteration})
      for (const Acceleration acceleration : {Acceleration::none, Acceleration::diffusion})
        for (const int threads : {1, 2, 3, 4}) {
          SolveOptions options = options_of(method, acceleration, 1e-9);
          options.threads = threads;
          const Solution solution = solve(problem, directions_triangular(4), options);
          ASSERT_TRUE(solution.converged());
          EXPECT_LT(difference(solution, plain, 1, 0), 1e-8);
        }
  }
}

TEST(AnisotropicAcceleration, EstimatedErrorIsTheTrueErrorWithinAFactor) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  for (const Medium& medium : {forward(0.5, dense), forward(0.9, dense), forward(0.9, moments),
                               directional(LeafCanopy{LeafAngles::planophile, 0.5, 0.5})})
    for (const double thickness : {1.0, 10.0, 100.0}) {
      const Problem problem = box(mesh, thickness, medium);
      const DirectionSet directions = directions_triangular(4);
      const Solution exact =
          solve(problem, directions, options_of(Method::gmres, Acceleration::diffusion, 1e-11));
      for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
        const Solution rough =
            solve(problem, directions, options_of(Method::gmres, Acceleration::diffusion, tolerance));
        ASSERT_TRUE(rough.converged());
        EXPECT_LT(difference(rough, exact, 1, 0), 1.5 * tolerance) << thickness;
      }
    }
}

/// The only medium of a problem on a set.
DiffusiveMedium diffusive(const Medium& medium, const DirectionSet& set, const TetrahedralMesh& mesh) {
  const Problem problem = uniform_problem(mesh, medium, uniform_wall(1, 0, 0, 0));
  const auto plan = plan_scattering(problem, set);
  return diffusive_media(problem, set, plan, dense_groups(problem, set, plan)).front();
}

TEST(DiffusiveMedium, OfAPhaseFunctionHasItsTransportCrossSection) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  const DirectionSet set = directions_ldfe_sq(1);
  for (const double g : {0.0, 0.5, 0.8})
    for (const ScatteringChoice choice : {moments, dense}) {
      Medium medium = uniform_medium(1, 0.2, 1, 0, PhaseHenyeyGreenstein{g});
      medium.choice = {choice};
      const DiffusiveMedium diffusive_medium = diffusive(medium, set, mesh);
      // Whatever goes straight ahead, D = 1 / (3 (sigma_a + sigma_s (1 - g))), given as a part of the mean
      // free path that is left.
      const auto plan = plan_scattering(uniform_problem(mesh, medium, uniform_wall(1, 0, 0, 0)), set);
      double left = 1.2 - plan.front().forward;
      if (diffusive_medium.is_dense()) {
        left = 0;
        for (const double part : dense_kernel(medium.phase[0], set).leaving)
          left += (part + 0.2) / set.count();
      }
      const Eigen::Matrix3d expected = left / (3 * (0.2 + 1 - g)) * Eigen::Matrix3d::Identity();
      EXPECT_LT((diffusive_medium.diffusion - expected).norm(), 0.02 * expected.norm()) << g;
    }
}

TEST(DiffusiveMedium, OfLevelLeavesConductsAlongThem) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  Medium medium = directional(LeafCanopy{LeafAngles::planophile, 0.5, 0.5});
  medium.scattering = {Coefficient(1)};
  const Eigen::Matrix3d d = diffusive(medium, directions_ldfe_sq(1), mesh).diffusion;
  EXPECT_GT(d(0, 0), 1.2 * d(2, 2));
  EXPECT_NEAR(d(0, 0), d(1, 1), 1e-9);
  EXPECT_LT(std::abs(d(0, 2)), 1e-9);
}

}  // namespace
}  // namespace etendue::anisotropic_acceleration_test
