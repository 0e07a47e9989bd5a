// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/extended_source.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "mesh/tetrahedra/cell_locator.h"
#include "tests/solver/ordinates/sample_problems.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// A disc about z in the plane z = height that shines downwards with radiance 1; the polygon has its area.
std::vector<EmitterPart> disc(const Vec3& centre, double radius, int sides) {
  const double angle = 2 * pi / sides;
  const double corner = radius * std::sqrt(angle / std::sin(angle));
  const auto rim = [&](int i) {
    return Vec3(centre + corner * Vec3(std::cos(i * angle), std::sin(i * angle), 0));
  };
  std::vector<EmitterPart> parts;
  for (int i = 0; i < sides; ++i) parts.push_back({{centre, rim(i + 1), rim(i)}, {1.0}, {}});
  return parts;
}

double irradiance(const LightBeams& beams, const Vec3& normal) {
  double sum = 0;
  for (std::size_t i = 0; i < beams.size(); ++i)
    sum += std::max(0.0, -beams.direction(i).dot(normal)) * beams.fluence(i)[0];
  return sum;
}

// On the axis at a distance where the disc has the half angle a: E = pi L sin^2 a.
TEST(ExtendedSource, DiscLightsItsAxisAsItsHalfAngleSays) {
  const TetrahedralMesh mesh = cube_mesh(0.01);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0, 0, 0), uniform_wall(1, 0, 0, 0));
  const LightPaths paths(problem);
  const CellLocator locator(mesh);
  const double radius = 0.3;
  const ExtendedSource source(
      "disc", {1}, EmitterTree(EmitterShape::triangles, disc({0.5, 0.5, 0.9}, radius, 256)), paths);
  for (const double distance : {0.01, 0.1, 0.3, 0.6, 0.85}) {
    const Vec3 point(0.5, 0.5, 0.9 - distance);
    LightBeams beams(1);
    source.add_beams({locator.find(point)[0].cell, point}, Sight::attenuated, fine_light, beams);
    const double sine = radius / std::hypot(radius, distance);
    EXPECT_NEAR(irradiance(beams, Vec3::UnitZ()) / (pi * sine * sine), 1, 1e-3) << distance;
  }
}

// A ball that emits q everywhere without absorbing: the fluence in its middle is 4 pi q R, and outside at a
// distance d the net flux is q V / d^2 for every d.
TEST(ExtendedSource, BallShinesAsFromItsMiddle) {
  const TetrahedralMesh mesh = cube_with_ball(5e-3);
  const Problem problem(mesh, {}, {uniform_medium(1, 0, 0, 0), uniform_medium(1, 0, 0, 0)},
                        std::vector<Wall>(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0)));
  const LightPaths paths(problem);
  std::vector<EmitterPart> parts;
  double volume = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    if (mesh.region_names()[static_cast<std::size_t>(mesh.region(CellIndex(c)))] != "ball") continue;
    EmitterPart part{{}, {1.0}, {0.0}};
    for (std::size_t i = 0; i < 4; ++i)
      part.corners[i] = mesh.point(VertexIndex(mesh.vertices(CellIndex(c))[i]));
    parts.push_back(part);
    volume += mesh.volume(CellIndex(c));
  }
  const ExtendedSource source("ball", {4 * pi * volume}, EmitterTree(EmitterShape::tetrahedra, parts), paths);
  const CellLocator locator(mesh);
  for (const Vec3& point : {Vec3(0.5, 0.5, 0.98), Vec3(0.06, 0.1, 0.1), Vec3(0.5, 0.97, 0.2)}) {
    LightBeams beams(1);
    source.add_beams({locator.find(point)[0].cell, point}, Sight::attenuated, fine_light, beams);
    Vec3 flux = Vec3::Zero();
    for (std::size_t i = 0; i < beams.size(); ++i) flux += beams.fluence(i)[0] * beams.direction(i);
    const Vec3 away = point - Vec3(0.5, 0.5, 0.5);
    EXPECT_NEAR(flux.norm() * away.squaredNorm() / volume, 1, 3e-3);
    EXPECT_NEAR(flux.dot(away.normalized()) / flux.norm(), 1, 1e-4);
  }
  LightBeams beams(1);
  const Vec3 middle(0.5, 0.5, 0.5);
  source.add_beams({locator.find(middle)[0].cell, middle}, Sight::attenuated, fine_light, beams);
  double fluence = 0;
  for (std::size_t i = 0; i < beams.size(); ++i) fluence += beams.fluence(i)[0];
  EXPECT_NEAR(fluence / (4 * pi * std::cbrt(3 * volume / (4 * pi))), 1, 0.01);
}

// The means of a frame and of its halves lie in its opening.
TEST(EmitterTree, HasItsPointsInTheLight) {
  std::vector<EmitterPart> parts;
  const auto add_square = [&](double x, double y) {
    const Vec3 a(x, y, 1), b(x + 1, y, 1), c(x + 1, y + 1, 1), d(x, y + 1, 1);
    parts.push_back({{a, c, b}, {1.0}, {}});
    parts.push_back({{a, d, c}, {1.0}, {}});
  };
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j)
      if (i == 0 || j == 0 || i == 7 || j == 7) add_square(i, j);
  const EmitterTree tree(EmitterShape::triangles, parts);
  int hollow = 0, whole = 0;
  const auto in_light = [](const Vec3& p) {
    return p.minCoeff() > -1e-9 && std::max(p.x(), p.y()) < 8 + 1e-9 &&
           (std::min(p.x(), p.y()) < 1 + 1e-9 || std::max(p.x(), p.y()) > 7 - 1e-9);
  };
  const std::function<void(const EmitterTree::Node&)> look = [&](const EmitterTree::Node& node) {
    EXPECT_TRUE(in_light(node.middle));
    for (std::size_t i = 0; i < node.point_count; ++i) EXPECT_TRUE(in_light(node.points[i]));
    if (node.part >= 0) return;
    ++(node.hollow ? hollow : whole);
    for (const int child : node.children) look(tree.node(child));
  };
  look(tree.root());
  EXPECT_GT(hollow, 0);
  EXPECT_GT(whole, 10);
}

}  // namespace
}  // namespace etendue
