// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Shadows' edges and bends behind the edges of walls and media: cells are cut along them, so what a lamp or
// the sun brings is smooth in each part.
#include "solver/uncollided/sources/shadow_planes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "solver/uncollided/lights/light_setup.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::shadow_planes_test {
namespace {

enum class Inside { nothing, crate, ball_hole, fog, ball_of_fog };

/// A unit cube "air" with something in it.
TetrahedralMesh room(Inside inside, double max_volume) {
  Geometry geometry;
  BoxPrimitive room;
  room.region = "air";
  geometry.primitives.emplace_back(room);
  BoxPrimitive box;
  box.min = {0.3, 0.4, 0.4};
  box.max = {0.65, 0.7, 0.55};
  SpherePrimitive ball;
  ball.center = {0.5, 0.5, 0.5};
  ball.radius = 0.3;
  ball.facets = 80;
  const auto add = [&](auto shape, bool hole) {
    shape.hole = hole;
    (hole ? shape.name : shape.region) = hole ? "crate" : "fog";
    geometry.primitives.emplace_back(shape);
  };
  if (inside == Inside::crate || inside == Inside::fog) add(box, inside == Inside::crate);
  if (inside == Inside::ball_hole || inside == Inside::ball_of_fog) add(ball, inside == Inside::ball_hole);
  return TetrahedralMesh(tetrahedralize(arrange(geometry), {{max_volume}, 1.4, {}}));
}

Light lamp() {
  PointLight point;
  point.position = {0.43, 0.52, 0.9};
  point.power = {1};
  return {"lamp", point, {}};
}

int wall_of(const TetrahedralMesh& mesh, const std::string& name) {
  const auto& names = mesh.wall_names();
  return static_cast<int>(std::ranges::find(names, name) - names.begin());
}

Light sun(const TetrahedralMesh& mesh) {
  const std::vector<int> walls = {wall_of(mesh, "xmin"), wall_of(mesh, "ymin"), wall_of(mesh, "zmax")};
  return {"sun", BeamLight{Vec3(0.3, 0.2, -0.8).normalized(), {1}, walls}, {}};
}

enum class Mirrors { none, at_right_angles, parallel };

/// Two mirrors that reflect unlike parts, or none.
Problem lit(const TetrahedralMesh& mesh, const Light& light, double extinction,
            Mirrors mirrors = Mirrors::none) {
  std::vector<Medium> media;
  for (const std::string& name : mesh.region_names())
    media.push_back(uniform_medium(1, name == "fog" ? 3 : extinction, 0, 0));
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, 0, 0, 0));
    walls.back().name = name;
    if (mirrors != Mirrors::none && name == "xmax") walls.back().specular = {0.8};
    const char* const other = mirrors == Mirrors::parallel ? "xmin" : "ymax";
    if (mirrors != Mirrors::none && name == other) walls.back().specular = {0.7};
  }
  return Problem(mesh, {}, media, walls, AngularSpace::sphere, {light});
}

/// Part of the power that neither cells nor walls took.
double missing_part(const Problem& problem) {
  const TetrahedralMesh& mesh = problem.mesh();
  const LightSetup lights(problem);
  const UncollidedField field = uncollided_field(lights.paths(), lights.sources(), 2);
  const double sent = lights.sources()[0]->power()[0];
  double missing = sent;
  for (std::size_t i = 0; i < field.fluence.size(); ++i)
    missing -= problem.absorption()[i / 4] * field.fluence[i] * mesh.volumes()[i / 4] / 4;
  for (std::size_t i = 0; i < field.irradiance.size(); ++i) {
    const FaceIndex face(static_cast<std::int64_t>(i / 3));
    missing -= (1 - problem.wall(mesh.wall(face)).specular[0]) * field.irradiance[i] * mesh.area(face) / 3;
  }
  return std::abs(missing) / sent;
}

double length_of(const std::vector<ShadowEdge>& shadow_edges) {
  double length = 0;
  for (const ShadowEdge& edge : shadow_edges) length += (edge.end - edge.begin).norm();
  return length;
}

