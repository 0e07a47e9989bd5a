// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/photon_map/map_radiance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/geometry/primitives/sheet_shape.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "tests/solver/observe/photon_map/map_samples.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::map_radiance_test {
namespace {

using std::numbers::pi;

constexpr double u = 2;  // radiance of the furnace, everywhere and in all directions

/// One band at one temperature: u = 2 everywhere.
Problem furnace(const TetrahedralMesh& mesh, double specular = 0) {
  return uniform_problem(mesh, uniform_medium(1, 0.8, 2.0, 0.8 * u, PhaseHenyeyGreenstein{0.4}),
                         uniform_wall(1, (0.6 - specular) * u, 0.4, specular));
}

Vec3 random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Vec3(normal(random), normal(random), normal(random)).normalized();
}

Vec3 random_point(std::mt19937& random) {
  std::uniform_real_distribution<double> number(0, 1);
  return {number(random), number(random), number(random)};
}

Deviation at_walls(const MapRadiance& map, int count) {
  const TetrahedralMesh& mesh = map.problem().mesh();
  MapRadiance::Workspace work;
  return deviation(count, pi * u, [&](int i) {
    const FaceIndex face(i * 7919 % mesh.boundary_face_count());
    // Near a corner of the face, where discs reach over the edges of walls.
    const Vec3 point = 0.1 * mesh.centroid(face) + 0.9 * mesh.point(VertexIndex(mesh.vertices(face)[0]));
    return map.irradiance(face, point, 0, work);
  });
}

Deviation in_matter(const MapRadiance& map, int count) {
  std::mt19937 random(5);
  const CellLocator locator(map.problem().mesh());
  MapRadiance::Workspace work;
  return deviation(count, 2 * u, [&](int) {
    const Vec3 point = random_point(random);
    return map.scattered(locator.find(point).front().cell, point, random_direction(random), 0, work);
  });
}

// Neighbouring points share hits, and the ball's volume beside walls is known to 1 %.
void expect_statistical(const Deviation& found) {
  EXPECT_NEAR(found.mean, 0, 0.25);
  EXPECT_NEAR(found.rms, 1, 0.25);
}

TEST(MapRadiance, IsThatOfAFurnaceWithinItsErrorsWhichFall) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = furnace(mesh);
  const MapRadiance coarse = map_of(problem, 10000, 25), fine = map_of(problem, 90000, 225);
  const Deviation walls[] = {at_walls(coarse, 200), at_walls(fine, 200)};
  const Deviation matter[] = {in_matter(coarse, 200), in_matter(fine, 200)};
  for (const auto& found : {walls, matter}) {
    expect_statistical(found[0]);
    expect_statistical(found[1]);
    EXPECT_NEAR(found[0].error / found[1].error, 3, 0.3);
  }
  EXPECT_LT(walls[1].error, 0.1);
  EXPECT_LT(matter[1].error, 0.11);
}

TEST(MapRadiance, IsThatOfAFurnaceAlongRaysAndThroughMirrors) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  for (const double specular : {0.0, 0.3}) {
    const Problem problem = furnace(mesh, specular);
    const MapRadiance map = map_of(problem, 40000, 100);
    std::mt19937 random(6);
    const CellLocator locator(mesh);
    MapRadiance::Workspace work;
    const int rays = 40;
    double mean = 0, square = 0;
    for (int i = 0; i < rays; ++i) {
      const Vec3 point = random_point(random);
      const double found =
          map.along({locator.find(point).front().cell, point}, random_direction(random), 0, work) / u;
      mean += found / rays;
      square += std::pow(found - 1, 2) / rays;
    }
    // Estimates of 100 hits are off by 13 %, and a third of the light is emitted, which has no error.
    EXPECT_NEAR(mean, 1, 0.03);
    EXPECT_LT(std::sqrt(square), 0.09);
  }
}

// A furnace whose radiance is that behind the walls times the square of their index.
TEST(MapRadiance, IsThatOfAFurnaceBehindWallsThatRefract) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  Wall wall = uniform_wall(1, u / (1.5 * 1.5), 0, 0);
  wall.refractive_index = 1.5;
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.8, 2, 0.8 * u), wall);
  const MapRadiance map = map_of(problem, 40000, 100);
  std::mt19937 random(7);
  const CellLocator locator(mesh);
  MapRadiance::Workspace work;
  const int rays = 40;
  double mean = 0;
  for (int i = 0; i < rays; ++i) {
    const Vec3 point = random_point(random);
    mean +=
        map.along({locator.find(point).front().cell, point}, random_direction(random), 0, work) / u / rays;
  }
  EXPECT_NEAR(mean, 1, 0.03);
}

