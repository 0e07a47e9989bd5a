// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/uncollided/lights/light_setup.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::sky_test {
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
Found find_sky(const TetrahedralMesh& mesh, const Medium& medium, bool everywhere, double specular,
               int rings = 12, int parts = 24) {
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  std::vector<int> open;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    if (mesh.wall_names()[w] == "xmax") walls[w].specular = {specular};
    if (mesh.wall_names()[w] == "zmax" || (everywhere && walls[w].specular[0] == 0))
      open.push_back(static_cast<int>(w));
  }
  const Problem problem(mesh, {}, {medium}, walls, AngularSpace::sphere, even_sky(open, rings, parts));
  const LightSetup lights(problem);
  const UncollidedField field = uncollided_field(lights.paths(), lights.sources(), 1);
  Found found{lights.sources()[0]->power()[0], 0, 0, std::vector<double>(walls.size(), 0)};
  for (std::size_t i = 0; i < field.fluence.size(); ++i) {
    const double absorbed = field.absorbed.empty() ? problem.absorption()[i / 4] * field.fluence[i]
                                                   : field.absorbed[i / 4] + field.collided[i];
    found.absorbed += absorbed * mesh.volumes()[i / 4] / 4;
  }
  for (std::size_t i = 0; i < field.irradiance.size(); ++i) {
    const FaceIndex face(static_cast<std::int64_t>(i / 3));
    const auto w = static_cast<std::size_t>(mesh.wall(face));
    const double power = field.irradiance[i] * mesh.area(face) / 3;
    found.on_wall[w] += power;
    found.on_walls += (1 - walls[w].specular[0]) * power;
  }
  return found;
}

Found find_sky(const TetrahedralMesh& mesh, double extinction, bool everywhere, double specular,
               int rings = 12, int parts = 24) {
  return find_sky(mesh, uniform_medium(1, extinction, 0, 0), everywhere, specular, rings, parts);
}

double residual_of(const Found& found) {
  return std::abs((found.absorbed + found.on_walls) / found.sent - 1);
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

// Optical depths are linear where a beam comes in by one plane, so the remaining error is that of rules of
// few points where it comes in by several, or not at all.
TEST(SkySource, BalancesInAMediumBesideAMirror) {
  const double fine = residual_of(find_sky(cube_mesh(1e-3), 0.8, true, 0.6));
  EXPECT_LT(fine, 3e-4);
  EXPECT_LT(fine, 0.5 * residual_of(find_sky(cube_mesh(8e-3), 0.8, true, 0.6)));
}

TEST(SkySource, BalancesInThickMatter) {
  EXPECT_LT(residual_of(find_sky(cube_mesh(8e-3), 3, true, 0.6, 6, 12)), 2e-3);
}

// Leaves take of each beam what they show to it.
TEST(SkySource, BalancesOverLeaves) {
  const TetrahedralMesh mesh = cube_mesh(8e-3);
  for (const LeafAngles angles : {LeafAngles::horizontal, LeafAngles::vertical}) {
    Medium leaves = uniform_medium(1, 0.4, 0.2, 0);
    leaves.directional = {LeafCanopy{angles, 0.2, 0.1}};
    EXPECT_LT(residual_of(find_sky(mesh, leaves, true, 0, 6, 12)), 2e-3);
  }
}

// Under an open plane between mirrors depths are linear everywhere: of each beam 1 - e^(-s/mu) is absorbed.
TEST(SkySource, FallsOffUnderAnOpenPlaneAsInClosedForm) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  constexpr double extinction = 4;
  constexpr int rings = 3;
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 1));
  std::vector<int> open;
  for (std::size_t w = 0; w < walls.size(); ++w)
    if (mesh.wall_names()[w] == "zmax" || mesh.wall_names()[w] == "zmin") {
      walls[w] = uniform_wall(1, 0, 0, 0);
      if (mesh.wall_names()[w] == "zmax") open.push_back(static_cast<int>(w));
    }
  // Beams across x and y, which the mirrors turn into each other.
  const Problem problem(mesh, {}, {uniform_medium(1, extinction, 0, 0)}, walls, AngularSpace::sphere,
                        even_sky(open, rings, 4));
  const LightSetup lights(problem);
  const UncollidedField field = uncollided_field(lights.paths(), lights.sources(), 1);
  double absorbed = 0, expected = 0;
  for (std::size_t i = 0; i < field.fluence.size(); ++i)
    absorbed += extinction * field.fluence[i] * mesh.volumes()[i / 4] / 4;
  for (int ring = 0; ring < rings; ++ring) {
    const double cosine = (ring + 0.5) / rings;
    expected += 2 * pi / rings * cosine * (1 - std::exp(-extinction / cosine));
  }
  EXPECT_NEAR(absorbed / expected, 1, 1e-4);
}

}  // namespace
}  // namespace etendue::sky_test