/// Path length times irradiance that the sun has in a unit cube without what is in it: the fluence of
/// parallel light is the volume it reaches.
double lit_volume(const TetrahedralMesh& mesh) {
  const Problem problem = lit(mesh, sun(mesh), 0);
  const LightSetup lights(problem);
  const UncollidedField field = uncollided_field(lights.paths(), lights.sources(), 2);
  double volume = 0;
  for (std::size_t i = 0; i < field.fluence.size(); ++i)
    volume += field.fluence[i] * mesh.volumes()[i / 4] / 4;
  return volume;
}

// However fine the mesh is.
TEST(ShadowEdges, OfACubeAndABoxInItAreTheirEdges) {
  for (const double max_volume : {0.02, 1e-3}) {
    const TetrahedralMesh cube = room(Inside::nothing, max_volume);
    const std::vector<ShadowEdge> of_cube = shadow_edges_of(LightPaths(lit(cube, lamp(), 1)));
    EXPECT_EQ(of_cube.size(), 12);
    EXPECT_NEAR(length_of(of_cube), 12, 1e-12);
    for (const Inside inside : {Inside::crate, Inside::fog}) {
      const TetrahedralMesh mesh = room(inside, max_volume);
      const std::vector<ShadowEdge> shadow_edges = shadow_edges_of(LightPaths(lit(mesh, lamp(), 1)));
      EXPECT_EQ(shadow_edges.size(), 24);
      EXPECT_NEAR(length_of(shadow_edges), 12 + 4 * (0.35 + 0.3 + 0.15), 1e-12);
    }
  }
}

// Four media that meet along one line: each surface between two of them ends there, if straight into the
// next.
TEST(ShadowEdges, AreWhereFourMediaMeet) {
  Geometry geometry;
  for (int i = 0; i < 4; ++i) {
    BoxPrimitive box;
    box.min = Vec3(0.5 * (i % 2), 0.5 * (i / 2), 0);
    box.max = box.min + Vec3(0.5, 0.5, 1);
    box.region = std::string(1, static_cast<char>('a' + i));
    geometry.primitives.emplace_back(box);
  }
  const TetrahedralMesh mesh(tetrahedralize(arrange(geometry), {{0.02}, 1.4, {}}));
  std::vector<Medium> media;
  for (int i = 0; i < 4; ++i) media.push_back(uniform_medium(1, 1 + i, 0, 0));
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, 0, 0, 0));
    walls.back().name = name;
  }
  const Problem problem(mesh, {}, media, walls, AngularSpace::sphere, {sun(mesh)});
  const auto in_the_middle = [](const ShadowEdge& edge) {
    return (edge.begin - Vec3(0.5, 0.5, edge.begin.z())).norm() < 1e-9 &&
           std::abs((edge.end - edge.begin).norm() - 1) < 1e-9;
  };
  EXPECT_EQ(std::ranges::count_if(shadow_edges_of(LightPaths(problem)), in_the_middle), 1);
  EXPECT_LT(missing_part(problem), 1e-6);
}

// Light does not notice the border of a region that differs in name only.
TEST(ShadowEdges, AreNotBetweenMediaOfOneExtinction) {
  const TetrahedralMesh mesh = room(Inside::fog, 0.01);
  EXPECT_EQ(shadow_edges_of(LightPaths(lit(mesh, lamp(), 3))).size(), 12);
}

