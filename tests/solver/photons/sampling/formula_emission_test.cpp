// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Photons of media and walls that emit by formulas of the place and the direction.
#include "solver/photons/sampling/formula_emission.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/photons/solve/probe_histories.h"
#include "solver/photons/solve/solve_photons.h"
#include "solver/solution/balance.h"
#include "tests/solver/photons/solve/photon_samples.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::formula_emission_test {
namespace {

using std::numbers::pi;

Wall emitter(const std::string& radiance, double diffuse) {
  Wall wall = uniform_wall(1, 0, diffuse, 0);
  wall.radiance_by_direction = {AngularFormula(radiance)};
  return wall;
}

Medium emitting(double absorption, const std::string& emission) {
  Medium medium = uniform_medium(1, absorption, 0, 0);
  medium.emission_by_direction = {AngularFormula(emission)};
  return medium;
}

// Where every direction emits what it absorbs, one radiance is everywhere, forwards and backwards.
TEST(FormulaEmission, KeepsAFurnaceThatAbsorbsByDirection) {
  const TetrahedralMesh mesh = cube_mesh(0.03);
  Medium medium = emitting(1, "2*(0.5 + wz*wz + 0.3*wx)");
  medium.scattering = {Coefficient(1)};
  medium.phase = {PhaseHenyeyGreenstein{0.4}};
  medium.absorption_by_direction = {AngularFormula("0.5 + wz*wz + 0.3*wx")};
  const Problem problem = uniform_problem(mesh, medium, emitter("1.2 + 0*x", 0.4));
  const PhotonSolution found = solved(problem, 20000, [&](const Solution& batch) {
    return std::vector<double>{balances(problem, batch)[0].residual};
  });
  EXPECT_NEAR(mean_square_off(found, 2), 1, 0.3);
  EXPECT_LT(found.report.error[0], 0.1);
  EXPECT_LT(std::abs(found.sums.derived.mean(0)), 3 * found.sums.derived.error(0) + 1e-3);
  const CellLocator locator(mesh);
  const auto seen = walk_back_from({{Vec3(0.4, 0.5, 0.2), {}}, {Vec3(0, 0.5, 0.5), Vec3(1, 0, 0)}}, problem,
                                   locator, {4000, 1, 2});
  EXPECT_NEAR(seen[0][0].fluence.value, 8 * pi, 3 * seen[0][0].fluence.error);
  EXPECT_NEAR(seen[0][0].net_flux[0].value, 0, 3 * seen[0][0].net_flux[0].error);
  EXPECT_NEAR(seen[1][0].irradiance->value, 2 * pi, 3 * seen[1][0].irradiance->error);
}

// The same in the plane, where the radiance is per radian.
TEST(FormulaEmission, KeepsAFurnaceInThePlane) {
  const TetrahedralMesh mesh = cube_mesh(0.03);
  Medium medium = emitting(1, "2*(1 + 0.5*wx)");
  medium.scattering = {Coefficient(1)};
  medium.absorption_by_direction = {AngularFormula("1 + 0.5*wx")};
  std::vector<Wall> walls(mesh.wall_names().size(), emitter("1.4 + 0*x", 0.3));
  for (const char* name : {"zmin", "zmax"}) walls[wall_of(mesh, name)] = uniform_wall(1, 0, 0, 1);
  const Problem problem(mesh, {}, {medium}, walls, AngularSpace::plane);
  const PhotonSolution found = solved(problem, 20000);
  EXPECT_NEAR(region_powers(problem, found.solution)[0][0].emitted, 4 * pi, 1e-9);
  EXPECT_NEAR(wall_powers(problem, found.solution)[wall_of(mesh, "xmin")][0].emitted, 2.8, 1e-5);
  EXPECT_NEAR(mean_square_off(found, 1), 1, 0.3);
  EXPECT_LT(found.report.error[0], 0.1);
}

// A void between mirrors: what travels upwards arrives above, and its moments over the height are those of
// the formula, which is linear in cells.
TEST(FormulaEmission, SendsWhatTheFormulaSays) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 1));
  const std::size_t top = wall_of(mesh, "zmax"), bottom = wall_of(mesh, "zmin");
  walls[top] = walls[bottom] = uniform_wall(1, 0, 0, 0);
  const Problem problem(mesh, {}, {emitting(0, "z*max(0, wz)")}, walls);
  const PhotonSolution found = solved(problem, 20000);
  const auto powers = wall_powers(problem, found.solution);
  EXPECT_NEAR(region_powers(problem, found.solution)[0][0].emitted, pi / 2, 1e-9);
  EXPECT_NEAR(powers[top][0].incoming, pi / 2, 1e-9);
  EXPECT_EQ(powers[bottom][0].incoming, 0);
  // Of the power z at the height z each unit goes 1 - z upwards at a mean slope of 1/wz, by its share of wz.
  double fluence = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    fluence += mesh.volume(CellIndex(c)) * found.sums.cell_means.mean(CellIndex(c).at());
  EXPECT_NEAR(fluence, 2 * pi / 6, 0.02);
}

