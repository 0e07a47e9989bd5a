// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Beams with a cross-section that meet mirrors, symmetry planes and glossy walls.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "base/errors.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/materials/surfaces/phong.h"
#include "solver/uncollided/lights/light_setup.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::beam_at_mirror_test {
namespace {

using std::numbers::pi;
using enum BeamProfile::Shape;

constexpr double extinction = 1.5;

int wall_named(const TetrahedralMesh& mesh, const std::string& name) {
  return static_cast<int>(std::ranges::find(mesh.wall_names(), name) - mesh.wall_names().begin());
}

/// With an irradiance of 1 on its axis, down through the top of the unit cube.
BeamLight beam_through_top(const TetrahedralMesh& mesh, BeamProfile::Shape shape, double radius,
                           const Vec3& on_axis, const Vec3& direction) {
  const Vec3 along = direction.normalized(), across = along.unitOrthogonal();
  return {along,
          {1},
          {wall_named(mesh, "zmax")},
          0,
          BeamProfile{shape, on_axis, across / radius, along.cross(across) / radius}};
}

std::vector<Wall> black_walls(const TetrahedralMesh& mesh) {
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  for (std::size_t w = 0; w < walls.size(); ++w) walls[w].name = mesh.wall_names()[w];
  return walls;
}

Problem with_mirrors(const TetrahedralMesh& mesh, const BeamLight& beam, double reflectance,
                     const std::vector<std::string>& mirrors) {
  std::vector<Wall> walls = black_walls(mesh);
  for (const std::string& name : mirrors)
    walls[static_cast<std::size_t>(wall_named(mesh, name))].specular[0] = reflectance;
  return Problem(mesh, {}, {uniform_medium(1, extinction, 0, 0)}, std::move(walls), AngularSpace::sphere,
                 {Light{"beam", beam, {}}});
}

double absorbed_power(const TetrahedralMesh& mesh, const UncollidedField& field) {
  double sum = 0;
  for (std::size_t i = 0; i < field.fluence.size(); ++i)
    sum += extinction * field.fluence[i] * mesh.volumes()[i / 4] / 4;
  return sum;
}

double power_at(const TetrahedralMesh& mesh, const UncollidedField& field, const std::string& wall) {
  double sum = 0;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    for (std::size_t i = 0; i < 3 && mesh.wall(FaceIndex(f)) == wall_named(mesh, wall); ++i)
      sum += field.irradiance[3 * FaceIndex(f).at() + i] * mesh.area(FaceIndex(f)) / 3;
  return sum;
}

// A slanting beam comes down at x = 0.25, meets the mirror below at x = 0.5 and leaves at x = 0.75.
TEST(BeamAtMirror, GoesOnByTheLawOfReflection) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const CellLocator locator(mesh);
  const double reflectance = 0.7, radius = 0.1, path_length = std::hypot(0.25, 1);
  for (const BeamProfile::Shape shape : {disc, gaussian}) {
    const Problem problem = with_mirrors(
        mesh, beam_through_top(mesh, shape, radius, {0.25, 0.5, 1}, {0.25, 0, -1}), reflectance, {"zmin"});
    const LightSetup lights(problem);
    const auto profile = [&](double from_axis) {
      const double r = std::abs(from_axis) / path_length / radius;
      return shape == gaussian ? std::exp(-2 * r * r) : r < 1 ? 1 : 0;
    };
    for (const Vec3& point : {Vec3(0.4, 0.5, 0.35), Vec3(0.46, 0.5, 0.35), Vec3(0.6, 0.5, 0.45),
                              Vec3(0.65, 0.5, 0.7), Vec3(0.5, 0.5, 0.05)}) {
      const double down = profile(point.x() - 0.5 + 0.25 * point.z()),
                   up = profile(point.x() - 0.5 - 0.25 * point.z());
      const double expected = down * std::exp(-extinction * path_length * (1 - point.z())) +
                              reflectance * up * std::exp(-extinction * path_length * (1 + point.z()));
      const LightAtPoint light = lights.at({locator.find(point).front().cell, point}, std::nullopt);
      EXPECT_NEAR(light.fluence[0], expected, 1e-9);
    }
    const UncollidedField field = uncollided_field(lights.paths(), lights.sources(), 1);
    const double sent = lights.sources()[0]->power()[0];
    const double at_mirror = std::exp(-extinction * path_length),
                 at_top = reflectance * at_mirror * at_mirror;
    if (shape == disc) {
      EXPECT_NEAR(power_at(mesh, field, "zmin") / sent, at_mirror, 2e-3);
      EXPECT_NEAR(power_at(mesh, field, "zmax") / sent, at_top, 2e-3);
    }
    const double lost = power_at(mesh, field, "zmin") * (1 - reflectance) + power_at(mesh, field, "zmax");
    EXPECT_NEAR((absorbed_power(mesh, field) + lost) / sent, 1, 1e-5);
  }
}

