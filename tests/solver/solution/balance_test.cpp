// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/solution/balance.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/solver/problem/cube_mesh.h"
#include "tests/solver/solution/synthetic_solution.h"

namespace etendue::balance_test {
namespace {

using std::numbers::pi;

/// Unit cube, two bands; the left half absorbs 2 and 3, the right half 0 and 0.5.
Problem two_halves(const TetrahedralMesh& mesh, double emission, double radiance) {
  const std::vector<PhaseFunction> phase(2, PhaseIsotropic{});
  return Problem(mesh, Bands{{"a", "b"}, {}},
                 {{"left", {2.0, 3.0}, {0.0, 0.0}, {emission, 2 * emission}, phase, {}},
                  {"right", {0.0, 0.5}, {0.0, 0.0}, {0.0, 0.0}, phase, {}}},
                 {{"floor", {radiance, 3 * radiance}, {0.5, 0.0}, {0.0, 0.0}, {}},
                  {"rest", {0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}, {}}});
}

Vec3 no_flux(const Vec3&, int) { return Vec3::Zero(); }

TEST(Balance, AbsorbsTheMeanOfALinearFluence) {
  const TetrahedralMesh mesh = cube_mesh();
  const Problem problem = two_halves(mesh, 0, 0);
  const Solution solution = solution_from(
      problem, [](const Vec3& x, int band) { return (1 + band) * (1 + x.z()); }, no_flux);
  const auto regions = region_powers(problem, solution);
  // Each half is a prism of volume 1/2 whose mean z is 1/2.
  for (const auto& region : regions)
    for (std::size_t band = 0; band < 2; ++band) {
      EXPECT_NEAR(region[band].volume, 0.5, 1e-15);
      EXPECT_NEAR(region[band].fluence_mean, 1.5 * (1.0 + static_cast<double>(band)), 1e-14);
    }
  EXPECT_NEAR(regions[0][0].absorbed, 2 * 1.5 / 2, 1e-14);
  EXPECT_NEAR(regions[0][1].absorbed, 3 * 3.0 / 2, 1e-14);
  EXPECT_EQ(regions[1][0].absorbed, 0);
  EXPECT_NEAR(regions[1][1].absorbed, 0.5 * 3.0 / 2, 1e-14);
}

TEST(Balance, EmitsFourPiTimesTheSourceAndTheVolume) {
  const TetrahedralMesh mesh = cube_mesh();
  const Problem problem = two_halves(mesh, 0.7, 0);
  const auto regions = region_powers(problem, solution_from(
                                                  problem, [](const Vec3&, int) { return 0.0; }, no_flux));
  EXPECT_NEAR(regions[0][0].emitted, 4 * pi * 0.7 / 2, 1e-14);
  EXPECT_NEAR(regions[0][1].emitted, 4 * pi * 1.4 / 2, 1e-14);
  EXPECT_EQ(regions[1][0].emitted, 0);
}

/// Walls on which irradiance and exitance are linear in x: 1 + x and 2 + x, times the band's number.
Solution with_walls(const Problem& problem, double half_range) {
  const TetrahedralMesh& mesh = problem.mesh();
  Solution solution = solution_from(
      problem, [](const Vec3&, int) { return 0.0; }, no_flux);
  for (int f = 0; f < mesh.boundary_face_count(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t band = 0; band < 2; ++band) {
        const double x = mesh.point(VertexIndex(mesh.vertices(FaceIndex(f))[i])).x();
        const std::size_t at = (static_cast<std::size_t>(f) * 3 + i) * 2 + band;
        solution.irradiance[at] = (1 + x) * static_cast<double>(band + 1);
        solution.exitance[at] = (2 + x) * static_cast<double>(band + 1);
      }
  solution.half_range.assign(solution.half_range.size(), half_range);
  return solution;
}

TEST(Balance, IntegratesIrradianceAndExitanceOverWalls) {
  const TetrahedralMesh mesh = cube_mesh();
  const Problem problem = two_halves(mesh, 0, 0.25);
  const auto walls = wall_powers(problem, with_walls(problem, 3.1));
  for (std::size_t band = 0; band < 2; ++band) {
    const double scale = static_cast<double>(band + 1);
    const WallPower &floor = walls[0][band], &rest = walls[1][band];
    EXPECT_NEAR(floor.area, 1, 1e-15);
    EXPECT_NEAR(rest.area, 5, 1e-14);
    EXPECT_NEAR(floor.irradiance_mean, 1.5 * scale, 1e-14);
    EXPECT_NEAR(floor.incoming, 1.5 * scale, 1e-14);
    EXPECT_NEAR(floor.outgoing, 2.5 * scale, 1e-14);
    EXPECT_NEAR(rest.incoming, 7.5 * scale, 1e-13);
    const double radiance = band == 0 ? 0.25 : 0.75;
    EXPECT_NEAR(floor.emitted, 3.1 * radiance, 1e-14);
    EXPECT_NEAR(floor.emitted_exact, pi * radiance, 1e-14);
    EXPECT_EQ(rest.emitted, 0);
  }
}

TEST(Balance, CountsWhatWallsKeepAsOutflow) {
  const TetrahedralMesh mesh = cube_mesh();
  const Problem problem = two_halves(mesh, 0.7, 0.25);
  const Balance balance = balances(problem, with_walls(problem, 3.1))[0];
  EXPECT_NEAR(balance.emitted, 4 * pi * 0.35, 1e-14);
  EXPECT_NEAR(balance.inflow, 3.1 * 0.25, 1e-14);
  EXPECT_EQ(balance.absorbed, 0);
  // Incoming 9 over the cube; sent out 15, of which the floor emitted 0.775.
  EXPECT_NEAR(balance.outflow, 9 - (15 - 0.775), 1e-13);
  const double given = balance.emitted + balance.inflow;
  EXPECT_NEAR(balance.residual, (given - balance.outflow) / given, 1e-14);
}

TEST(Balance, ClosesInAnIsothermalEnclosure) {
  // u = 0.4 everywhere: the medium emits what it absorbs, and the black walls send what arrives.
  const TetrahedralMesh mesh = cube_mesh();
  const double radiance = 0.4;
  const std::vector<PhaseFunction> phase(1, PhaseIsotropic{});
  const Problem problem(
      mesh, Bands{},
      {{"left", {2.0}, {1.0}, {2 * radiance}, phase, {}}, {"right", {3.0}, {0.0}, {3 * radiance}, phase, {}}},
      {{"floor", {radiance}, {0.0}, {0.0}, {}}, {"rest", {radiance}, {0.0}, {0.0}, {}}});
  Solution solution = solution_from(
      problem, [&](const Vec3&, int) { return 4 * pi * radiance; }, no_flux);
  solution.irradiance.assign(solution.irradiance.size(), pi * radiance);
  solution.exitance = solution.irradiance;
  const Balance balance = balances(problem, solution)[0];
  EXPECT_NEAR(balance.emitted, balance.absorbed, 1e-13);
  EXPECT_NEAR(balance.inflow, 6 * pi * radiance, 1e-13);
  EXPECT_NEAR(balance.outflow, balance.inflow, 1e-13);
  EXPECT_NEAR(balance.residual, 0, 1e-14);
}

TEST(Balance, HasNoResidualInTheDark) {
  const TetrahedralMesh mesh = cube_mesh();
  const Problem problem = two_halves(mesh, 0, 0);
  for (const Balance& balance :
       balances(problem, solution_from(
                             problem, [](const Vec3&, int) { return 0.0; }, no_flux)))
    EXPECT_EQ(balance.residual, 0);
}

}  // namespace
}  // namespace etendue::balance_test
