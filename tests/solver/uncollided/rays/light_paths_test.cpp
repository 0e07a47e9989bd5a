// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Paths that go from surface to surface find what a walk from cell to cell finds.
#include "solver/uncollided/rays/light_paths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/geometry/primitives/sheet_shape.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::light_paths_test {
namespace {

BoxPrimitive box(const std::string& region, const Vec3& min, const Vec3& max) {
  BoxPrimitive box;
  box.region = region;
  box.min = min;
  box.max = max;
  return box;
}

/// An L of two rooms of air, with an obstacle, a sheet, a block of glass, and a cloud that varies.
TetrahedralMesh furnished_rooms(double max_volume, double far_away = 0) {
  Geometry geometry;
  geometry.primitives.emplace_back(box("air", {0, 0, 0}, {2, 1, 1}));
  geometry.primitives.emplace_back(box("hall", {0, 1, 0}, {1, 2, 1}));
  geometry.primitives.emplace_back(box("glass", {1.0, 0.2, 0.3}, {1.2, 0.6, 0.7}));
  BoxPrimitive crate = box("", {0.35, 0.3, 0}, {0.65, 0.7, 0.4});
  crate.hole = true;
  crate.name = "crate";
  geometry.primitives.emplace_back(crate);
  SpherePrimitive cloud;
  cloud.region = "cloud";
  cloud.center = {1.6, 0.5, 0.5};
  cloud.radius = 0.3;
  cloud.facets = 80;
  geometry.primitives.emplace_back(cloud);
  geometry.sheets.push_back({rectangle_corners({0.2, 1.2, 0.5}, {0.8, 1.8, 0.5}), "top", "under", {}});
  RawMesh raw = tetrahedralize(arrange(geometry), {{max_volume}, 1.4, {}});
  for (Vec3& point : raw.points) point += Vec3(far_away, -far_away, 0);
  return TetrahedralMesh(raw);
}

Problem problem_of(const TetrahedralMesh& mesh, double reflectance) {
  std::vector<Medium> media;
  for (const std::string& region : mesh.region_names()) {
    media.push_back(uniform_medium(2, region == "glass" ? 3 : 0.2, region == "glass" ? 1 : 0, 0));
    if (region != "cloud") continue;
    for (Coefficient& scattering : media.back().scattering)
      scattering = Coefficient(Expression("1 + 6*z*z", {"x", "y", "z"}));
  }
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(2, 0, 0, name == "zmin" || name == "ymin" ? reflectance : 0));
    walls.back().name = name;
  }
  return Problem(mesh, Bands{{"a", "b"}, {}}, std::move(media), std::move(walls));
}

struct Walked {
  bool open;
  std::vector<double> depth;
};

/// From cell to cell, without mirrors.
Walked walk(const LightPaths& paths, const PointInCell& from, const Vec3& direction, double length) {
  const RayMatter& matter = paths.matter();
  const RayMatter::View light = matter.view(-direction);
  Walked walked{true, std::vector<double>(paths.bands(), 0)};
  double reached = 0;
  const RayEnd end =
      paths.rays().walk(from.cell, from.position, direction, length, [&](CellIndex cell, double part) {
        const Vec3 middle = from.position + (reached + part / 2) * direction;
        for (std::size_t b = 0; b < paths.bands(); ++b)
          walked.depth[b] += matter.at(cell, b, light, middle).extinction() * part;
        reached += part;
      });
  walked.open = end.distance >= length * (1 - 1e-9);
  return walked;
}

struct Rooms {
  double max_volume, far_away;
};
class RandomPaths : public testing::TestWithParam<Rooms> {};

/// Points of the interior, or vertices: on walls, edges and corners too.
TEST_P(RandomPaths, MeetWhatCellsMeet) {
  const TetrahedralMesh mesh = furnished_rooms(GetParam().max_volume, GetParam().far_away);
  const Problem problem = problem_of(mesh, 0);
  const LightPaths paths(problem);
  std::mt19937 random(7);
  std::uniform_int_distribution<std::int32_t> any_cell(0, mesh.cell_count() - 1), any_corner(0, 3);
  std::exponential_distribution<double> any_part;
  const auto interior = [&](CellIndex cell) {
    std::array<double, 4> part;
    double sum = 0;
    for (double& x : part) sum += x = any_part(random);
    Vec3 place = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i)
      place += part[i] / sum * mesh.point(VertexIndex(mesh.vertices(cell)[i]));
    return place;
  };
  int open = 0, blocked = 0, through_glass = 0;
  for (int i = 0; i < 20000; ++i) {
    const CellIndex cell(any_cell(random)), other(any_cell(random));
    const auto corner = static_cast<std::size_t>(any_corner(random));
    // Far from the origin a walk that begins at a vertex of a wall may end there by rounding.
    const bool in_cell = i % 2 == 0 || GetParam().far_away > 0;
    const Vec3 from = in_cell ? interior(cell) : mesh.point(VertexIndex(mesh.vertices(cell)[corner]));
    const Vec3 path = interior(other) - from, direction = path.normalized();
    const double length = path.norm();
    std::vector<double> transmittance(2);
    const bool passes = paths.transmit({cell, from}, direction, length, 0, transmittance);
    const Walked walked = walk(paths, {cell, from}, direction, length);
    ASSERT_EQ(passes, walked.open) << i << ": " << from.transpose() << " along " << direction.transpose();
    (passes ? open : blocked) += 1;
    if (!passes) continue;
    through_glass += walked.depth[0] > 0.25 * length ? 1 : 0;
    for (std::size_t b = 0; b < 2; ++b)
      EXPECT_NEAR(-std::log(transmittance[b]), walked.depth[b],
                  1e-11 + 1e-9 * walked.depth[b] + 1e-12 * GetParam().far_away)
          << i;
  }
  EXPECT_GT(open, 3000);
  EXPECT_GT(blocked, 2000);
  EXPECT_GT(through_glass, 1000);
}
INSTANTIATE_TEST_SUITE_P(Meshes, RandomPaths,
                         testing::Values(Rooms{0.1, 0}, Rooms{0.003, 0}, Rooms{0.003, 1e5}));

