// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesh/tetrahedra/generation/red_refinement.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/observe/sensors/polygon_points.h"
#include "solver/observe/sensors/sensor_reading.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::flux_convergence_test {
namespace {

using std::numbers::pi;

// Light that falls off as it does far from its source in a medium of extinction 1 that scatters evenly (Case
// 1960): u = e^(-z/nu) (c nu/2)/(nu - mu), of which all in and out of a direction balances where the albedo
// is c = 2/(nu ln((nu + 1)/(nu - 1))). Its fluence is 2 pi e^(-z/nu), its net flux 2 pi nu (1 - c) e^(-z/nu)
// along z. Levels of mu by Gauss integrate 1/(nu - mu) as good as exactly.
constexpr double nu = 1.5;
const double albedo = 2 / (nu * std::log((nu + 1) / (nu - 1)));

const std::vector<Vec3> polygon = {{0.2, 0.15, 0.3}, {0.8, 0.25, 0.35}, {0.75, 0.7, 0.8}, {0.15, 0.6, 0.75}};

double exact_net_flux() {
  double integral = 0;
  for (const PolygonPoint& point : polygon_points(polygon, 64))
    integral += point.area * std::exp(-point.position.z() / nu);
  return polygon_normal(polygon).z() * 2 * pi * nu * (1 - albedo) * integral;
}

/// The net flux of that light through a tilted polygon, to where its corners are seen counterclockwise, the
/// walls of a cube sending in what it says.
double net_flux_in(const RawMesh& raw) {
  const TetrahedralMesh mesh(raw);
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  for (std::size_t w = 0; w < walls.size(); ++w) {
    walls[w].name = mesh.wall_names()[w];
    walls[w].radiance_by_direction = {
        AngularFormula(fmt::format("exp(-z/{0}) * {1}/({0} - wz)", nu, albedo * nu / 2))};
  }
  const Problem medium(mesh, {}, {uniform_medium(1, 1 - albedo, albedo, 0)}, walls);
  const DirectionSet directions = directions_product(8);
  const SolveOptions options = tight_options();
  const LightSetup lights(medium);
  const Solution solution = solve(medium, directions, options);
  const RayRadiance scene(lights, directions, options, solution.state, 1);
  const CellLocator locator(mesh);
  Sensor sensor;
  sensor.kind = SensorKind::flux;
  sensor.polygon = polygon;
  sensor.count = {4, 4};
  sensor.rays = 3000;
  const auto locate = [&](const Vec3& point) { return PointInCell{locator.find(point).front().cell, point}; };
  return SensorReader(lights, scene).read(sensor, locate, 1).measurements.at(2).collided[0];
}

// Scattered light goes through any polygon at order 2 in the cells: with cells halved the error falls by
// four.
TEST(FluxConvergence, OfCollidedLightThroughAPolygonIsOfOrderTwo) {
  const double exact = exact_net_flux();
  RawMesh raw = red_refinement(red_refinement(kuhn_cube_raw()));
  std::vector<double> errors;
  for (int level = 0; level < 3; ++level) {
    errors.push_back(std::abs(net_flux_in(raw) / exact - 1));
    if (level < 2) raw = red_refinement(raw);
  }
  // Of the first halving 1.98 is seen.
  EXPECT_GT(std::log2(errors[0] / errors[1]), 1.95) << errors[0] << " " << errors[1];
  EXPECT_GT(std::log2(errors[1] / errors[2]), 2) << errors[1] << " " << errors[2];
  EXPECT_LT(errors[2], 1e-5);
}

}  // namespace
}  // namespace etendue::flux_convergence_test
