// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/bake/wall_bake.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/solver/observe/sensors/block_mesh.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::wall_bake_test {
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

/// The part of the sky, weighted by the cosine, that a level element sees through a rectangle a by b at the
/// height h, one corner above it (Howell, catalogue of view factors, B-3).
double through_corner(double a, double b, double h) {
  const double s = std::hypot(a, h), t = std::hypot(b, h);
  return (a / s * std::atan(b / s) + b / t * std::atan(a / t)) / (2 * pi);
}

/// Of a well of mouth 1 x 1 from a point of its bottom.
double sky_of_well(double x, double y, double depth) {
  double sum = 0;
  for (const double a : {x, 1 - x})
    for (const double b : {y, 1 - y}) sum += through_corner(a, b, depth);
  return sum;
}

// Every vertex of the bottoms of wells, at the place beside it where it is read. The middle and the corner
// are rows of validation/reference/ambient_occlusion.csv.
TEST(WallBake, FindsTheSkyAtEveryPointOfABottom) {
  struct Row {
    double depth, centre, corner;
  };
  for (const Row& row : {Row{0.5, 0.55412642398, 0.207757125039}, Row{1, 0.239456470461, 0.138531605995},
                         Row{3, 0.0341067948997, 0.0308293973515}}) {
    EXPECT_NEAR(sky_of_well(0.5, 0.5, row.depth), row.centre, 1e-11);
    EXPECT_NEAR(sky_of_well(0, 0, row.depth), row.corner, 1e-11);
    const TetrahedralMesh mesh =
        block_mesh({{{0, 0.3, 0.5, 1}, {0, 0.5, 1}, {0, row.depth / 2, row.depth}}},
                   [](const Vec3&, const Vec3& out) { return out.z() > 0.5 ? "mouth" : "wall"; });
    const WallSurface surface = wall_surface(mesh);
    const int mouth = mesh.wall_names()[0] == "mouth" ? 0 : 1;
    const auto places = vertex_places(surface, mesh);
    const std::vector<double> visibility = bake_sky_visibility(places, mesh, {mouth}, 1);
    int seen = 0;
    for (std::size_t v = 0; v < visibility.size(); ++v) {
      if (surface.vertices[v].normal.z() < 0.5) continue;
      const Vec3& at = places[v].position;
      EXPECT_NEAR(visibility[v], sky_of_well(at.x(), at.y(), row.depth), 1e-9) << at.transpose();
      ++seen;
    }
    EXPECT_EQ(seen, 12);
  }
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
  // Every vertex 20 times, to be asked now and then: shares rise until it is stopped, and nothing is left.
  std::vector<BakePlace> places;
  for (int i = 0; i < 20; ++i)
    for (const BakePlace& place : vertex_places(surface, mesh)) places.push_back(place);
  std::vector<double> shares;
  const auto until = [&](double last) {
    shares = {0};
    return bake_irradiance(places, lights, brought, 1, [&](double share) {
      EXPECT_GT(share, shares.back());
      shares.push_back(share);
      return share < last;
    });
  };
  EXPECT_EQ(until(2).size(), places.size());
  EXPECT_GT(shares.back(), 0.9);
  EXPECT_TRUE(until(0.5).empty());
  EXPECT_LT(shares.back(), 1);
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
}  // namespace etendue::wall_bake_test
