// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/sensors/region_account.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "solver/observe/sensors/uncollided_account.h"
#include "solver/solution/balance.h"
#include "solver/uncollided/first_collision/solve_split.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::region_account_test {
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
    return region_account(lights, options, {directions, solution},
                          region_scope(problem.mesh(), region, cone));
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

// A surface in place of a black wall, and lights that are swept.
TEST(RegionAccount, ClosesBesideASurfaceAndLightsThatAreSwept) {
  const TetrahedralMesh mesh = two_region_mesh(0.01);
  const Problem plain = block_in_gas(mesh, PhaseHenyeyGreenstein{0.5});
  std::vector<Wall> walls(plain.walls().begin(), plain.walls().end());
  const auto number = [&](const char* name) {
    return static_cast<int>(std::ranges::find(mesh.wall_names(), name) - mesh.wall_names().begin());
  };
  Wall& surface = walls[static_cast<std::size_t>(number("xmin"))];
  surface.refractive_index = 1.4;
  surface.radiance = {0.7};
  PointLight bulb;
  bulb.position = mesh.centroid(CellIndex(0));
  bulb.power = {3};
  const BeamLight sun{Vec3(0.2, 0.3, -1).normalized(), {2}, {number("zmax")}};
  const Problem problem(mesh, {}, {plain.media().begin(), plain.media().end()}, walls, AngularSpace::sphere,
                        {{"bulb", bulb, {}, Uncollided::no}, {"sun", sun, {}, Uncollided::no}});
  const Solved solved(problem, directions_ldfe_sq(1));
  EXPECT_LT(std::abs(balances(problem, solved.solution)[0].residual), 1e-9);
  const auto powers = region_powers(problem, solved.solution);
  double emitted = 0;
  for (const int region : {0, 1}) {
    const RegionAccount all = solved.account(region);
    EXPECT_NEAR(all.residual(0), 0, 1e-8);
    EXPECT_NEAR(solved.account(region, Cone{Vec3(-0.9, 0.2, 0.3).normalized(), 1.0}).residual(0), 0, 1e-8);
    emitted += all.emitted[0] - powers[static_cast<std::size_t>(region)][0].emitted;
  }
  EXPECT_NEAR(emitted, 3, 1e-9);
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

/// Both parts of the accounts of a region, in all directions and in a cone.
struct LitAccounts {
  std::vector<RegionAccount> collided;
  std::vector<RegionAccount> uncollided;
};

LitAccounts lit_accounts(const LightSetup& lights, int region, const DirectionSet* first_collided) {
  const DirectionSet directions = directions_product(6);
  const std::array<std::optional<Cone>, 2> cones = {std::nullopt,
                                                    Cone{Vec3(0.3, -0.2, -0.9).normalized(), 1.0}};
  SolveOptions options = tight_options();
  options.keep_ordinates.resize(static_cast<std::size_t>(directions.count()));
  std::iota(options.keep_ordinates.begin(), options.keep_ordinates.end(), 0);
  LitAccounts accounts;
  const TetrahedralMesh& mesh = lights.problem().mesh();
  const auto reader = [&](const DirectionSetSolution& swept) {
    for (const auto& cone : cones)
      accounts.collided.push_back(region_account(lights, options, swept, region_scope(mesh, region, cone)));
  };
  const Solution solution = solve_split(lights, directions, options, {}, first_collided, reader);
  for (const auto& cone : cones)
    accounts.uncollided.push_back(uncollided_account(lights, solution, region_scope(mesh, region, cone), 1));
  return accounts;
}

/// Gas that scatters around a block, a wall that reflects, and what shines.
Problem lit_gas(const TetrahedralMesh& mesh, std::vector<Light> lights, double lit_wall) {
  std::vector<Medium> media(2, uniform_medium(1, 0.3, 1, 0, PhaseHenyeyGreenstein{0.5}));
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, name == "zmax" ? lit_wall : 0, name == "zmin" ? 0.5 : 0, 0));
    walls.back().name = name;
    walls.back().uncollided = Uncollided::yes;
  }
  return Problem(mesh, {}, media, walls, AngularSpace::sphere, std::move(lights));
}

/// How far uncollided light may miss, in all directions and in a cone.
struct Miss {
  double all, cone;
};

// Beside lights too: what directions carried closes as the iteration does, uncollided light
// as the sums over points do, and what it scatters is what the other takes over.
void expect_closed(const Problem& problem, const std::vector<int>& regions, const Miss& allowed,
                   const DirectionSet* first_collided = nullptr) {
  const LightSetup lights(problem);
  for (const int region : regions) {
    const LitAccounts accounts = lit_accounts(lights, region, first_collided);
    for (const std::size_t i : {0, 1}) {
      EXPECT_NEAR(accounts.collided[i].residual(0), 0, 1e-8);
      EXPECT_NEAR(accounts.uncollided[i].residual(0), 0, i == 0 ? allowed.all : allowed.cone);
    }
    const RegionAccount& first = accounts.uncollided[0];
    EXPECT_GT(first.coming_in(0), 0.1);
    EXPECT_GT(accounts.collided[0].scattered_in[0], 1.0000001 * accounts.collided[0].scattered_out[0]);
    EXPECT_NEAR((accounts.collided[0].scattered_in[0] - first.scattered_out[0]) /
                    accounts.collided[0].scattered_out[0],
                1, 1e-8)
        << "light is scattered as often into directions as out of them";
  }
}

