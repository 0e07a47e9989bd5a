// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/radiance/wall_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::wall_light_test {
namespace {

TEST(WallLight, KeepsAnIrradianceThatIsLinearOnEachSide) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 1, 0, 0), uniform_wall(1, 0, 0.5, 0));
  const LightSetup lights(problem);
  const auto exact = [&](FaceIndex face, const Vec3& p) {
    return 1 + 2 * p.x() + 3 * p.y() - p.z() + 10 * mesh.wall(face);
  };
  SavedState state;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    for (const std::int32_t v : mesh.vertices(FaceIndex(f)))
      state.irradiance.push_back(exact(FaceIndex(f), mesh.point(VertexIndex(v))));
  const WallLight walls(lights, directions_ldfe_sq(1), state, 3);
  for (std::size_t i = 0; i < state.irradiance.size(); ++i)
    EXPECT_NEAR(walls.brought().values[i], state.irradiance[i], 1e-12);
}

TEST(WallLight, IsContinuousOnASide) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 1, 0, 0), uniform_wall(1, 0, 0.5, 0));
  const LightSetup lights(problem);
  SavedState state;
  state.irradiance.resize(static_cast<std::size_t>(mesh.boundary_face_count()) * 3);
  for (std::size_t i = 0; i < state.irradiance.size(); ++i)
    state.irradiance[i] = 1 + static_cast<double>(i * 7919 % 13);
  const WallLight walls(lights, directions_ldfe_sq(1), state, 3);
  std::map<std::pair<int, int>, double> seen;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::pair place(mesh.wall(FaceIndex(f)), mesh.vertices(FaceIndex(f))[i]);
      const double value = walls.brought().values[static_cast<std::size_t>(f) * 3 + i];
      EXPECT_NEAR(seen.try_emplace(place, value).first->second, value, 1e-12);
    }
}

// A lamp of point size: E = I cos/r^2.
TEST(WallLight, SendsBackTheLightOfALampExactly) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  PointLight lamp;
  lamp.position = {0.4, 0.55, 0.6};
  lamp.power = {4 * std::numbers::pi};
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0.5, 0));
  for (std::size_t w = 0; w < walls.size(); ++w) walls[w].name = mesh.wall_names()[w];
  Medium air = uniform_medium(1, 0.7, 0, 0);
  const Problem problem(mesh, {}, {air}, walls, AngularSpace::sphere, {{"lamp", lamp, {}}});
  const LightSetup lights(problem);
  SavedState state;
  state.irradiance.resize(static_cast<std::size_t>(mesh.boundary_face_count()) * 3);
  const WallLight wall_light(lights, directions_ldfe_sq(1), state, 3);
  LightBeams beams(1);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const Vec3 point = mesh.centroid(face), separation = point - lamp.position;
    const double expected = mesh.area_normal(face).normalized().dot(separation) /
                            std::pow(separation.norm(), 3) * std::exp(-0.7 * separation.norm()) * 0.5 /
                            std::numbers::pi;
    std::vector<double> radiance(1, 0);
    wall_light.add_reflected(face, point, wall_light.brought(), 16, beams, radiance);
    EXPECT_NEAR(radiance[0], expected, 1e-9 * expected);
  }
}

/// A ceiling that shines, a crate below it.
TetrahedralMesh room_with_crate() {
  BoxPrimitive room, crate;
  room.region = "air";
  room.min = Vec3(0, 0, 0);
  room.max = Vec3(1, 1, 1);
  crate.hole = true;
  crate.name = "crate";
  crate.min = Vec3(0.35, 0.35, 0.3);
  crate.max = Vec3(0.65, 0.65, 0.5);
  Geometry geometry;
  geometry.primitives = {room, crate};
  TetrahedraOptions options;
  options.max_volume = {0.05};
  return TetrahedralMesh(tetrahedralize(arrange(geometry), options));
}

/// Its floor's irradiance at a point, with at most so many rays to the ceiling.
struct LitFloor {
  LitFloor()
      : mesh(room_with_crate()), problem(mesh, {}, {uniform_medium(1, 0, 0, 0)}, walls()), lights(problem) {}
  std::vector<Wall> walls() const {
    std::vector<Wall> all;
    for (const std::string& name : mesh.wall_names()) {
      all.push_back(uniform_wall(1, name == "zmax" ? 1 : 0, 0.5, 0));
      all.back().name = name;
      all.back().uncollided = Uncollided::yes;
    }
    return all;
  }
  double irradiance(const Vec3& place, int rays) const {
    SavedState state;
    state.irradiance.resize(static_cast<std::size_t>(mesh.boundary_face_count()) * 3);
    const WallLight light(lights, directions_ldfe_sq(1), state, 3);
    LightBeams beams(1);
    std::vector<double> found(1, 0);
    light.add_light({CellLocator(mesh).find(place).front().cell, place}, -Vec3::UnitZ(), rays, beams, found);
    return found[0];
  }