// Half of a beam on a symmetry plane, and a quarter on two, is half or a quarter of it.
TEST(BeamAtMirror, IsCutBySymmetryPlanes) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  for (const auto& [y, mirrors, part] : {std::tuple{0.5, std::vector<std::string>{"xmin"}, 0.5},
                                         {0.0, std::vector<std::string>{"xmin", "ymin"}, 0.25}})
    for (const BeamProfile::Shape shape : {disc, gaussian}) {
      const double radius = 0.12, whole = profile_area(shape, radius);
      const Problem problem =
          with_mirrors(mesh, beam_through_top(mesh, shape, radius, {0, y, 2}, -Vec3::UnitZ()), 1, mirrors);
      const LightSetup lights(problem);
      EXPECT_NEAR(lights.sources()[0]->power()[0] / whole, part, 1e-6);
      const UncollidedField field = uncollided_field(lights.paths(), lights.sources(), 1);
      EXPECT_NEAR(absorbed_power(mesh, field) / whole, part * (1 - std::exp(-extinction)), 1e-5);
      EXPECT_NEAR(power_at(mesh, field, "zmin") / whole, part * std::exp(-extinction), 1e-5);
    }
}

// Mirrors that the beam runs along may face each other; those that it meets may not.
TEST(BeamAtMirror, IsRefusedBetweenMirrorsThatFaceEachOther) {
  const TetrahedralMesh mesh = cube_mesh(0.2);
  const Problem along = with_mirrors(mesh, beam_through_top(mesh, disc, 0.1, {0.5, 0.5, 1}, -Vec3::UnitZ()),
                                     1, {"xmin", "xmax"});
  EXPECT_NO_THROW(LightSetup{along});
  const Problem between =
      with_mirrors(mesh, beam_through_top(mesh, disc, 0.1, {0.5, 0.5, 1}, {0.3, 0, -1}), 1, {"xmin", "xmax"});
  EXPECT_THROW(LightSetup{between}, InputError);
}

// A beam between the corners of a face comes to all of them in its own direction.
TEST(BeamAtMirror, ReachesGlossyWallsInItsDirection) {
  const TetrahedralMesh mesh = cube_mesh(0.2);
  const BeamLight beam = beam_through_top(mesh, gaussian, 0.01, {0.42, 0.57, 1}, {0.1, 0, -1});
  std::vector<Wall> walls = black_walls(mesh);
  walls[static_cast<std::size_t>(wall_named(mesh, "zmin"))].glossy = {std::make_shared<Phong>(0.8, 20)};
  const Problem problem(mesh, {}, {uniform_medium(1, extinction, 0, 0)}, std::move(walls),
                        AngularSpace::sphere, {Light{"beam", beam, {}}});
  const LightSetup lights(problem);
  const UncollidedField field = uncollided_field(lights.paths(), lights.sources(), 1);
  double arriving = 0;
  for (std::size_t place = 0; place < field.glossy.faces().size(); ++place) {
    const FaceIndex face(field.glossy.faces()[place]);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const LightBeams& beams = field.glossy.arriving(place, corner);
      if (field.irradiance[3 * face.at() + corner] == 0) continue;
      ASSERT_EQ(beams.size(), 1U);
      EXPECT_LT((beams.direction(0) - beam.direction).norm(), 1e-12);
      arriving += beams.fluence(0)[0] * mesh.area(face) / 3;
    }
  }
  EXPECT_NEAR(arriving / (profile_area(gaussian, 0.01) * std::exp(-extinction * std::hypot(0.1, 1))), 1,
              1e-3);
}

}  // namespace
}  // namespace etendue::beam_at_mirror_test
