// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Photons in media whose absorption or scattering depends on the direction.
#include "solver/photons/sampling/directional_medium.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/materials/kernels/leaf_canopy.h"
#include "solver/materials/kernels/micro_flakes.h"
#include "solver/photons/solve/probe_histories.h"
#include "solver/photons/solve/solve_photons.h"
#include "solver/solution/balance.h"
#include "tests/solver/photons/solve/photon_samples.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::directional_medium_test {
namespace {

using std::numbers::pi;

/// Leaves of an area density.
Medium leaves(double density, const LeafCanopy& canopy, double emission = 0) {
  const double scattered = canopy.reflectance + canopy.transmittance;
  Medium medium = uniform_medium(1, 0.5 * density * (1 - scattered), 0.5 * density * scattered, emission);
  medium.directional = {canopy};
  return medium;
}

Medium flakes(double density, const MicroFlakes& shape) {
  const double mean = mean_flake_projection(shape);
  Medium medium = uniform_medium(1, density * mean * (1 - shape.albedo), density * mean * shape.albedo, 0);
  medium.directional = {shape};
  return medium;
}

/// A beam of irradiance 1 that enters a black cube by x = 0, y = 0 and z = 0.
Problem lit_cube(const TetrahedralMesh& mesh, const Medium& medium, const Vec3& direction) {
  std::vector<int> lit;
  for (const char* name : {"xmin", "ymin", "zmin"}) lit.push_back(static_cast<int>(wall_of(mesh, name)));
  return Problem(mesh, {}, {medium}, std::vector<Wall>(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0)),
                 AngularSpace::sphere, {{"beam", BeamLight{direction, {1}, lit}, {}}});
}

void expect_furnace(const Problem& problem, double radiance, double photons) {
  const PhotonSolution found = solved(problem, photons);
  EXPECT_NEAR(mean_square_off(found, radiance), 1, 0.25);
  EXPECT_LT(found.report.error[0], 0.08);
  const CellLocator locator(problem.mesh());
  const auto seen = walk_back_from({{Vec3(0.4, 0.5, 0.2), {}}}, problem, locator, {4000, 1, 2});
  EXPECT_NEAR(seen[0][0].fluence.value, 4 * pi * radiance, 3 * seen[0][0].fluence.error);
  EXPECT_LT(seen[0][0].fluence.error, 0.05 * 4 * pi * radiance);
}

// Light that goes straight: exp(-G(w) L) of it is left (Ross 1981).
TEST(DirectionalMedium, LeavesLetThroughWhatTheyDoNotShade) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  for (const LeafAngles angles : {LeafAngles::planophile, LeafAngles::horizontal, LeafAngles::erectophile}) {
    const Problem problem = lit_cube(mesh, leaves(3, {angles, 0, 0}), Vec3::UnitZ());
    const Balance balance = balances(problem, solved(problem, 640).solution)[0];
    EXPECT_NEAR(balance.outflow, std::exp(-3 * leaf_projection(angles, Vec3::UnitZ())), 1e-8);
    EXPECT_NEAR(balance.outflow + balance.absorbed, 1, 1e-12);
  }
}

// Where nothing absorbs, walls of one radiance keep it everywhere, whatever the leaves and flakes do.
TEST(DirectionalMedium, LeavesAndFlakesKeepAFurnace) {
  const TetrahedralMesh mesh = cube_mesh(0.03);
  const Wall wall = uniform_wall(1, 1.2, 0.4, 0);
  for (const Medium& medium :
       {leaves(4, {LeafAngles::planophile, 0.7, 0.3}), leaves(4, {LeafAngles::vertical, 0.2, 0.8}),
        flakes(3, {Vec3(1, 2, 2).normalized(), 1, 0.3, 1}), leaves(4, {LeafAngles::spherical, 0.3, 0.2}, 2)})
    expect_furnace(uniform_problem(mesh, medium, wall), 2, 20000);
}