  /// The sum over rays to very small pieces of the ceiling.
  double summed(const Vec3& place) const {
    LightBeams beams(1);
    lights.sources().front()->add_beams({CellLocator(mesh).find(place).front().cell, place},
                                        Sight::attenuated, {0, 0, 1, 0.01, TriangleRule::seven_points},
                                        beams);
    double sum = 0;
    for (std::size_t i = 0; i < beams.size(); ++i) sum -= beams.direction(i).z() * beams.fluence(i)[0];
    return sum;
  }
  /// What a meter there reads.
  double measured(const Vec3& place) const {
    return LightIrradiance(lights)
        .at({CellLocator(mesh).find(place).front().cell, place}, Vec3::UnitZ())
        .irradiance[0];
  }

  TetrahedralMesh mesh;
  Problem problem;
  LightSetup lights;
};

TEST(WallLight, SendsNoMoreRaysThanItMay) {
  const LitFloor floor;
  LightBeams beams(1);
  for (const int rays : {4, 16, 64})
    for (const double height : {0.0, 0.6, 0.98}) {
      const Vec3 place(0.2, 0.3, height);
      detail_within(*floor.lights.sources().front(),
                    {CellLocator(floor.mesh).find(place).front().cell, place}, penumbra_detail, rays, beams);
      EXPECT_LE(beams.size(), static_cast<std::size_t>(rays)) << height;
      EXPECT_GE(beams.size(), static_cast<std::size_t>(rays) / 8) << height;
    }
}

// On the crate all of the ceiling is seen, and is known in closed form: 4 F of a corner of a rectangle,
// F = (x atan(y/x') / x' + y atan(x/y') / y') / 2 with x' = sqrt(1 + x^2), y' = sqrt(1 + y^2) (Howell's
// catalogue, B-4), here x = y = 1.
TEST(WallLight, IsExactBelowALampThatNothingHides) {
  const LitFloor floor;
  for (const int rays : {4, 16, 128})
    EXPECT_NEAR(floor.irradiance({0.5, 0.5, 0.5}, rays), 4 * std::atan(1 / std::sqrt(2)) / std::sqrt(2),
                1e-12)
        << rays;
}

// Below the middle of a disc of half angle a: E = pi sin^2 a, here of the polygon that is as large.
TEST(WallLight, IsExactBelowADisc) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  constexpr int sides = 64;
  constexpr double radius = 0.3, height = 0.9, angle = 2 * std::numbers::pi / sides;
  const double corner = radius * std::sqrt(angle / std::sin(angle));
  const auto rim = [&](int i) -> Vec3 {
    return Vec3(0.5, 0.5, height) + corner * Vec3(std::cos(i * angle), std::sin(i * angle), 0);
  };
  SurfaceLight disc;
  disc.radiance = {1};
  for (int i = 0; i < sides; ++i)
    for (const Vec3& point : {Vec3(0.5, 0.5, height), rim(i + 1), rim(i)}) disc.triangles.push_back(point);
  const Problem problem(mesh, {}, {uniform_medium(1, 0, 0, 0)},
                        std::vector<Wall>(mesh.wall_names().size(), uniform_wall(1, 0, 0.5, 0)),
                        AngularSpace::sphere, {{"disc", disc, {}}});
  const LightSetup lights(problem);
  SavedState state;
  state.irradiance.resize(static_cast<std::size_t>(mesh.boundary_face_count()) * 3);
  const WallLight light(lights, directions_ldfe_sq(1), state, 3);
  LightBeams beams(1);
  std::vector<double> found(1, 0);
  const Vec3 place(0.5, 0.5, 0);
  light.add_light({CellLocator(mesh).find(place).front().cell, place}, -Vec3::UnitZ(), 16, beams, found);
  const double sine = radius / std::hypot(radius, height);
  EXPECT_NEAR(found[0] / (std::numbers::pi * sine * sine), 1, 1e-6);
}

// In the penumbra of the crate the ceiling is cut along its edges, and all rays see the truth but for the
// rule that they make up.
TEST(WallLight, CutsLampsInPenumbras) {
  const LitFloor floor;
  double few = 0, many = 0;
  for (const double x : {0.2, 0.25, 0.3, 0.35, 0.4}) {
    const Vec3 place(x, 0.5, 0);
    const double truth = floor.measured(place);
    few = std::max(few, std::abs(floor.irradiance(place, 16) - truth));
    many = std::max(many, std::abs(floor.irradiance(place, 128) - truth));
  }
  // One of them by rays to a ceiling in small pieces.
  EXPECT_NEAR(floor.measured({0.3, 0.5, 0}), floor.summed({0.3, 0.5, 0}), 2e-4);
  EXPECT_LT(many, 1e-4);
  EXPECT_GT(few, 1e-2);
}

}  // namespace
}  // namespace etendue::wall_light_test
