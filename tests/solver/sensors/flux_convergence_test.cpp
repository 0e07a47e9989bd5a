// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "mesh/tetrahedra/cell_locator.h"
#include "mesh/tetrahedra/red_refinement.h"
#include "solver/sensors/sensor_reading.h"
#include "tests/solver/ordinates/sample_problems.h"

namespace etendue {
namespace {

/// Light of glowing haze that goes through a tilted polygon, to where its corners are seen counterclockwise.
double flux_in(const RawMesh& raw) {
  const TetrahedralMesh mesh(raw);
  Medium glow = uniform_medium(1, 0.5, 2, 1);
  glow.uncollided = Uncollided::no;
  const Problem haze = uniform_problem(mesh, glow, uniform_wall(1, 0, 0, 0));
  const DirectionSet directions = directions_product(4);
  const SolveOptions options = tight_options();
  const LightSetup lights(haze);
  const Solution solution = solve(haze, directions, options);
  const RayRadiance scene(lights, directions, options, solution.state, 1);
  const CellLocator locator(mesh);
  Sensor sensor;
  sensor.kind = SensorKind::flux;
  sensor.polygon = {{0.2, 0.15, 0.3}, {0.8, 0.25, 0.35}, {0.75, 0.7, 0.8}, {0.15, 0.6, 0.75}};
  sensor.count = {4, 4};
  sensor.rays = 3000;
  const auto locate = [&](const Vec3& point) { return PointInCell{locator.find(point).front().cell, point}; };
  return SensorReader(lights, scene).read(sensor, locate, 1).measurements.at(0).collided[0];
}

// Light that is scattered goes through any polygon at order 2 in the cells: what the flux changes by from one
// mesh of halved cells to the next falls by four.
TEST(FluxConvergence, OfCollidedLightThroughAPolygonIsOfOrderTwo) {
  RawMesh raw = red_refinement(red_refinement(kuhn_cube_raw()));
  std::vector<double> flux;
  for (int level = 0; level < 3; ++level) {
    flux.push_back(flux_in(raw));
    if (level < 2) raw = red_refinement(raw);
  }
  EXPECT_GT(std::log2(std::abs(flux[1] - flux[0]) / std::abs(flux[2] - flux[1])), 1.8)
      << flux[0] << " " << flux[1] << " " << flux[2];
  EXPECT_NEAR(flux[2] / flux[1], 1, 2e-3);
}

}  // namespace
}  // namespace etendue
