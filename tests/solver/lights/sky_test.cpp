// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesh/tetrahedra/cell_locator.h"
#include "solver/lights/light_setup.h"
#include "tests/solver/ordinates/sample_problems.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// An even sky of radiance 1 above, in rings that stand at their mean cosine.
std::vector<Light> even_sky(const std::vector<int>& walls, int rings, int parts) {
  std::vector<Light> sky;
  for (int ring = 0; ring < rings; ++ring) {
    const double cosine = (ring + 0.5) / rings, sine = std::sqrt(1 - cosine * cosine);
    for (int i = 0; i < parts; ++i) {
      const double azimuth = 2 * pi * (i + 0.5) / parts;
      const Vec3 from(sine * std::cos(azimuth), sine * std::sin(azimuth), cosine);
      sky.push_back({"sky", BeamLight{-from, {2 * pi / (rings * parts)}, walls}, {}});
    }
  }
  return sky;
}

struct Found {
  double sent, absorbed, on_walls;
  std::vector<double> on_wall;
};

/// In a cube with a mirror at xmax of this reflectance; the light comes in by all other walls, or by zmax.
Found find_sky(const TetrahedralMesh& mesh, double extinction, bool everywhere, double specular,
               int rings = 12, int parts = 24) {
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  std::vector<int> open;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    if (mesh.wall_names()[w] == "xmax") walls[w].specular = {specular};
    if (mesh.wall_names()[w] == "zmax" || (everywhere && walls[w].specular[0] == 0))
      open.push_back(static_cast<int>(w));
  }
  const Problem problem(mesh, {}, {uniform_medium(1, extinction, 0, 0)}, walls, AngularSpace::sphere,
                        even_sky(open, rings, parts));
  const LightSetup lights(problem);
  const UncollidedField field = uncollided_field(lights.paths(), lights.sources(), 1);
  Found found{lights.sources()[0]->power()[0], 0, 0, std::vector<double>(walls.size(), 0)};
  for (std::size_t i = 0; i < field.fluence.size(); ++i)
    found.absorbed += extinction * field.fluence[i] * mesh.volumes()[i / 4] / 4;
  for (std::size_t i = 0; i < field.irradiance.size(); ++i) {
    const FaceIndex face(static_cast<std::int64_t>(i / 3));
    const auto w = static_cast<std::size_t>(mesh.wall(face));
    const double power = field.irradiance[i] * mesh.area(face) / 3;
    found.on_wall[w] += power;
    found.on_walls += (1 - walls[w].specular[0]) * power;
  }
  return found;
}

// Above an open place every point sees the whole sky: E = pi on the ground.
TEST(SkySource, LightsTheGroundOfAnOpenPlace) {
  const TetrahedralMesh mesh = cube_mesh(0.01);
  const Found found = find_sky(mesh, 0, true, 0);
  EXPECT_NEAR(found.on_walls / found.sent, 1, 1e-12);
  for (std::size_t w = 0; w < found.on_wall.size(); ++w) {
    if (mesh.wall_names()[w] == "zmin") {
      EXPECT_NEAR(found.on_wall[w], pi, 1e-12);
    } else if (mesh.wall_names()[w] == "zmax") {
      EXPECT_EQ(found.on_wall[w], 0);
    }
  }
}

// Through an open ceiling into a black room: the form factor of opposite sides of a cube is 0.199825
// (Hamilton and Morgan 1952).
TEST(SkySource, LightsARoomThroughItsCeiling) {
  const TetrahedralMesh mesh = cube_mesh(4e-3);
  const Found found = find_sky(mesh, 0, false, 0, 24, 48);
  EXPECT_NEAR(found.sent, pi, 1e-12);
  EXPECT_NEAR(found.on_walls / found.sent, 1, 0.01);
  for (std::size_t w = 0; w < found.on_wall.size(); ++w)
    if (mesh.wall_names()[w] != "zmax") {
      EXPECT_NEAR(found.on_wall[w] / pi, 0.2, 0.004);
    }
}

// What is lost on the way is linear between vertices: the balance closes as cells shrink.
TEST(SkySource, BalancesInAMediumBesideAMirror) {
  const auto residual = [](double max_volume) {
    const Found found = find_sky(cube_mesh(max_volume), 0.8, true, 0.6);
    return std::abs((found.absorbed + found.on_walls) / found.sent - 1);
  };
  const double fine = residual(1e-3);
  EXPECT_LT(fine, 6e-3);
  EXPECT_LT(fine, 0.5 * residual(8e-3));
}

}  // namespace
}  // namespace etendue