// A soft beam: the power is known in closed form, and the flux at a point as both ways tell.
TEST(FormulaEmission, WallsSendBeams) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  const std::size_t lit = wall_of(mesh, "xmin"), far = wall_of(mesh, "xmax");
  walls[lit] = emitter("3*exp(-40*(1 - wx))", 0);
  const Problem problem(mesh, {}, {uniform_medium(1, 0.2, 0.5, 0)}, walls);
  const PhotonSolution found = solved(problem, 20000, [&](const Solution& batch) {
    return std::vector<double>{wall_powers(problem, batch)[far][0].incoming};
  });
  EXPECT_NEAR(wall_powers(problem, found.solution)[lit][0].emitted, 6 * pi * (1.0 / 40 - 1.0 / 1600), 1e-6);
  EXPECT_LT(std::abs(balances(problem, found.solution)[0].residual), 1e-3);
  // The mean irradiance of the far wall by points on it.
  std::vector<PhotonProbe> probes;
  constexpr int side = 8;
  for (int i = 0; i < side; ++i)
    for (int k = 0; k < side; ++k)
      probes.push_back({Vec3(1, (i + 0.5) / side, (k + 0.5) / side), Vec3(-1, 0, 0)});
  const CellLocator locator(mesh);
  double mean = 0, variance = 0;
  for (const auto& probe : walk_back_from(probes, problem, locator, {4000, 1, 2})) {
    mean += probe[0].irradiance->value / (side * side);
    variance += std::pow(probe[0].irradiance->error / (side * side), 2);
  }
  const double error = std::hypot(found.sums.derived.error(0), std::sqrt(variance));
  EXPECT_NEAR(mean, found.sums.derived.mean(0), 3 * error);
  EXPECT_LT(error, 0.02 * mean);
}

TEST(FormulaEmission, RefusesNegativeValuesWithTheDirection) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  Medium medium = emitting(1, "0.5 - wz");
  medium.origin = {"case.toml", 7, "media.fog"};
  const Problem problem = uniform_problem(mesh, medium, uniform_wall(1, 0, 0, 0));
  const std::string refusal = refusal_of(problem);
  EXPECT_NE(refusal.find("case.toml:7: media.fog.emission = -"), std::string::npos) << refusal;
}

// Beside a wall that reflects by the angle what leaves walls is counted, what formulas emit once.
TEST(FormulaEmission, LeavesAWallOnce) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  const std::size_t lit = wall_of(mesh, "xmin");
  walls[lit] = emitter("1 + 0*x", 0);
  walls[wall_of(mesh, "xmax")].refractive_index = 1.5;
  const Problem problem(mesh, {}, {uniform_medium(1, 0.2, 0, 0)}, walls);
  const PhotonSolution found = solved(problem, 2000);
  double leaves = 0;
  for (std::size_t i = 0; i < found.solution.exitance.size(); ++i)
    if (const FaceIndex face(static_cast<std::int64_t>(i / 3)); mesh.wall(face) == static_cast<int>(lit))
      leaves += found.solution.exitance[i] * mesh.area(face) / 3;
  EXPECT_NEAR(leaves, pi, 1e-6);
}

}  // namespace
}  // namespace etendue::formula_emission_test