TEST(ShadowPlanes, CutATriangleIntoPartsThatFillIt) {
  const TetrahedralMesh mesh = room(Inside::crate, 0.02);
  const Problem problem = lit(mesh, lamp(), 1);
  const LightSetup lights(problem);
  const ShadowPlanes shadows(lights.paths(), lights.shadow_edges(), *lights.sources()[0]);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(0, 1);
  const auto area = [](const std::array<Vec3, 3>& t) { return (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2; };
  int cut = 0;
  for (int i = 0; i < 300; ++i) {
    std::array<Vec3, 3> triangle;
    for (Vec3& corner : triangle) corner = Vec3(number(random), number(random), 0.4 * number(random));
    std::vector<ShadowPlane> planes;
    shadows.find(triangle, planes);
    const auto parts = cut_by_planes(triangle, planes);
    double sum = 0;
    for (const auto& part : parts) {
      sum += area(part);
      // No plane whose shadow edge shows within a part passes through it.
      std::vector<ShadowPlane> left;
      shadows.find(part, left);
      EXPECT_TRUE(left.empty());
    }
    EXPECT_NEAR(sum, area(triangle), 1e-13);
    if (parts.size() > 1) ++cut;
  }
  EXPECT_GT(cut, 100);
}

// Empty space keeps nothing: all that comes in arrives on a wall, to rounding, whatever stands in the way.
TEST(ShadowPlanes, LetTheSunBalanceToRoundingInEmptySpace) {
  for (const Inside inside : {Inside::crate, Inside::ball_hole}) {
    const TetrahedralMesh mesh = room(inside, 2e-3);
    EXPECT_LT(missing_part(lit(mesh, sun(mesh), 0)), 1e-13);
    EXPECT_LT(missing_part(lit(mesh, sun(mesh), 0, Mirrors::at_right_angles)), 1e-13);
  }
}

// The umbra of the crate, a prism along the light from its silhouette down to the floor, and the crate are
// dark.
TEST(ShadowPlanes, LeaveTheUmbraOutOfTheLitVolume) {
  const TetrahedralMesh mesh = room(Inside::crate, 2e-3);
  const Vec3 size(0.35, 0.3, 0.15);
  // Below a point of the lower side, 0.4 above the floor, and of the two that turn from the light, whose
  // points lie 0.4 to 0.55 above it: each column of light is as high as its end.
  const double slope_x = 0.3 / 0.8, slope_y = 0.2 / 0.8;
  const double below = size.x() * size.y() * 0.4;
  const double mean_height = 0.4 + size.z() / 2;
  const double beside = mean_height * size.z() * (size.y() * slope_x + size.x() * slope_y);
  EXPECT_NEAR(lit_volume(mesh), 1 - size.prod() - below - beside, 1e-12);
}

TEST(ShadowPlanes, LetTheSunBalanceInMatter) {
  for (const Inside inside :
       {Inside::nothing, Inside::crate, Inside::ball_hole, Inside::fog, Inside::ball_of_fog}) {
    const TetrahedralMesh mesh = room(inside, 2e-3);
    for (const double extinction : {0.0, 1.0, 6.0})
      EXPECT_LT(missing_part(lit(mesh, sun(mesh), extinction)), 1e-6) << extinction;
  }
}

TEST(ShadowPlanes, LetALampBalance) {
  for (const Inside inside : {Inside::crate, Inside::ball_hole, Inside::fog, Inside::ball_of_fog}) {
    const TetrahedralMesh mesh = room(inside, 2e-3);
    for (const double extinction : {0.0, 1.0, 6.0})
      EXPECT_LT(missing_part(lit(mesh, lamp(), extinction)), 2e-7) << extinction;
  }
}

// Each mirror shows the room again, with what casts shadows in it.
TEST(ShadowPlanes, StandBehindMirrorsToo) {
  for (const Inside inside : {Inside::crate, Inside::fog}) {
    const TetrahedralMesh mesh = room(inside, 2e-3);
    EXPECT_LT(missing_part(lit(mesh, lamp(), 1, Mirrors::at_right_angles)), 2e-7);
    EXPECT_LT(missing_part(lit(mesh, sun(mesh), 1, Mirrors::at_right_angles)), 1e-6);
  }
}

// Between parallel mirrors the room stands again and again, as far as the light goes.
TEST(ShadowPlanes, StandAgainAndAgainBetweenParallelMirrors) {
  for (const Inside inside : {Inside::nothing, Inside::crate}) {
    const TetrahedralMesh mesh = room(inside, 4e-3);
    const Light light{"sun", BeamLight{Vec3(0.9, 0.1, -0.4).normalized(), {1}, {wall_of(mesh, "zmax")}}, {}};
    EXPECT_LT(missing_part(lit(mesh, light, 0, Mirrors::parallel)), 1e-13);
    EXPECT_LT(missing_part(lit(mesh, light, 1, Mirrors::parallel)), 1e-6);
  }
}

}  // namespace
}  // namespace etendue::shadow_planes_test