// Nearly all paths are followed by the surfaces, which are where a walk finds another medium or the boundary.
TEST(MediumSurfaces, AreMetWhereTheMediumChanges) {
  const TetrahedralMesh mesh = furnished_rooms(0.003);
  const auto glass = std::ranges::find(mesh.region_names(), "glass") - mesh.region_names().begin();
  std::vector<std::int32_t> medium;
  for (const std::int32_t region : mesh.cell_regions()) medium.push_back(region == glass ? 1 : 0);
  const MediumSurfaces surfaces(mesh, medium, true);
  const RayMesh rays(mesh);
  std::mt19937 random(3);
  std::normal_distribution<double> component;
  std::uniform_int_distribution<std::int32_t> any_cell(0, mesh.cell_count() - 1);
  int clear = 0;
  constexpr int paths = 10000;
  for (int i = 0; i < paths; ++i) {
    const CellIndex cell(any_cell(random));
    const Vec3 from = mesh.centroid(cell);
    const Vec3 direction = Vec3(component(random), component(random), component(random)).normalized();
    const std::int32_t here = surfaces.medium(cell);
    const auto met = surfaces.first(from, direction, std::numeric_limits<double>::infinity(), here, {});
    if (met.kind == MediumSurfaces::Crossing::Kind::unclear) continue;
    ++clear;
    ASSERT_EQ(met.kind, MediumSurfaces::Crossing::Kind::surface);
    const auto way = rays.walk_while(
        cell, from, direction, std::numeric_limits<double>::infinity(), [](CellIndex, double) {},
        [&](CellIndex next, double) { return surfaces.medium(next) == here; });
    EXPECT_NEAR(met.distance, way.end.distance, 1e-12) << i;
    EXPECT_EQ(met.face.value() < mesh.boundary_face_count(), way.end.wall.has_value()) << i;
    if (way.end.wall) {
      EXPECT_EQ(mesh.wall(met.face), mesh.wall(*way.end.wall)) << i;
    }
  }
  EXPECT_GT(clear, paths * 0.99);
}

// The path of an image behind a mirror is that of two walks, one of them reversed.
TEST(ReflectedPaths, MeetWhatCellsMeet) {
  const TetrahedralMesh mesh = furnished_rooms(0.005);
  const double reflectance = 0.6;
  const Problem problem = problem_of(mesh, reflectance);
  const LightPaths paths(problem);
  ASSERT_EQ(paths.mirrors().count(), 2);
  std::mt19937 random(11);
  std::uniform_int_distribution<std::int32_t> any_cell(0, mesh.cell_count() - 1);
  int open = 0, blocked = 0;
  for (int i = 0; i < 20000; ++i) {
    const CellIndex cell(any_cell(random)), other(any_cell(random));
    const Vec3 from = mesh.centroid(cell), to = mesh.centroid(other);
    const int plane = i % 2;
    const MirrorSet mirror = MirrorSet{1} << plane;
    const Vec3 path = paths.mirrors().image(mirror, to) - from, direction = path.normalized();
    std::vector<double> transmittance(2);
    const bool passes = paths.transmit({cell, from}, direction, path.norm(), mirror, transmittance);
    std::vector<double> first(2, 0);
    RayEnd there = paths.rays().walk(cell, from, direction, path.norm(), [](CellIndex, double) {});
    bool expected = there.wall && paths.mirrors().of(*there.wall) == plane;
    double depth = 0;
    if (expected) {
      const Walked before = walk(paths, {cell, from}, direction, there.distance);
      const Vec3 back = there.point - to;
      const Walked after = walk(paths, {other, to}, back.normalized(), back.norm());
      expected = after.open;
      depth = before.depth[0] + after.depth[0] - std::log(reflectance);
    }
    ASSERT_EQ(passes, expected) << i << ": " << from.transpose() << " along " << direction.transpose();
    (passes ? open : blocked) += 1;
    if (!passes) continue;
    EXPECT_NEAR(-std::log(transmittance[0]), depth, 1e-11 + 1e-9 * depth) << i;
  }
  EXPECT_GT(open, 3000);
  EXPECT_GT(blocked, 1000);
}

}  // namespace
}  // namespace etendue::light_paths_test
