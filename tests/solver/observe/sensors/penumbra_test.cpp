// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Meters in the shadow of a black box under a flat light.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/uncollided/lights/light_irradiance.h"
#include "tests/solver/transport/sample_problems.h"
#include "tests/solver/uncollided/visible_part.h"

namespace etendue::penumbra_test {
namespace {

const Vec3 low(0.35, 0.3, 0.45);
const Vec3 high(0.65, 0.7, 0.5);

TetrahedralMesh room_with_box() {
  Geometry geometry;
  BoxPrimitive room, box;
  room.region = "room";
  box.min = low;
  box.max = high;
  box.hole = true;
  box.name = "box";
  geometry.primitives = {room, box};
  return TetrahedralMesh(tetrahedralize(arrange(geometry), {{4e-3}, 1.4, {}}));
}

/// Clockwise as seen from above, so that it shines down.
const std::vector<Vec3> rim = {{0.3, 0.35, 0.9}, {0.3, 0.65, 0.9}, {0.7, 0.65, 0.9}, {0.7, 0.35, 0.9}};

std::vector<Vec3> corners_of_box() {
  std::vector<Vec3> corners;
  for (const double x : {low.x(), high.x()})
    for (const double y : {low.y(), high.y()})
      for (const double z : {low.z(), high.z()}) corners.emplace_back(x, y, z);
  return corners;
}

// What the box hides of the light is cut off along its edges and the rest is in closed form: nothing is left
// of the difference in the umbra, and where the light is seen whole the closed form is.
TEST(LightIrradiance, InAShadowIsThatOfTheVisiblePart) {
  const TetrahedralMesh mesh = room_with_box();
  const Problem problem(mesh, {}, {uniform_medium(1, 0, 0, 0)},
                        std::vector<Wall>(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0)),
                        AngularSpace::sphere,
                        {{"lamp", SurfaceLight{{rim[0], rim[1], rim[2], rim[0], rim[2], rim[3]}, {1}}, {}}});
  const LightSetup lights(problem);
  const LightIrradiance meter(lights);
  const CellLocator locator(mesh);
  const HalfHiddenLight known(rim, corners_of_box());
  int dark = 0, lit = 0, between = 0;
  double largest = 0;
  for (const double z : {0.02, 0.3})
    for (int i = 0; i < 12; ++i)
      for (int j = 0; j < 12; ++j) {
        const Vec3 place((i + 0.37) / 12, (j + 0.41) / 12, z);
        const UncollidedAtPoint light = meter.at({locator.find(place).front().cell, place}, Vec3::UnitZ());
        const double part = known.visible_area(place) / known.area();
        const VisibleLight seen = known.seen_from(place, 0), whole = known.whole_from(place, 0);
        if (part == 0) {
          ++dark;
          EXPECT_EQ(light.fluence[0], 0.0);
          EXPECT_EQ(light.irradiance[0], 0.0);
        } else if (part > 1 - 1e-12) {
          ++lit;
          EXPECT_NEAR(light.fluence[0] / seen.fluence, 1, 1e-12);
          EXPECT_NEAR(light.irradiance[0] / seen.irradiance, 1, 1e-12);
        } else {
          ++between;
          const double of_fluence = (light.fluence[0] - seen.fluence) / whole.fluence;
          const double of_irradiance = (light.irradiance[0] - seen.irradiance) / whole.irradiance;
          largest = std::max({largest, std::abs(of_fluence), std::abs(of_irradiance)});
        }
      }
  EXPECT_GT(dark, 10);
  EXPECT_GT(lit, 50);
  EXPECT_GT(between, 100);
  EXPECT_LT(largest, 3e-7);
}

// Edges of a ball of many facets are too many to be told apart before a triangle as large as the lamp, which
// is cut face by face then: with a box in the way as bright as a sum over very fine beams.
TEST(LightIrradiance, IsCutAlongABoxBeforeMatterOfManyFacets) {
  Geometry geometry;
  BoxPrimitive room, box;
  room.region = "room";
  box.min = {0.4, 0.4, 0.2};
  box.max = {0.6, 0.6, 0.3};
  box.hole = true;
  box.name = "box";
  SpherePrimitive ball;
  ball.region = "ball";
  ball.center = {0.5, 0.5, 0.6};
  ball.radius = 0.25;
  ball.facets = 320;
  geometry.primitives = {room, box, ball};
  const TetrahedralMesh mesh(tetrahedralize(arrange(geometry), {{4e-3}, 1.4, {}}));
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, name == "zmax" ? 1 : 0, 0, 0));
    walls.back().name = name;
    walls.back().uncollided = Uncollided::yes;
  }
  std::vector<Medium> media;
  for (const std::string& name : mesh.region_names())
    media.push_back(uniform_medium(1, name == "ball" ? 1 : 0, 0, 0));
  const Problem problem(mesh, {}, media, walls);
  const LightSetup lights(problem);
  const LightIrradiance meter(lights);
  LightBeams beams(1);
  for (const double x : {0.5, 0.3, 0.22}) {
    const Vec3 place(x, 0.45, 0.01);
    const PointInCell point{CellLocator(mesh).find(place).front().cell, place};
    beams.clear();
    lights.sources().front()->add_beams(point, Sight::attenuated, {0, 0, 1, 0.01, TriangleRule::seven_points},
                                        beams);
    double sum = 0;
    for (std::size_t i = 0; i < beams.size(); ++i) sum -= beams.direction(i).z() * beams.fluence(i)[0];
    EXPECT_NEAR(meter.at(point, Vec3::UnitZ()).irradiance[0] / sum, 1, 3e-4) << x;
  }
}

// A lamp brings nothing to itself, however rounding puts a point of a slanting one before or behind it.
TEST(LightIrradiance, IsZeroOnTheFaceThatShines) {
  const TetrahedralMesh mesh = cube_mesh(5e-3);
  const std::array<Vec3, 3> lamp = {{{0.21, 0.33, 0.47}, {0.83, 0.29, 0.61}, {0.37, 0.77, 0.71}}};
  const Problem problem(mesh, {}, {uniform_medium(1, 0, 0, 0)},
                        std::vector<Wall>(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0)),
                        AngularSpace::sphere, {{"lamp", SurfaceLight{{lamp[0], lamp[1], lamp[2]}, {1}}, {}}});
  const LightSetup lights(problem);
  const LightIrradiance meter(lights);
  const CellLocator locator(mesh);
  const Vec3 normal = (lamp[1] - lamp[0]).cross(lamp[2] - lamp[0]).normalized();
  for (int i = 1; i < 40; ++i)
    for (int j = 1; i + j < 40; ++j) {
      const Vec3 place = lamp[0] + i / 40.0 * (lamp[1] - lamp[0]) + j / 40.0 * (lamp[2] - lamp[0]);
      const PointInCell point{locator.find(place).front().cell, place};
      EXPECT_LT(meter.at(point, normal).irradiance[0], 1e-12) << i << " " << j;
    }
}

}  // namespace
}  // namespace etendue::penumbra_test
