// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Plane problems on a slice between mirrors z = const: exact answers of the plane.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "solver/solution/balance.h"
#include "solver/solution/probe.h"
#include "solver/transport/solve/solve.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::flatland_test {
namespace {

using std::numbers::pi;

/// 0 < x < 1, with sides y and z so close together that a cell reaches from one to the other.
TetrahedralMesh strip(double cell) {
  BoxPrimitive box;
  box.region = "domain";
  box.min = Vec3(0, 0, 0);
  box.max = Vec3(1, cell, cell);
  Geometry geometry;
  geometry.primitives.emplace_back(box);
  TetrahedraOptions options;
  options.max_volume = {cell * cell * cell / 6};
  return TetrahedralMesh(tetrahedralize(arrange(geometry), options));
}

/// Walls by name: `of(name)` for xmin … ymax, cold mirrors across z.
Problem plane_problem(const TetrahedralMesh& mesh, const Medium& medium,
                      const std::function<Wall(const std::string&)>& of) {
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(name[0] == 'z' ? uniform_wall(1, 0, 0, 1) : of(name));
    walls.back().name = name;
  }
  return Problem(mesh, Bands{}, {medium}, walls, AngularSpace::plane);
}

/// Bickley and Nayler's Ki_n(x) = integral of cos^(n-1) t exp(-x / cos t) dt from 0 to pi/2, by the trapezoid
/// rule, which converges faster than any power where x > 0.
double bickley(int n, double x) {
  constexpr int steps = 4000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double c = std::cos(pi / 2 * (i + 0.5) / steps);
    sum += std::pow(c, n - 1) * std::exp(-x / c) * pi / 2 / steps;
  }
  return sum;
}

TEST(Flatland, DiffuselyLitAbsorberDarkensAsBickleysFunctions) {
  // A wall of radiance L at x = 0: fluence 2 L Ki_1(sigma x), flux 2 L Ki_2(sigma x).
  const TetrahedralMesh mesh = strip(0.1);
  const double radiance = 1.5, absorption = 2;
  const Problem problem = plane_problem(mesh, uniform_medium(1, absorption, 0, 0), [&](const auto& name) {
    return name == "xmin" ? uniform_wall(1, radiance, 0, 0) : uniform_wall(1, 0, 0, name == "xmax" ? 0 : 1);
  });
  const Solution solution = solve(problem, directions_flatland(48), tight_options());
  const CellLocator locator(mesh);
  for (const double x : {0.3, 0.6, 0.9}) {
    const ProbeValue at = probe(problem, solution, locator, Vec3(x, 0.04, 0.04))[0];
    EXPECT_NEAR(at.fluence, 2 * radiance * bickley(1, absorption * x), 2e-3 * radiance);
    EXPECT_NEAR(at.net_flux[0], 2 * radiance * bickley(2, absorption * x), 2e-3 * radiance);
    EXPECT_NEAR(at.net_flux[2], 0, 1e-14);
  }
  const auto powers = wall_powers(problem, solution);
  for (std::size_t w = 0; w < problem.walls().size(); ++w) {
    if (problem.walls()[w].name != "xmax") continue;
    EXPECT_NEAR(powers[w][0].irradiance_mean / radiance, 2 * bickley(2, absorption), 5e-4);
  }
}

TEST(Flatland, ErrorAgainstBickleysFunctionHasTheOrderOfTheMesh) {
  double before = 0;
  for (const double cell : {0.4, 0.2, 0.1}) {
    const TetrahedralMesh mesh = strip(cell);
    const Problem problem = plane_problem(mesh, uniform_medium(1, 2, 0, 0), [](const auto& name) {
      return name == "xmin" ? uniform_wall(1, 1, 0, 0) : uniform_wall(1, 0, 0, name == "xmax" ? 0 : 1);
    });
    const Solution solution = solve(problem, directions_flatland(64), tight_options());
    const auto powers = wall_powers(problem, solution);
    double error = 0;
    for (std::size_t w = 0; w < problem.walls().size(); ++w)
      if (problem.walls()[w].name == "xmax")
        error = std::abs(powers[w][0].irradiance_mean - 2 * bickley(2, 2));
    if (before > 0) {
      EXPECT_GT(std::log2(before / error), 2) << cell;
    }
    before = error;
  }
}

