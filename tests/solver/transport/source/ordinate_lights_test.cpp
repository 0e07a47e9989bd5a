// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Lights that are left to the directions.
#include "solver/transport/source/ordinate_lights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/solution/balance.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::ordinate_lights_test {
namespace {

using std::numbers::pi;

Problem problem_with(const TetrahedralMesh& mesh, std::vector<Light> lights) {
  for (Light& light : lights) light.uncollided = Uncollided::no;
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(2, 0, 0.2, 0));
    walls.back().name = name;
  }
  return Problem(mesh, Bands{{"a", "b"}, {}}, {uniform_medium(2, 0.5, 1, 0)}, std::move(walls),
                 AngularSpace::sphere, std::move(lights));
}

PointLight bulb() {
  PointLight light;
  light.position = Vec3(0.4, 0.5, 0.6);
  light.power = {3, 7};
  return light;
}

PointLight narrow_spot() {
  PointLight spot = bulb();
  spot.axis = Vec3(1, 2, -2).normalized();
  spot.angle = {0, 0.01};
  spot.intensity = {1, 1};
  return spot;
}

SurfaceLight square(double z) {
  const Vec3 a(0.2, 0.3, z), b(0.2, 0.7, z), c(0.8, 0.7, z), d(0.8, 0.3, z);
  return {{a, b, c, a, c, d}, {2, 5}};
}

/// Of what the input emits in the cells, by the set: power, and power times direction.
struct Sent {
  double power = 0;
  Vec3 momentum = Vec3::Zero();
};

Sent sent_in_cells(const TetrahedralMesh& mesh, const DirectionSet& directions, const AngularInput& input,
                   std::size_t band) {
  Sent sent;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    for (std::int32_t m = 0; m < directions.count(); ++m) {
      std::vector<double> values(8, 0);
      input.add_source(OrdinateIndex(m), CellIndex(c), values);
      const double mean = (values[band] + values[2 + band] + values[4 + band] + values[6 + band]) / 4;
      EXPECT_TRUE(mean == 0 || input.depends_on_direction(CellIndex(c)));
      const double power = mean * mesh.volume(CellIndex(c)) * directions.weight(OrdinateIndex(m));
      sent.power += power;
      sent.momentum += power * directions.direction(OrdinateIndex(m));
    }
  return sent;
}

TEST(OrdinateLights, SendTheirPower) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  const DirectionSet directions = directions_ldfe_sq(1);
  const Problem point = problem_with(mesh, {{"bulb", bulb(), {}}});
  const Sent even = sent_in_cells(mesh, directions, OrdinateLights(point, directions, nullptr), 1);
  EXPECT_NEAR(even.power, 7, 1e-12);
  EXPECT_LT(even.momentum.norm(), 1e-12);
  // No ordinate lies in the cone: all goes along the nearest.
  const Problem spot = problem_with(mesh, {{"spot", narrow_spot(), {}}});
  const Sent along = sent_in_cells(mesh, directions, OrdinateLights(spot, directions, nullptr), 0);
  EXPECT_NEAR(along.power, 3, 1e-12);
  EXPECT_GT(along.momentum.dot(narrow_spot().axis), 0.95 * 3);
  const Problem flat = problem_with(mesh, {{"panel", square(0.5), {}}});
  const OrdinateLights panel(flat, directions, nullptr);
  const Sent down = sent_in_cells(mesh, directions, panel, 1);
  EXPECT_NEAR(down.power, pi * 5 * 0.24, 1e-12);
  // Lambert's cosine law: two thirds of the power along the normal, here -z.
  EXPECT_NEAR(down.momentum.z(), -2. / 3 * down.power, 0.01 * down.power);
  EXPECT_NEAR(panel.power_inside()[0], pi * 2 * 0.24, 1e-12);
}

// z = 0.5 is a plane between cells of this mesh: the light shines from those below.
TEST(OrdinateLights, OnAWallShineIntoTheDomainAlone) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const DirectionSet directions = directions_ldfe_sq(1);
  PointLight light = bulb();
  light.position.z() = 1;
  const Problem problem = problem_with(mesh, {{"lamp", light, {}}});
  const OrdinateLights lights(problem, directions, nullptr);
  const CellIndex cell = CellLocator(mesh).find(light.position).front().cell;
  for (std::int32_t m = 0; m < directions.count(); ++m) {
    std::vector<double> values(8, 0);
    lights.add_source(OrdinateIndex(m), cell, values);
    EXPECT_EQ(values[0] > 0, directions.direction(OrdinateIndex(m)).z() <= 0);
  }
  EXPECT_NEAR(sent_in_cells(mesh, directions, lights, 1).power, 7, 1e-12);
  const Solution solution = solve(problem, directions, tight_options());
  EXPECT_NEAR(balances(problem, solution)[1].residual, 0, 1e-9);
}

TEST(OrdinateLights, ShineFromTheirOwnSide) {
  const TetrahedralMesh mesh = mesh_with_image(cube_mesh(2e-2));
  SurfaceLight panel{{}, {1, 1}};
  for (const Vec3& p : square(0).triangles) panel.triangles.push_back(Vec3(1, p.x(), p.y()));
  const Vec3 normal =
      (panel.triangles[1] - panel.triangles[0]).cross(panel.triangles[2] - panel.triangles[0]).normalized();
  const DirectionSet directions = directions_product(4);
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(2, 0, 0, 0));
  for (std::size_t w = 0; w < walls.size(); ++w) walls[w].name = mesh.wall_names()[w];
  const Problem problem(mesh, Bands{{"a", "b"}, {}},
                        std::vector<Medium>(mesh.region_names().size(), uniform_medium(2, 1, 0, 0)), walls,
                        AngularSpace::sphere, {{"panel", panel, {}, Uncollided::no}});
  const OrdinateLights swept(problem, directions, nullptr);
  int shining = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    if (swept.depends_on_direction(CellIndex(c))) {
      ++shining;
      EXPECT_GT((mesh.centroid(CellIndex(c)) - Vec3(1, 0.5, 0.5)).dot(normal), 0);
    }
  EXPECT_GT(shining, 2);
}

TEST(OrdinateLights, CloseTheBalance) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  const int zmax = static_cast<int>(std::find(mesh.wall_names().begin(), mesh.wall_names().end(), "zmax") -
                                    mesh.wall_names().begin());
  const Vec3 slanting = Vec3(0.3, -0.5, -1).normalized();
  const Problem problem = problem_with(mesh, {{"bulb", narrow_spot(), {}},
                                              {"panel", square(0.37), {}},
                                              {"sun", BeamLight{slanting, {2, 4}, {zmax}}, {}}});
  const Solution solution = solve(problem, directions_ldfe_sq(1), tight_options());
  ASSERT_TRUE(solution.converged());
  const std::vector<Balance> balance = balances(problem, solution);
  EXPECT_NEAR(balance[0].inflow, 3 + pi * 2 * 0.24 + 2 * -slanting.z(), 1e-9);
  EXPECT_NEAR(balance[1].inflow, 7 + pi * 5 * 0.24 + 4 * -slanting.z(), 1e-9);
  for (const Balance& band : balance) EXPECT_LT(std::abs(band.residual), 1e-10);
}

}  // namespace
}  // namespace etendue::ordinate_lights_test