TEST(RegionAccount, ClosesInTheSun) {
  const TetrahedralMesh mesh = two_region_mesh(0.02);
  const auto zmax =
      static_cast<int>(std::ranges::find(mesh.wall_names(), "zmax") - mesh.wall_names().begin());
  expect_closed(lit_gas(mesh, {{"sun", BeamLight{-Vec3::UnitZ(), {2}, {zmax}}, {}}}, 0), {0, 1},
                {1e-8, 1e-8});
}

// The edge of the cone goes through cells.
TEST(RegionAccount, ClosesAroundABulb) {
  const TetrahedralMesh mesh = two_region_mesh(0.02);
  expect_closed(lit_gas(mesh, {{"bulb", PointLight{{0.5, 0.5, 0.55}, {3}, Vec3::UnitZ(), {}, {}}, {}}}, 0),
                {0, 1}, {1e-5, 4e-3});
}

// Light that collides once has a set of its own, whose account is added.
TEST(RegionAccount, ClosesWhereLightCollidesOnceOnAnotherSet) {
  const TetrahedralMesh mesh = two_region_mesh(0.02);
  const auto zmax =
      static_cast<int>(std::ranges::find(mesh.wall_names(), "zmax") - mesh.wall_names().begin());
  const DirectionSet finer = directions_product(8);
  expect_closed(lit_gas(mesh, {{"sun", BeamLight{-Vec3::UnitZ(), {2}, {zmax}}, {}}}, 0), {0, 1}, {1e-8, 1e-8},
                &finer);
}

// What flows from the block into the gas flows into the gas from the block; and the parts of a surface are
// all of it.
TEST(RegionAccount, SurfacesHaveParts) {
  const TetrahedralMesh mesh = two_region_mesh(0.02);
  const Problem problem = block_in_gas(mesh, PhaseIsotropic{});
  const Solved solved(problem, directions_product(4));
  const int inner = region_of(mesh, "inner"), outer = 1 - inner;
  const Cone cone{Vec3(0.3, -0.2, 0.9).normalized(), 1.0};
  const auto through = [&](const std::vector<SurfaceFace>& surface) {
    return region_account(solved.lights, solved.options, {solved.directions, solved.solution},
                          {-1, surface, cone});
  };
  const RegionAccount from_block = through(surface_of(mesh, inner, {.region = outer}));
  const RegionAccount from_gas = through(surface_of(mesh, outer, {.region = inner}));
  EXPECT_GT(from_block.flowing_out[0], 0.1);
  EXPECT_NEAR(from_block.flowing_out[0] / from_gas.flowing_in[0], 1, 1e-12);
  EXPECT_NEAR(from_block.flowing_in[0] / from_gas.flowing_out[0], 1, 1e-12);
  EXPECT_EQ(from_block.path[0], 0);
  RegionAccount parts = from_gas;
  for (int wall = 0; wall < static_cast<int>(mesh.wall_names().size()); ++wall)
    parts.add(through(surface_of(mesh, outer, {.wall = wall})), 1);
  const RegionAccount whole = solved.account(outer, cone);
  EXPECT_NEAR(parts.flowing_out[0] / whole.flowing_out[0], 1, 1e-12);
  EXPECT_NEAR(parts.flowing_in[0] / whole.flowing_in[0], 1, 1e-12);
  EXPECT_EQ(surface_of(mesh, outer, {.wall = 0}).size(), surface_of_wall(mesh, 0).size());
}

// A wide lamp is many beams, and theirs is the error.
TEST(RegionAccount, ClosesUnderALamp) {
  const TetrahedralMesh mesh = two_region_mesh(0.2);
  expect_closed(lit_gas(mesh, {}, 1), {region_of(mesh, "inner")}, {2e-3, 2e-3});
}

// The sun travels within a cone or not; a bulb sends the cone's part of its power into it.
TEST(RegionAccount, KnowsWhereLightOfLightsGoes) {
  const TetrahedralMesh mesh = two_region_mesh(0.02);
  const auto zmax =
      static_cast<int>(std::ranges::find(mesh.wall_names(), "zmax") - mesh.wall_names().begin());
  const Problem problem = lit_gas(mesh,
                                  {{"sun", BeamLight{-Vec3::UnitZ(), {2}, {zmax}}, {}},
                                   {"bulb", PointLight{{0.5, 0.5, 0.5}, {3}, Vec3::UnitZ(), {}, {}}, {}}},
                                  0);
  const LightSetup lights(problem);
  const Solution solution = solve_split(lights, directions_product(2), tight_options());
  const int inner = region_of(mesh, "inner");
  const Cone up{Vec3::UnitZ(), 0.5}, down{-Vec3::UnitZ(), 0.5};
  const RegionAccount rising = uncollided_account(lights, solution, region_scope(mesh, inner, up), 1);
  const RegionAccount falling = uncollided_account(lights, solution, region_scope(mesh, inner, down), 1);
  EXPECT_NEAR(rising.emitted[0], 3 * up.solid_angle() / (4 * pi), 1e-8);
  EXPECT_NEAR(falling.emitted[0], rising.emitted[0], 1e-12);
  EXPECT_NEAR(falling.flowing_in[0] - rising.flowing_in[0], 2 * 0.25 * std::exp(-1.3 * 0.25), 1e-8);
}

}  // namespace
}  // namespace etendue::region_account_test