TEST(Flatland, FurnaceIsConstantWithScatteringMirrorsAndDiffuseWalls) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  const double level = 2.5;
  for (const PhaseFunction& phase :
       {PhaseFunction(PhaseHenyeyGreenstein{0.7}), PhaseFunction(PhaseRayleigh{})}) {
    const Problem problem =
        plane_problem(mesh, uniform_medium(1, 0.3, 2, 0.3 * level, phase), [&](const auto& name) {
          return name == "xmin" ? uniform_wall(1, 0, 0, 1)
                                : uniform_wall(1, (1 - 0.4 - 0.2) * level, 0.4, 0.2);
        });
    const Solution solution = solve(problem, directions_flatland(16), tight_options());
    ASSERT_TRUE(solution.converged());
    EXPECT_LT(largest_deviation(solution.fluence, 2 * pi * level), 1e-10);
    for (const double flux : solution.net_flux) EXPECT_LT(std::abs(flux), 1e-9 * level);
    const Balance balance = balances(problem, solution).front();
    EXPECT_LT(std::abs(balance.residual), 1e-10);
    EXPECT_NEAR(balance.emitted, 2 * pi * 0.3 * level, 1e-9);  // the cube's volume is 1
  }
}

TEST(Flatland, ScatteringWithoutAbsorptionLosesNothing) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  const Problem problem =
      plane_problem(mesh, uniform_medium(1, 0, 3, 0, PhaseHenyeyGreenstein{0.8}), [](const auto& name) {
        return name == "xmin" ? uniform_wall(1, 1, 0, 0) : uniform_wall(1, 0, 0.2, 0);
      });
  const Solution solution = solve(problem, directions_flatland(24), tight_options());
  ASSERT_TRUE(solution.converged());
  const Balance balance = balances(problem, solution).front();
  EXPECT_EQ(balance.absorbed, 0);
  EXPECT_LT(std::abs(balance.residual), 1e-10);
}

TEST(Flatland, DiscreteKernelHasTheAsymmetryOfThePlane) {
  const TetrahedralMesh mesh = cube_mesh(5e-2);
  const Problem problem = plane_problem(mesh, uniform_medium(1, 1, 1, 1, PhaseHenyeyGreenstein{0.6}),
                                        [](const auto&) { return uniform_wall(1, 0, 0, 0); });
  const Solution solution = solve(problem, directions_flatland(16), tight_options());
  ASSERT_EQ(solution.kernels.size(), 1u);
  EXPECT_NEAR(solution.kernels[0].asymmetry, 0.6, 1e-12);
  EXPECT_LT(solution.kernels[0].energy_error, 1e-12);
}

TEST(Flatland, NothingToIterateWhereOnlyTheSidesAcrossZReflect) {
  const TetrahedralMesh mesh = cube_mesh(5e-2);
  const Problem problem =
      plane_problem(mesh, uniform_medium(1, 1, 0, 1), [](const auto&) { return uniform_wall(1, 0, 0, 0); });
  EXPECT_EQ(solve(problem, directions_flatland(8), tight_options()).convergence[0].sweeps, 1);
}

TEST(Flatland, DirectionsOfTheOtherSpaceAreAMistakeOfTheProgram) {
  const TetrahedralMesh mesh = cube_mesh(5e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 1, 0, 1), uniform_wall(1, 0, 0, 0));
  EXPECT_THROW(solve(problem, directions_flatland(8), tight_options()), std::invalid_argument);
}

TEST(Flatland, ThickBrightSheetsTakeFewSweeps) {
  const TetrahedralMesh mesh = strip(0.1);
  for (const double asymmetry : {0.0, 0.6})
    for (const double scattering : {5.0, 20.0, 200.0}) {
      Medium medium = uniform_medium(1, 0, scattering, 0);
      if (asymmetry > 0) medium.phase[0] = PhaseHenyeyGreenstein{asymmetry};
      const Problem problem = plane_problem(
          mesh, medium, [](const auto& name) { return uniform_wall(1, name == "xmin" ? 1 : 0, 0, 0); });
      SolveOptions options = tight_options();
      options.acceleration = Acceleration::diffusion;
      options.tolerance = 1e-8;
      const Solution solution = solve(problem, directions_flatland(32), options);
      ASSERT_TRUE(solution.converged());
      EXPECT_LE(solution.convergence[0].sweeps, 25) << "g = " << asymmetry << ", scattering " << scattering;
    }
}

}  // namespace
}  // namespace etendue::flatland_test