TEST(MapRadiance, SeesRadianceByAFormula) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  Wall wall = uniform_wall(1, 0, 0, 0);
  wall.radiance_by_direction = {AngularFormula("2 + x + max(0, wz)")};
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0, 0, 0), wall);
  const MapRadiance map = map_of(problem, 1000, 10);
  const CellLocator locator(mesh);
  MapRadiance::Workspace work;
  const Vec3 point(0.5, 0.4, 0.3), direction = Vec3(3, 0, -4) / 5;
  const PointInCell start{locator.find(point).front().cell, point};
  EXPECT_NEAR(map.along(start, direction, 0, work), 2 + 0.5 + 0.3 * 3 / 4 + 0.8, 1e-9);
}

// The integral of (1 + 2 y) e^(-s y) over the slab, s its extinction.
TEST(MapRadiance, SeesLinearEmission) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  Medium medium = uniform_medium(1, 2.5, 0, 0);
  medium.emission = {Coefficient(Expression("1 + 2*y", {"x", "y", "z"}))};
  const Problem problem = uniform_problem(mesh, medium, uniform_wall(1, 0, 0, 0));
  const MapRadiance map = map_of(problem, 1000, 10);
  const CellLocator locator(mesh);
  MapRadiance::Workspace work;
  const Vec3 point(0.31, 0, 0.4);
  const double s = 2.5, expected = (1 - std::exp(-s)) / s + 2 * (1 - (1 + s) * std::exp(-s)) / (s * s);
  EXPECT_NEAR(map.along({locator.find(point).front().cell, point}, Vec3::UnitY(), 0, work), expected, 1e-13);
}

// A beam of irradiance 3 on a plane across it, which falls on a wall at 60 degrees.
TEST(MapRadiance, IsThatOfALitWall) {
  const TetrahedralMesh mesh = cube_mesh(0.005);
  std::vector<Wall> walls(6, uniform_wall(1, 0, 0, 0));
  walls[4].diffuse = {0.7};
  const double c = 0.5, s = std::sqrt(0.75);
  const Light beam{"sun", BeamLight{{s, 0, -c}, {3}, {5, 0}}, {}};
  for (std::size_t w = 0; w < walls.size(); ++w) walls[w].name = mesh.wall_names()[w];
  const Problem problem(mesh, {}, {uniform_medium(1, 0, 0, 0)}, walls, AngularSpace::sphere, {beam});
  const MapRadiance map = map_of(problem, 40000, 100);
  MapRadiance::Workspace work;
  std::vector<FaceIndex> lit;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    if (mesh.wall(FaceIndex(f)) == 4) lit.emplace_back(f);
  const Deviation found = deviation(static_cast<int>(lit.size()), 0.7 / pi * 3 * c, [&](int i) {
    const FaceIndex face = lit[static_cast<std::size_t>(i)];
    return map.reflected(face, mesh.centroid(face), Vec3::UnitZ(), 0, work);
  });
  EXPECT_NEAR(found.mean, 0, 0.4);
  EXPECT_NEAR(found.rms, 1, 0.3);
  EXPECT_NEAR(found.error, 0.1, 0.01);
}

// A wall-to-wall sheet: one half of the floor is lit, the other dark to its foot.
TEST(MapRadiance, DoesNotPassUnderASheet) {
  Geometry geometry;
  BoxPrimitive room;
  room.region = "air";
  room.walls = {{"zmin", "floor"}, {"xmin", "lamp"}};
  geometry.primitives.emplace_back(room);
  geometry.sheets.push_back({rectangle_corners({0.5, 0, 0}, {0.5, 1, 1}), "west", "east", {}});
  const TetrahedralMesh mesh(tetrahedralize(arrange(geometry), {{0.01}, 1.4, {}}));
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, name == "lamp" ? 1 : 0, 0.5, 0));
    walls.back().name = name;
  }
  const Problem problem(mesh, {}, {uniform_medium(1, 0, 0, 0)}, walls);
  const MapRadiance map = map_of(problem, 50000, 100);
  MapRadiance::Workspace work;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const Vec3 center = mesh.centroid(FaceIndex(f));
    if (center.z() > 1e-9) continue;
    const double found = map.irradiance(FaceIndex(f), center, 0, work).value;
    if (center.x() > 0.5)
      EXPECT_EQ(found, 0);
    else
      EXPECT_GT(found, 0.3);
  }
}

}  // namespace
}  // namespace etendue::map_radiance_test
