// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Numbers at the ends of the range of double, and beyond it.
#include "solver/transport/sweep/finite_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "tests/solver/transport/sample_problems.h"

namespace etendue::finite_check_test {
namespace {

Problem scattering_cube(const TetrahedralMesh& mesh, double emission) {
  return uniform_problem(mesh, uniform_medium(1, 0.2, 2, emission), uniform_wall(1, 0, 0.5, 0));
}

SolveOptions options_of(Method method, Acceleration acceleration, Positivity positivity) {
  SolveOptions options = tight_options();
  options.method = method;
  options.acceleration = acceleration;
  options.positivity = positivity;
  options.tolerance = 1e-6;
  return options;
}

std::vector<SolveOptions> all_iterations() {
  std::vector<SolveOptions> all;
  for (const Method method : {Method::gmres, Method::source_iteration})
    for (const Acceleration acceleration : {Acceleration::none, Acceleration::diffusion})
      all.push_back(options_of(method, acceleration, Positivity::none));
  all.push_back(options_of(Method::gmres, Acceleration::diffusion, Positivity::rescale));
  return all;
}

TEST(FiniteCheck, NamesTheSweepTheBandAndThePlace) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  const Problem problem = scattering_cube(mesh, 1);
  const DirectionSet directions = directions_triangular(2);
  const ManufacturedInput broken(
      mesh, directions, 1, [](const Vec3&, const Vec3&) { return 0.0; },
      [](const Vec3& point, const Vec3&) {
        return point.x() > 0.9 ? std::numeric_limits<double>::quiet_NaN() : 1.0;
      });
  for (SolveOptions options : all_iterations()) {
    options.angular_input = &broken;
    try {
      solve(problem, directions, options);
      FAIL() << "no error";
    } catch (const NotFiniteError& error) {
      EXPECT_NE(
          std::string(error.what()).find("sweep 1, band band0: the radiance is not a finite number in cell"),
          std::string::npos)
          << error.what();
      EXPECT_NE(std::string(error.what()).find("in region domain"), std::string::npos) << error.what();
    }
  }
}

TEST(FiniteCheck, TinyAndHugeSourcesConvergeAsOthersDo) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  const DirectionSet directions = directions_triangular(2);
  for (const SolveOptions& options : all_iterations()) {
    const Solution one = solve(scattering_cube(mesh, 1), directions, options);
    ASSERT_TRUE(one.converged());
    for (const double emission : {1e-250, 1e-160, 1e160}) {
      const Solution solution = solve(scattering_cube(mesh, emission), directions, options);
      ASSERT_TRUE(solution.converged()) << emission;
      EXPECT_EQ(solution.convergence[0].sweeps, one.convergence[0].sweeps) << emission;
      for (std::size_t i = 0; i < one.fluence.size(); ++i)
        ASSERT_NEAR(solution.fluence[i] / emission, one.fluence[i], 1e-9 * one.fluence[i]) << emission;
    }
  }
}

}  // namespace
}  // namespace etendue::finite_check_test
