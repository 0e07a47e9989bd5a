// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/solve/solve_radiosity.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "solver/solution/balance.h"
#include "tests/solver/radiosity/radiosity_samples.h"
#include "tests/support/checkout.h"

namespace etendue::solve_radiosity_test {
namespace {

struct CubeRow {
  double reflectance, emitting, opposite, adjacent;
};

/// The irradiances of validation/reference/radiosity_cube_6x6.csv.
std::vector<CubeRow> cube_rows() {
  std::ifstream file(test::checkout("validation/reference/radiosity_cube_6x6.csv"));
  std::vector<CubeRow> rows;
  for (std::string line; std::getline(file, line);) {
    std::istringstream text(line);
    double value[7];
    char comma;
    text >> value[0];
    for (int i = 1; i < 7; ++i) text >> comma >> value[i];
    if (text) rows.push_back({value[0], value[4], value[5], value[6]});
  }
  return rows;
}

RadiosityOptions options_of(double size, RadiosityMethod method) {
  RadiosityOptions options;
  options.patch_size = size;
  options.method = method;
  options.limits = {1e-12, 2000};
  return options;
}

// One patch for each wall: three solutions of the same system of six equations.
TEST(SolveRadiosity, TheCubeOfSixPatchesIsThatOfTheTable) {
  const TetrahedralMesh mesh(kuhn_cube_raw());
  const std::vector<CubeRow> rows = cube_rows();
  ASSERT_EQ(rows.size(), 3u);
  for (const RadiosityMethod method :
       {RadiosityMethod::direct, RadiosityMethod::gathering, RadiosityMethod::shooting})
    for (const CubeRow& row : rows) {
      const Problem problem = empty_room(mesh, row.reflectance, "zmin");
      RadiosityRoom room(problem, options_of(2, method));
      EXPECT_EQ(room.patches().patches.size(), 6u);
      const Solution solution = room.solve();
      EXPECT_TRUE(solution.converged());
      EXPECT_NEAR(mean_on(mesh, solution.irradiance, "zmin"), row.emitting, 2e-9);
      EXPECT_NEAR(mean_on(mesh, solution.irradiance, "zmax"), row.opposite, 2e-9);
      EXPECT_NEAR(mean_on(mesh, solution.irradiance, "xmin"), row.adjacent, 2e-9);
      EXPECT_LT(std::abs(balances(problem, solution)[0].residual), 1e-10);
    }
}

TEST(SolveRadiosity, FactorsOfACubeMeetTheirChecks) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = empty_room(mesh, 0.5, "zmin");
  const RadiosityRoom room(problem, options_of(0, RadiosityMethod::gathering));
  const RadiosityReport& report = room.report();
  EXPECT_TRUE(report.convex);
  EXPECT_EQ(report.patches, static_cast<std::size_t>(mesh.boundary_face_count()));
  EXPECT_LT(report.checks.row_sum, 1e-6);
  EXPECT_LT(report.checks.closed_row_sum, 1e-11);
  EXPECT_LT(report.checks.reciprocity, 1e-6);
  EXPECT_LT(report.checks.additivity, 1e-6);
  EXPECT_EQ(report.checks.self, 0);
  EXPECT_GT(report.checks.row_sum, 0);
}

// A_a F_ab = A_b F_ba, and rows sum to one: with a crate in the room too.
TEST(SolveRadiosity, FactorsOfWallsAreReciprocalAndClosed) {
  const TetrahedralMesh mesh = room_with_crate(0.1);
  const Problem problem = empty_room(mesh, 0.5, "zmin");
  const RadiosityRoom room(problem, options_of(0.5, RadiosityMethod::gathering));
  const std::vector<double>& factors = room.report().wall_factors;
  const std::size_t walls = mesh.wall_names().size();
  ASSERT_EQ(factors.size(), walls * walls);
  std::vector<double> area(walls, 0);
  for (std::size_t p = 0; p < room.patches().patches.size(); ++p)
    area[static_cast<std::size_t>(room.patches().walls[p])] += room.patches().patches[p].area();
  for (std::size_t a = 0; a < walls; ++a) {
    double sum = 0;
    for (std::size_t b = 0; b < walls; ++b) {
      sum += factors[a * walls + b];
      EXPECT_NEAR(area[a] * factors[a * walls + b], area[b] * factors[b * walls + a], 1e-12);
    }
    EXPECT_NEAR(sum, 1, 1e-10);
  }
}

// All walls have the same radiosity: then so has every point, and nothing flows.
TEST(SolveRadiosity, AFurnaceIsEvenInside) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  const Problem plain = empty_room(mesh, 0.3, "none");
  std::vector<Wall> walls(plain.walls().begin(), plain.walls().end());
  for (Wall& wall : walls) wall.radiance = {0.7};
  const Problem problem(mesh, Bands{}, {plain.media().begin(), plain.media().end()}, walls);
  RadiosityRoom room(problem, options_of(0, RadiosityMethod::gathering));
  const Solution solution = room.solve();
  ASSERT_EQ(solution.fluence.size(), 4 * mesh.volumes().size());
  ASSERT_EQ(solution.net_flux.size(), 3 * solution.fluence.size());
  for (const double fluence : solution.fluence) EXPECT_NEAR(fluence, 4 * M_PI, 1e-9);
  for (const double flux : solution.net_flux) EXPECT_NEAR(flux, 0, 1e-9);
  const WallLightValue value = room.light(4, 1).at(Vec3(0.4, 0.3, 0.6), Vec3::UnitX());
  EXPECT_NEAR(value.fluence[0], 4 * M_PI, 1e-9);
  EXPECT_NEAR(value.irradiance[0], M_PI, 1e-9);
}

// A point on a wall sees it in half of all directions, on whichever side rounding has put it.
TEST(SolveRadiosity, APointOnAWallHasItsLight) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  const Problem plain = empty_room(mesh, 0, "none");
  std::vector<Wall> walls(plain.walls().begin(), plain.walls().end());
  for (Wall& wall : walls) wall.radiance = {wall.name == "zmin" ? 1.0 : 0.0};
  const Problem problem(mesh, Bands{}, {plain.media().begin(), plain.media().end()}, walls);
  RadiosityRoom room(problem, options_of(0, RadiosityMethod::gathering));
  room.solve();
  const WallLightField light = room.light(4, 1);
  for (const double height : {-1e-15, 0.0, 1e-15, 1e-12}) {
    const WallLightValue value = light.at(Vec3(0.43, 0.32, height));
    EXPECT_NEAR(value.fluence[0], 2 * M_PI, 1e-6) << height;
    EXPECT_NEAR(value.net_flux[0].z(), M_PI, 1e-6) << height;
  }
}

TEST(SolveRadiosity, RefusesWhatItDoesNotKnowWithTheLine) {
  const TetrahedralMesh mesh(kuhn_cube_raw());
  const Problem plain = empty_room(mesh, 0.3, "zmin");
  std::vector<Wall> walls(plain.walls().begin(), plain.walls().end());
  std::vector<Medium> media(plain.media().begin(), plain.media().end());
  walls[0].radiance = {1};
  walls[0].refractive_index = 1.5;
  walls[0].diffuse = {0};
  media[0].scattering = {Coefficient(0.5)};
  const Problem problem(mesh, Bands{}, media, walls);
  try {
    refuse_for_radiosity(problem);
    FAIL();
  } catch (const InputError& error) {
    ASSERT_EQ(error.faults().size(), 2u);
    EXPECT_EQ(error.faults()[0].line, 3);
    EXPECT_NE(std::string(error.what()).find("is refracted"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace etendue::solve_radiosity_test
