// SPDX-License-Identifier: AGPL-3.0-or-later
// Opaque sheets inside the domain, by all three methods.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/geometry/primitives/sheet_shape.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "solver/photons/solve/solve_photons.h"
#include "solver/radiosity/solve/solve_radiosity.h"
#include "solver/solution/balance.h"
#include "solver/uncollided/first_collision/solve_split.h"
#include "tests/solver/methods/sheet_rooms.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::sheet_light_test {
namespace {

using std::numbers::pi;

/// The unit cube with one horizontal sheet of walls "top" and "under".
TetrahedralMesh room_with_sheet(const Vec3& min, const Vec3& max, double max_volume) {
  Geometry geometry;
  BoxPrimitive room;
  room.region = "air";
  room.walls = {{"zmin", "floor"}};
  geometry.primitives.emplace_back(room);
  geometry.sheets.push_back({rectangle_corners(min, max), "top", "under", {}});
  return TetrahedralMesh(tetrahedralize(arrange(geometry), {{max_volume}, 1.4, {}}));
}

/// Largest fluence in cells on one side of the plane z = 0.5.
double largest_fluence(const TetrahedralMesh& mesh, const Solution& solution, bool above) {
  double largest = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    for (std::size_t i = 0; i < 4; ++i)
      if ((mesh.centroid(CellIndex(c)).z() > 0.5) == above)
        largest = std::max(largest, std::abs(solution.fluence[4 * CellIndex(c).at() + i]));
  return largest;
}

const Medium haze = uniform_medium(1, 0.3, 1, 0);
const Medium nothing = uniform_medium(1, 0, 0, 0);
const TetrahedralMesh& divided() {
  static const TetrahedralMesh mesh = room_with_sheet({0, 0, 0.5}, {1, 1, 0.5}, 0.03);
  return mesh;
}
const TetrahedralMesh& with_table() {
  static const TetrahedralMesh mesh = room_with_sheet({0.25, 0.25, 0.5}, {0.75, 0.75, 0.5}, 0.01);
  return mesh;
}

TEST(SheetLight, WhatIsBehindAWallToWallSheetStaysDark) {
  const TetrahedralMesh& mesh = divided();
  const Problem problem = room(mesh, haze, {{"floor", {1, 0.5}}, {"under", {0, 0.5}}});
  const Problem clear = room(mesh, nothing, {{"floor", {1, 0.5}}, {"under", {0, 0.5}}});
  for (const Solution& solution :
       {by_ordinates(problem), by_photons(problem, 500).solution, by_radiosity(clear)}) {
    EXPECT_EQ(largest_fluence(mesh, solution, true), 0);
    EXPECT_GT(largest_fluence(mesh, solution, false), 1);
  }
}

// A lamp on a sheet shines to both of its sides.
TEST(SheetLight, OfALampOnTheSheetBalances) {
  PointLight lamp;
  lamp.position = {0.45, 0.55, 0.5};
  lamp.power = {1};
  for (const TetrahedralMesh* mesh : {&divided(), &with_table()}) {
    const Problem problem = room(*mesh, haze, {{"under", {0, 0.5}}}, {}, {{"lamp", lamp, {}}});
    for (const Solution& solution : {by_ordinates(problem), by_photons(problem, 500).solution}) {
      EXPECT_NEAR(balances(problem, solution)[0].residual, 0, 1e-3);
      EXPECT_GT(largest_fluence(*mesh, solution, true), 0.1);
      EXPECT_GT(largest_fluence(*mesh, solution, false), 0.1);
    }
  }
}

// Everything at one temperature: u = 2 everywhere, whatever the sides of the sheet reflect.
TEST(SheetLight, FurnaceDoesNotSeeTheSheet) {
  const double u = 2;
  const auto wall = [&](double diffuse) { return Surface{(1 - diffuse) * u, diffuse}; };
  std::map<std::string, Surface> walls{{"top", wall(0.8)}, {"under", wall(0.1)}, {"floor", wall(0.5)}};
  for (const char* side : {"xmin", "xmax", "ymin", "ymax", "zmax"}) walls[side] = wall(0.3);
  const Problem hazy = room(with_table(), uniform_medium(1, 0.7, 1.3, 0.7 * u), walls);
  const Solution found = solve(hazy, directions_ldfe_sq(1), tight_options());
  EXPECT_LT(largest_deviation(found.fluence, 4 * pi * u), 1e-8);
  const Problem clear = room(with_table(), nothing, walls);
  EXPECT_LT(largest_deviation(by_radiosity(clear).irradiance, pi * u), 1e-8);
}

// Else the light on one side of a sheet's foot would come out on the other.
TEST(SheetLight, PatchesEndAtTheFootOfASheet) {
  const TetrahedralMesh mesh = room_with_sheet({0.6, 0, 0}, {0.6, 1, 0.5}, 0.01);
  int of_floor = 0;
  for (const FlatPatch& patch : wall_patches(mesh, 1).patches) {
    if (patch.normal().z() < 0.5) continue;
    ++of_floor;
    for (const TriangleCorners& triangle : patch.triangles())
      for (const Vec3& corner : triangle)
        EXPECT_GE((corner.x() - 0.6) * (patch.centroid().x() - 0.6), -1e-12);
  }
  EXPECT_EQ(of_floor, 2);
}

TEST(SheetLight, EachSideHasItsOwnReflectance) {
  const Problem problem =
      room(with_table(), haze, {{"floor", {1, 0}}, {"top", {0, 0.25}}, {"under", {0, 0.75}}});
  const Solution solution = by_ordinates(problem);
  for (const auto& [wall, diffuse] : {std::pair{"top", 0.25}, {"under", 0.75}}) {
    const WallPower power = power_on(problem, solution, wall);
    EXPECT_NEAR(power.area, 0.25, 1e-12);
    EXPECT_NEAR(power.outgoing, diffuse * power.incoming, 1e-9);
  }
  EXPECT_NEAR(balances(problem, solution)[0].residual, 0, 1e-8);
}

TEST(SheetLight, MethodsAgreeOnBothSides) {
  const std::map<std::string, Surface> walls{
      {"floor", {1, 0.3}}, {"top", {0, 0.25}}, {"under", {0, 0.75}}, {"zmax", {0, 0.5}}};
  const Problem clear = room(with_table(), nothing, walls), hazy = room(with_table(), haze, walls);
  const PhotonSolution clear_photons = by_photons(clear, 50000), hazy_photons = by_photons(hazy, 50000);
  const Solution radiosity = by_radiosity(clear);
  const Solution ordinates = solve(hazy, directions_ldfe_sq(2), tight_options());
  EXPECT_NEAR(balances(clear, radiosity)[0].residual, 0, 1e-8);
  for (std::size_t w = 0; w < with_table().wall_names().size(); ++w) {
    const std::string& wall = with_table().wall_names()[w];
    // Patches and cells are a fifth of the room wide.
    const double lit = clear_photons.sums.derived.mean(w), dim = hazy_photons.sums.derived.mean(w);
    EXPECT_NEAR(power_on(clear, radiosity, wall).incoming, lit,
                3 * clear_photons.sums.derived.error(w) + 0.02 * lit)
        << wall;
    EXPECT_NEAR(power_on(hazy, ordinates, wall).incoming, dim,
                3 * hazy_photons.sums.derived.error(w) + 0.02 * dim)
        << wall;
  }
}

/// A lamp above the table: what the table hides of the floor is known.
TEST(SheetLight, ALampsShadowIsExact) {
  PointLight point;
  point.position = {0.5, 0.5, 0.75};
  point.power = {4 * pi};
  const Problem problem = room(with_table(), nothing, {}, {}, {{"lamp", point, {}}});
  const Solution solution = by_ordinates(problem);
  EXPECT_EQ(power_on(problem, solution, "under").incoming, 0);
  // The solid angle of a square of half side a at distance h (Khadjavi 1968).
  const auto solid_angle = [](double a, double h) { return 4 * std::asin(a * a / (a * a + h * h)); };
  EXPECT_NEAR(power_on(problem, solution, "top").incoming, solid_angle(0.25, 0.25), 2e-3);
  // The shadow of the table is three times as wide, so that it hides more than the floor.
  EXPECT_EQ(power_on(problem, solution, "floor").incoming, 0);
  EXPECT_NEAR(solution.lights.balance[0].residual, 0, 5e-3);
}

/// The top shines, by rays since it is small: nothing of it comes below its plane.
TEST(SheetLight, WhatOneSideSendsDoesNotReachTheOther) {
  const Problem problem = room(with_table(), nothing, {{"top", {1, 0}}});
  const LightSetup lights(problem);
  ASSERT_FALSE(lights.empty());
  const Solution solution = solve_split(lights, directions_ldfe_sq(1), tight_options());
  EXPECT_EQ(power_on(problem, solution, "under").incoming, 0);
  EXPECT_EQ(power_on(problem, solution, "floor").incoming, 0);
  EXPECT_EQ(power_on(problem, solution, "top").incoming, 0);
  EXPECT_NEAR(power_on(problem, solution, "top").outgoing, pi / 4, 1e-12);
  EXPECT_NEAR(solution.lights.balance[0].residual, 0, 5e-3);
}

}  // namespace
}  // namespace etendue::sheet_light_test
