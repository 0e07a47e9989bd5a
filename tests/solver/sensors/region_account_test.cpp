// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/sensors/region_account.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "solver/measure/balance.h"
#include "tests/solver/ordinates/sample_problems.h"

namespace etendue {
namespace {

using std::numbers::pi;

struct Solved {
  Solved(const Problem& asked, DirectionSet set)
      : problem(asked), directions(std::move(set)), lights(problem) {
    options = tight_options();
    options.tolerance = 1e-11;
    options.keep_ordinates.resize(static_cast<std::size_t>(directions.count()));
    std::iota(options.keep_ordinates.begin(), options.keep_ordinates.end(), 0);
    solution = solve(problem, directions, options);
  }
  RegionAccount account(int region, const std::optional<Cone>& cone = {}) const {
    return region_account(lights, directions, options, solution, region, cone);
  }

  const Problem& problem;
  DirectionSet directions;
  LightSetup lights;
  SolveOptions options;
  Solution solution;
};

int region_of(const TetrahedralMesh& mesh, const std::string& name) {
  return mesh.region_names()[0] == name ? 0 : 1;
}

/// A bright block in gas that scatters, between a diffuse wall, a mirror and black ones.
Problem block_in_gas(const TetrahedralMesh& mesh, const PhaseFunction& phase) {
  std::vector<Medium> media;
  for (const std::string& name : mesh.region_names()) {
    media.push_back(uniform_medium(1, name == "inner" ? 1 : 0.3, name == "inner" ? 4 : 1,
                                   name == "inner" ? 2 : 0.1, phase));
    media.back().name = name;
  }
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(
        uniform_wall(1, name == "zmin" ? 0.5 : 0, name == "xmax" ? 0.6 : 0, name == "ymax" ? 0.9 : 0));
    walls.back().name = name;
  }
  return Problem(mesh, {}, media, walls);
}

// The net flux through the closed surface of a region is what it emits less what it absorbs, and the account
// of every cone closes.
TEST(RegionAccount, FluxThroughASurfaceIsTheBalance) {
  const TetrahedralMesh mesh = two_region_mesh(0.01);
  for (const PhaseFunction& phase :
       {PhaseFunction(PhaseIsotropic{}), PhaseFunction(PhaseHenyeyGreenstein{0.5}),
        PhaseFunction(PhaseHenyeyGreenstein{0.9})}) {
    const Problem problem = block_in_gas(mesh, phase);
    const Solved solved(problem, directions_ldfe_sq(1));
    const auto powers = region_powers(problem, solved.solution);
    for (const int region : {0, 1}) {
      const RegionAccount all = solved.account(region);
      const RegionPower& power = powers[static_cast<std::size_t>(region)][0];
      EXPECT_NEAR(all.solid_angle, 4 * pi, 1e-12);
      EXPECT_NEAR((all.flowing_out[0] - all.flowing_in[0]) / (power.emitted - power.absorbed), 1, 1e-8)
          << phase_name(phase) << mesh.region_names()[static_cast<std::size_t>(region)];
      // A matrix is not the phase function between its ordinates, which tells what scatters in.
      const double allowed = std::get_if<PhaseHenyeyGreenstein>(&phase) != nullptr &&
                                     std::get<PhaseHenyeyGreenstein>(phase).asymmetry > 0.8
                                 ? 0.01
                                 : 1e-8;
      EXPECT_NEAR(all.residual(0), 0, allowed);
      const RegionAccount cone = solved.account(region, Cone{Vec3(0.3, -0.2, 0.9).normalized(), 1.0});
      EXPECT_GT(cone.solid_angle, 1);
      EXPECT_NEAR(cone.residual(0), 0, allowed);
      EXPECT_GT(std::abs(cone.flowing_out[0] - cone.flowing_in[0]), 1e-3);
    }
  }
}

// A constant radiance fills phase space: the integral is u V times the solid angle.
TEST(RegionAccount, CountsPhaseSpaceInAFurnace) {
  const TetrahedralMesh mesh = two_region_mesh(0.02);
  const Problem furnace =
      uniform_problem(mesh, uniform_medium(1, 0.7, 2, 0.7 * 3), uniform_wall(1, 0.3 * 3, 0.7, 0));
  const Solved solved(furnace, directions_product(4));
  const int inner = region_of(mesh, "inner");
  const RegionAccount cone = solved.account(inner, Cone{Vec3::UnitX(), 0.8});
  EXPECT_NEAR(cone.path[0] / (3 * 0.125 * cone.solid_angle), 1, 1e-8);
  EXPECT_NEAR(cone.flowing_in[0] / cone.flowing_out[0], 1, 1e-8);
  EXPECT_NEAR(cone.scattered_in[0] / cone.scattered_out[0], 1, 1e-8);
}

}  // namespace
}  // namespace etendue
