// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/sensors/wall_bake.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/solver/ordinates/sample_problems.h"
#include "tests/solver/sensors/block_mesh.h"

namespace etendue {
namespace {

using std::numbers::pi;

TetrahedralMesh well() {
  return block_mesh({{{0, 0.5, 1}, {0, 0.5, 1}, {0, 0.5, 1}}},
                    [](const Vec3&, const Vec3& out) { return out.z() > 0.5 ? "mouth" : "wall"; });
}

// 9 vertices on each side of the cube; edges belong to two sides and corners to three.
TEST(WallSurface, HasVerticesOfItsOwnForEachPlane) {
  const TetrahedralMesh mesh = well();
  const WallSurface surface = wall_surface(mesh);
  EXPECT_EQ(surface.vertices.size(), 6u * 9u);
  ASSERT_EQ(surface.triangles.size(), 6u * 8u);
  for (const auto& triangle : surface.triangles) {
    const auto& a = surface.vertices[static_cast<std::size_t>(triangle[0])];
    const auto& b = surface.vertices[static_cast<std::size_t>(triangle[1])];
    const auto& c = surface.vertices[static_cast<std::size_t>(triangle[2])];
    const Vec3 front = (b.position - a.position).cross(c.position - a.position).normalized();
    EXPECT_NEAR((front - a.normal).norm(), 0, 1e-12) << "seen from inside";
    EXPECT_NEAR((b.normal - a.normal).norm(), 0, 1e-12);
    EXPECT_GT(front.dot(Vec3(0.5, 0.5, 0.5) - a.position), 0);
  }
}

// The middle of the bottom of a cubic well sees 0.239456470461 of the sky.
TEST(WallBake, FindsTheSkyOfAWell) {
  const TetrahedralMesh mesh = well();
  const WallSurface surface = wall_surface(mesh);
  const int mouth = mesh.wall_names()[0] == "mouth" ? 0 : 1;
  const std::vector<double> visibility = bake_sky_visibility(vertex_places(surface, mesh), mesh, {mouth}, 2);
  EXPECT_EQ(visibility, bake_sky_visibility(vertex_places(surface, mesh), mesh, {mouth}, 1));
  int seen = 0;
  for (std::size_t v = 0; v < visibility.size(); ++v) {
    EXPECT_GE(visibility[v], -1e-12);
    EXPECT_LE(visibility[v], 0.5 + 1e-12);
    if ((surface.vertices[v].position - Vec3(0.5, 0.5, 0)).norm() > 1e-12) continue;
    EXPECT_NEAR(visibility[v], 0.239456470461, 5e-5) << "read beside the vertex";
    ++seen;
  }
  EXPECT_EQ(seen, 1);
}

// A lamp of radiance L fills the mouth; directions brought 0.3: E = 0.3 + pi L F, and B = rho E + pi L.
TEST(WallBake, AddsLightsExactlyToWhatDirectionsBrought) {
  const TetrahedralMesh mesh = well();
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, name == "mouth" ? 2 : 0, name == "mouth" ? 0 : 0.5, 0));
    walls.back().name = name;
    walls.back().uncollided = Uncollided::yes;
  }
  const Problem lit(mesh, {}, {uniform_medium(1, 0, 0, 0)}, walls);
  const LightSetup lights(lit);
  const WallSurface surface = wall_surface(mesh);
  const WallIrradiance brought{
      std::vector<double>(static_cast<std::size_t>(mesh.boundary_face_count()) * 3, 0.3), {}};
  const std::vector<double> irradiance = bake_irradiance(vertex_places(surface, mesh), lights, brought, 1);
  const std::vector<double> radiosity = bake_radiosity(vertex_places(surface, mesh), lit, irradiance);
  for (std::size_t v = 0; v < irradiance.size(); ++v) {
    const bool mouth = surface.vertices[v].normal.z() < -0.5;
    EXPECT_NEAR(radiosity[v], mouth ? 2 * pi : 0.5 * irradiance[v], 1e-12);
    if ((surface.vertices[v].position - Vec3(0.5, 0.5, 0)).norm() < 1e-12) {
      EXPECT_NEAR(irradiance[v], 0.3 + 2 * pi * 0.239456470461, 4e-4);
    }
  }
}

}  // namespace
}  // namespace etendue