// Level leaves of area 2 under a diffuse sky: Goudriaan's two streams (1977) are exact.
TEST(DirectionalMedium, LevelLeavesReflectAndTransmitAsTwoStreams) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  const double r = 0.45, t = 0.35, area = 2;
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 1));
  const std::size_t sky = wall_of(mesh, "zmax"), ground = wall_of(mesh, "zmin");
  walls[sky] = uniform_wall(1, 1 / pi, 0, 0);
  walls[ground] = uniform_wall(1, 0, 0, 0);
  const Problem problem(mesh, {}, {leaves(area, {LeafAngles::horizontal, r, t})}, walls);
  const PhotonSolution found = solved(problem, 40000, [&](const Solution& batch) {
    const auto powers = wall_powers(problem, batch);
    return std::vector<double>{powers[sky][0].incoming, powers[ground][0].incoming,
                               balances(problem, batch)[0].residual};
  });
  const double rate = std::sqrt((1 - t) * (1 - t) - r * r), deep = (1 - t - rate) / r;
  const double through = std::exp(-area * rate), rest = 1 - std::pow(deep * through, 2);
  const BatchStatistics& derived = found.sums.derived;
  EXPECT_NEAR(derived.mean(0), deep * (1 - through * through) / rest, 3 * derived.error(0));
  EXPECT_NEAR(derived.mean(1), (1 - deep * deep) * through / rest, 3 * derived.error(1));
  EXPECT_LT(derived.error(0), 0.01 * derived.mean(0));
  EXPECT_LT(derived.error(1), 0.01 * derived.mean(1));
  EXPECT_LT(std::abs(derived.mean(2)), 3 * derived.error(2) + 1e-12);
}

// Absorption by a formula of the direction, and the remainder of an extinction. Where it depends on the place
// too it is the mean over each cell, which a ray does not meet evenly.
TEST(DirectionalMedium, AbsorptionByAFormulaIsThatOfTheDirection) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  Medium medium = uniform_medium(1, 1, 0, 0);
  medium.absorption_by_direction = {AngularFormula("(1 + 0.5*wz)*2*z")};
  const Problem upwards = lit_cube(mesh, medium, Vec3::UnitZ());
  EXPECT_NEAR(balances(upwards, solved(upwards, 6400).solution)[0].absorbed, 1 - std::exp(-1.5), 0.01);
  medium.absorption_by_direction = {AngularFormula("1 + wx")};
  const Problem sideways = lit_cube(mesh, medium, Vec3::UnitX());
  EXPECT_NEAR(balances(sideways, solved(sideways, 640).solution)[0].absorbed, 1 - std::exp(-2), 1e-12);
  medium = uniform_medium(1, 0.5, 0.5, 0.5);
  medium.absorption_by_direction = {AngularFormula("1 + 0*wx")};
  medium.extinction_by_direction = true;
  expect_furnace(uniform_problem(mesh, medium, uniform_wall(1, 0.5, 0.5, 0)), 1, 20000);
}

TEST(DirectionalMedium, ThreadsDoNotChangeABit) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  Medium medium = leaves(3, {LeafAngles::plagiophile, 0.3, 0.3}, 1);
  const Problem problem = uniform_problem(mesh, medium, uniform_wall(1, 0.1, 0.5, 0.3));
  const PhotonSolution one = solved(problem, 2000, {}, 1), three = solved(problem, 2000, {}, 3);
  EXPECT_EQ(one.sums.packed(), three.sums.packed());
  EXPECT_EQ(one.solution.absorbed, three.solution.absorbed);
  EXPECT_EQ(PhotonSums::unpacked(one.solution.state.photons).packed(), one.sums.packed());
}

TEST(DirectionalMedium, RefusesNegativeAbsorptionWithTheDirection) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  Medium medium = uniform_medium(1, 1, 0, 1);
  medium.origin = {"case.toml", 7, "media.fog"};
  medium.absorption_by_direction = {AngularFormula("1 + 2*wz")};
  const Problem problem = uniform_problem(mesh, medium, uniform_wall(1, 0, 0, 0));
  const std::string refusal = refusal_of(problem);
  EXPECT_NE(refusal.find("case.toml:7: media.fog.absorption = -"), std::string::npos) << refusal;
}

}  // namespace
}  // namespace etendue::directional_medium_test
