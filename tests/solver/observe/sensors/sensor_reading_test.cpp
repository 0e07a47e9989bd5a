// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/sensors/sensor_reading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "solver/uncollided/closed_form/polygon_irradiance.h"
#include "solver/uncollided/first_collision/solve_split.h"
#include "tests/solver/observe/sensors/block_mesh.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::sensor_reading_test {
namespace {

using std::numbers::pi;
using Quantity = RadiometricQuantity;

/// A solved problem with instruments in it.
struct Laboratory {
  Laboratory(const Problem& asked, DirectionSet set)
      : problem(asked),
        directions(std::move(set)),
        options(tight_options()),
        lights(problem),
        solution(solve_split(lights, directions, options)),
        scene(lights, directions, options, solution.state, 1),
        reader(lights, scene),
        locator(problem.mesh()) {}

  SensorReading read(const Sensor& sensor, int threads = 1) const {
    return reader.read(
        sensor,
        [&](const Vec3& point) {
          return PointInCell{locator.find(point).front().cell, point};
        },
        threads);
  }
  /// The first number that a sensor shows, both parts.
  double value(const Sensor& sensor, std::size_t which = 0) const {
    const Measurement found = read(sensor).measurements.at(which);
    return found.uncollided[0] + found.collided[0];
  }

  const Problem& problem;
  DirectionSet directions;
  SolveOptions options;
  LightSetup lights;
  Solution solution;
  RayRadiance scene;
  SensorReader reader;
  CellLocator locator;
};

TetrahedralMesh box() {
  return block_mesh({{{0, 0.4, 1}, {0, 0.5, 1}, {0, 0.5, 1}}}, [](const Vec3&, const Vec3& out) {
    return out.z() < -0.5 ? "floor" : out.z() > 0.5 ? "ceiling" : "side";
  });
}

Problem problem_with(const TetrahedralMesh& mesh, const Medium& medium, const Wall& wall,
                     std::vector<Light> lights) {
  std::vector<Wall> walls(mesh.wall_names().size(), wall);
  for (std::size_t w = 0; w < walls.size(); ++w) walls[w].name = mesh.wall_names()[w];
  return Problem(mesh, {}, {medium}, walls, AngularSpace::sphere, std::move(lights));
}

// Of a constant radiance u every instrument knows what it shows: pi u, 4 pi u, u, and through a cone of half
// angle a pi u sin^2 a.
TEST(SensorReader, ShowsWhatItShouldInAFurnace) {
  const TetrahedralMesh mesh = box();
  const Problem furnace = uniform_problem(
      mesh, uniform_medium(1, 0.7, 2, 0.7 * 4, PhaseHenyeyGreenstein{0.6}), uniform_wall(1, 0.3 * 4, 0.7, 0));
  const Laboratory laboratory(furnace, directions_ldfe_sq(1));
  Sensor sensor;
  sensor.direction = Vec3(0.2, 0.5, -0.3).normalized();
  sensor.half_angle = 0.3;
  for (const Vec3& place : {Vec3(0.31, 0.62, 0.43), Vec3(0.5, 0.5, 1)}) {
    sensor.position = place;
    sensor.kind = SensorKind::irradiance;
    EXPECT_NEAR(laboratory.value(sensor) / (pi * 4), 1, 2e-6);
    sensor.kind = SensorKind::fluence;
    EXPECT_NEAR(laboratory.value(sensor) / (4 * pi * 4), 1, 2e-6);
    sensor.kind = SensorKind::radiance;
    EXPECT_NEAR(laboratory.value(sensor) / 4, 1, 2e-6);
    sensor.kind = SensorKind::cone;
    EXPECT_NEAR(laboratory.value(sensor, 0) / 4, 1, 2e-6);
    EXPECT_NEAR(laboratory.value(sensor, 1) / (4 * pi * std::pow(std::sin(0.3), 2)), 1, 2e-6);
  }
}

// The sky of Moon and Spencer (1942), L = (1 + 2 sin(elevation))/3, brings 7 pi/9 to the ground.
TEST(SensorReader, SeesASkyByFormula) {
  const TetrahedralMesh mesh = box();
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  for (std::size_t w = 0; w < walls.size(); ++w) {
    walls[w].name = mesh.wall_names()[w];
    if (walls[w].name != "floor") walls[w].radiance_by_direction = {AngularFormula("(1 + 2*max(0, -wz))/3")};
  }
  const Problem outdoors(mesh, {}, {uniform_medium(1, 0, 0, 0)}, walls);
  const Laboratory laboratory(outdoors, directions_product(2));
  Sensor sensor;
  sensor.position = {0.3, 0.6, 0};
  EXPECT_NEAR(laboratory.value(sensor), 2.44346095279, 1e-6);
}

// Through a wall of area 1 goes pi u each way, within a cone about its normal pi u sin^2; its exitance is pi
// u.
TEST(SensorReader, CountsWhatGoesThroughAWallInAFurnace) {
  const TetrahedralMesh mesh = box();
  const Problem furnace =
      uniform_problem(mesh, uniform_medium(1, 0.7, 2, 0.7 * 4), uniform_wall(1, 0.3 * 4, 0.5, 0.2));
  const Laboratory laboratory(furnace, directions_ldfe_sq(1));
  Sensor sensor;
  sensor.kind = SensorKind::flux;
  sensor.wall = static_cast<int>(std::ranges::find(mesh.wall_names(), "floor") - mesh.wall_names().begin());
  for (const std::size_t way : {0, 1}) EXPECT_NEAR(laboratory.value(sensor, way) / (pi * 4), 1, 3e-6);
  sensor.half_angle = 0.4;
  for (const double up : {1, -1}) {
    sensor.direction = {0, 0, up};
    EXPECT_NEAR(laboratory.value(sensor, up > 0 ? 0 : 1) / (pi * 4 * std::pow(std::sin(0.4), 2)), 1, 3e-6);
    EXPECT_EQ(laboratory.value(sensor, up > 0 ? 1 : 0), 0);
  }
  sensor.kind = SensorKind::exitance;
  sensor.direction = Vec3::UnitZ();
  sensor.position = {0.3, 0.6, 0};
  EXPECT_NEAR(laboratory.value(sensor) / (pi * 4), 1, 3e-6);
}

// A ceiling of radiance 5 sends 5 pi; the floor sends back half of what it gets, a tenth of all as a mirror:
// beside mirrors the irradiance is a sum of beams, and of the image rays see the edges, within 1e-3.
TEST(SensorReader, KeepsWhatWallsGetAndSendApart) {
  const TetrahedralMesh mesh = box();
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  for (std::size_t w = 0; w < walls.size(); ++w) {
    walls[w].name = mesh.wall_names()[w];
    if (walls[w].name == "ceiling") walls[w] = uniform_wall(1, 5, 0, 0), walls[w].name = "ceiling";
    if (walls[w].name == "floor") walls[w] = uniform_wall(1, 0, 0.4, 0.1), walls[w].name = "floor";
    walls[w].uncollided = Uncollided::yes;
  }
  const Problem room(mesh, {}, {uniform_medium(1, 0.1, 0, 0)}, walls);
  const Laboratory laboratory(room, directions_ldfe_sq(1));
  Sensor sensor;
  sensor.kind = SensorKind::exitance;
  sensor.position = {0.3, 0.6, 1};
  sensor.direction = -Vec3::UnitZ();
  EXPECT_NEAR(laboratory.value(sensor) / (5 * pi), 1, 1e-6);
  sensor.position = {0.3, 0.6, 0};
  sensor.direction = Vec3::UnitZ();
  const double sent = laboratory.value(sensor);
  sensor.kind = SensorKind::irradiance;
  EXPECT_NEAR(sent / laboratory.value(sensor), 0.5, 2e-3);
  sensor.kind = SensorKind::flux;
  const auto number = [&](const std::string& name) {
    return static_cast<int>(std::ranges::find(mesh.wall_names(), name) - mesh.wall_names().begin());
  };
  sensor.wall = number("ceiling");
  EXPECT_NEAR(laboratory.value(sensor, 1) / (5 * pi), 1, 1e-6);
  sensor.wall = number("floor");
  EXPECT_NEAR(laboratory.value(sensor, 1) / laboratory.value(sensor, 0), 0.5, 2e-3);
}

// At a lit floor under a shining ceiling: what is incident on it looks up, what is exitant looks at it. What
// a diffuse floor sends is rho E/pi in all directions, a mirror what comes from above; its exitance is its
// radiosity, and lamplight that it reflects diffusely has collided.
TEST(SensorReader, TellsIncidentFromExitantRadiance) {
  const TetrahedralMesh mesh = box();
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const std::string& name = mesh.wall_names()[w];
    if (name == "ceiling") walls[w] = uniform_wall(1, 5, 0, 0);
    if (name == "floor") walls[w] = uniform_wall(1, 2, 0.4, 0);
    walls[w].name = name;
    walls[w].uncollided = Uncollided::yes;
  }
  const Problem room(mesh, {}, {uniform_medium(1, 0, 0, 0)}, walls);
  const Laboratory laboratory(room, directions_ldfe_sq(1));
  Sensor sensor;
  sensor.position = {0.3, 0.6, 0};
  sensor.kind = SensorKind::irradiance;
  const double reflected = 0.4 * laboratory.value(sensor);
  sensor.kind = SensorKind::radiosity;
  const Measurement radiosity = laboratory.read(sensor).measurements.at(0);
  EXPECT_EQ(radiosity.quantity, Quantity::radiosity);
  EXPECT_NEAR(radiosity.uncollided[0] / (2 * pi), 1, 1e-6);
  EXPECT_NEAR(radiosity.collided[0] / reflected, 1, 1e-6);
  sensor.kind = SensorKind::exitance;
  EXPECT_EQ(laboratory.read(sensor).measurements.at(0).collided, radiosity.collided);
  sensor.kind = SensorKind::radiance;
  for (const Vec3& leaning : {Vec3(0, 0, 1), Vec3(0.1, -0.2, 1)}) {
    sensor.direction = leaning.normalized();
    EXPECT_NEAR(laboratory.value(sensor) / 5, 1, 1e-12) << "incident";
    sensor.direction = -leaning.normalized();
    EXPECT_NEAR(laboratory.value(sensor) / (2 + reflected / pi), 1, 1e-3) << "exitant";
  }
}

// A lamp seen through absorbing gas: both parts of every reading are known.
TEST(SensorReader, KeepsTheLightOfLightsApart) {
  const TetrahedralMesh mesh = box();
  const SurfaceLight lamp{
      {{0.4, 0.4, 0.9}, {0.6, 0.6, 0.9}, {0.6, 0.4, 0.9}, {0.4, 0.4, 0.9}, {0.4, 0.6, 0.9}, {0.6, 0.6, 0.9}},
      {5}};
  const Problem room =
      problem_with(mesh, uniform_medium(1, 0.5, 0, 0.1), uniform_wall(1, 0, 0, 0), {{"lamp", lamp, {}}});
  const Laboratory laboratory(room, directions_product(2));
  Sensor sensor;
  sensor.position = {0.5, 0.5, 0};
  sensor.kind = SensorKind::radiance;
  const Measurement up = laboratory.read(sensor).measurements.at(0);
  EXPECT_NEAR(up.uncollided[0], 5 * std::exp(-0.45), 1e-12);
  EXPECT_NEAR(up.collided[0], 0.1 / 0.5 * (1 - std::exp(-0.5)), 1e-12);
  // Through a cone that the lamp fills: the attenuation along the slant, h/cos, averaged with the cosine.
  sensor.kind = SensorKind::cone;
  sensor.half_angle = 0.1;
  const Measurement mean = laboratory.read(sensor).measurements.at(1);
  double expected = 0;
  constexpr int steps = 2000;
  for (int i = 0; i < steps; ++i) {
    const double angle = 0.1 * (i + 0.5) / steps;
    expected +=
        2 * pi * 5 * std::exp(-0.45 / std::cos(angle)) * std::sin(angle) * std::cos(angle) * 0.1 / steps;
  }
  EXPECT_NEAR(mean.uncollided[0] / expected, 1, 1e-6);
}

// A point light is a beam: within the cone or not.
TEST(SensorReader, CountsAPointLightWithinItsCone) {
  const TetrahedralMesh mesh = box();
  const Problem room =
      problem_with(mesh, uniform_medium(1, 0.5, 0, 0), uniform_wall(1, 0, 0, 0),
                   {{"bulb", PointLight{{0.5, 0.5, 0.9}, {4 * pi}, Vec3::UnitZ(), {}, {}}, {}}});
  const Laboratory laboratory(room, directions_product(2));
  Sensor sensor;
  sensor.position = {0.5, 0.5, 0.1};
  sensor.kind = SensorKind::cone;
  sensor.half_angle = 0.2;
  const double arriving = std::exp(-0.5 * 0.8) / (0.8 * 0.8);
  sensor.direction = Vec3(std::sin(0.19), 0, std::cos(0.19));
  EXPECT_NEAR(laboratory.value(sensor, 1), arriving * std::cos(0.19), 1e-12);
  const Cone seen{Vec3::UnitZ(), 0.2};
  EXPECT_NEAR(laboratory.value(sensor, 0), arriving / seen.solid_angle(), 1e-11);
  sensor.direction = Vec3(std::sin(0.21), 0, std::cos(0.21));
  EXPECT_EQ(laboratory.value(sensor, 1), 0);
}

// The meter that sums over directions and the one that looks along rays measure the same; the directions
// differ by a few per cent among themselves.
TEST(SensorReader, AgreesWithASumOverDirections) {
  const TetrahedralMesh mesh =
      block_mesh({{{0, 0.25, 0.5, 0.75, 1}, {0, 0.25, 0.5, 0.75, 1}, {0, 0.25, 0.5, 0.75, 1}}},
                 [](const Vec3&, const Vec3&) { return "side"; });
  const Problem haze = uniform_problem(mesh, uniform_medium(1, 0.5, 1, 1), uniform_wall(1, 0, 0.5, 0));
  const Laboratory laboratory(haze, directions_ldfe_sq(2));
  SolveOptions options = tight_options();
  const Vec3 place(0.52, 0.47, 0.1), normal = Vec3::UnitZ();
  options.meters = {{laboratory.locator.find(place), normal}};
  const Solution metered = solve_split(laboratory.lights, laboratory.directions, options);
  Sensor sensor;
  sensor.position = place;
  EXPECT_NEAR(laboratory.value(sensor) / metered.meters[0], 1, 0.01);
}

TEST(SensorReader, GridsAreTheirPointsForAnyNumberOfThreads) {
  const TetrahedralMesh mesh = box();
  const Problem room =
      problem_with(mesh, uniform_medium(1, 0.2, 0.3, 0.1), uniform_wall(1, 0, 0.5, 0),
                   {{"bulb", PointLight{{0.5, 0.5, 0.9}, {4 * pi}, Vec3::UnitZ(), {}, {}}, {}}});
  const Laboratory laboratory(room, directions_product(2));
  Sensor grid;
  grid.kind = SensorKind::grid;
  grid.sides = {Vec3(1, 0, 0), Vec3(0, 0.5, 0)};
  grid.count = {3, 2};
  grid.rays = 200;
  const SensorReading one = laboratory.read(grid, 1), two = laboratory.read(grid, 2);
  ASSERT_EQ(one.grid.collided.size(), 6u);
  EXPECT_EQ(one.grid.collided, two.grid.collided);
  EXPECT_EQ(one.grid.uncollided, two.grid.uncollided);
  Sensor point = grid;
  point.kind = SensorKind::irradiance;
  point.position = grid_point(grid, 2, 1);
  EXPECT_NEAR((point.position - Vec3(5. / 6, 0.375, 0)).norm(), 0, 1e-15);
  const Measurement single = laboratory.read(point).measurements.at(0);
  EXPECT_EQ(single.collided[0], one.grid.collided[5]);
  EXPECT_EQ(single.uncollided[0], one.grid.uncollided[5]);
  double mean = 0;
  for (std::size_t i = 0; i < 6; ++i) mean += (one.grid.collided[i] + one.grid.uncollided[i]) / 6;
  EXPECT_NEAR(laboratory.value(grid, 0), mean, 1e-14);
  EXPECT_LT(laboratory.value(grid, 1), mean);
  EXPECT_GT(laboratory.value(grid, 2), mean);
  // Where there is no cell there is no number.
  const auto beside_a_hole = [&](const Vec3& at) {
    return at.x() < 0.3 ? std::nullopt
                        : std::optional(PointInCell{laboratory.locator.find(at).front().cell, at});
  };
  const SensorReading partly = laboratory.reader.read(grid, beside_a_hole, 1);
  EXPECT_TRUE(std::isnan(partly.grid.collided[0]));
  EXPECT_EQ(partly.grid.collided[5], one.grid.collided[5]);
  double rest = 0;
  for (const std::size_t i : {1, 2, 4, 5}) rest += one.grid.collided[i] / 4;
  EXPECT_NEAR(partly.measurements.at(0).collided[0], rest, 1e-14);
}

// The example of the definition of flux: of radiance 4 everywhere 4 x 0.01 x 0.05 cos t = 0.002 cos t goes
// through a square of area 0.01 within a cone of 0.05 sr about a direction at the angle t to its normal,
// times (1 + cos a)/2, by which the cone's half angle a makes the mean cosine smaller. Nothing goes the other
// way.
TEST(SensorReader, MeasuresTheFluxThroughAPolygonWithinACone) {
  const TetrahedralMesh mesh = box();
  const Problem furnace =
      uniform_problem(mesh, uniform_medium(1, 0.7, 2, 0.7 * 4), uniform_wall(1, 0.3 * 4, 0.7, 0));
  const Laboratory laboratory(furnace, directions_ldfe_sq(1));
  Sensor sensor;
  sensor.kind = SensorKind::flux;
  sensor.polygon = {{0.4, 0.4, 0.3}, {0.5, 0.4, 0.3}, {0.5, 0.5, 0.3}, {0.4, 0.5, 0.3}};
  sensor.count = {1, 1};
  sensor.half_angle = std::acos(1 - 0.05 / (2 * pi));
  for (const double tilt : {0., 0.5, 1.2}) {
    sensor.direction = -Vec3(std::sin(tilt), 0, std::cos(tilt));
    const double expected = 0.002 * std::cos(tilt) * (1 + std::cos(sensor.half_angle)) / 2;
    EXPECT_NEAR(laboratory.value(sensor, 0), expected, 4e-9) << tilt;
    EXPECT_NEAR(laboratory.value(sensor, 1), 0, 1e-15) << tilt;
    EXPECT_NEAR(laboratory.value(sensor, 2), expected, 4e-9) << tilt;
  }
  sensor.half_angle = 0;
  EXPECT_NEAR(laboratory.value(sensor, 0), 0.01 * pi * 4, 1e-6);
  EXPECT_NEAR(laboratory.value(sensor, 1), 0.01 * pi * 4, 1e-6);
  EXPECT_NEAR(laboratory.value(sensor, 2), 0, 1e-7);
}

// A ceiling that shines and its image behind a mirror: E = L (E_p + rho E_p of the moved meter), and so the
// fluence; behind two mirrors at right angles there are three images.
TEST(SensorReader, SeesLightsInMirrorsExactly) {
  const TetrahedralMesh mesh =
      block_mesh({{{0, 0.4, 1}, {0, 0.5, 1}, {0, 0.5, 1}}}, [](const Vec3&, const Vec3& out) {
        if (out.z() > 0.5) return "ceiling";
        return out.x() > 0.5 ? "mirror" : out.y() > 0.5 ? "dim" : "side";
      });
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, name == "ceiling" ? 2 : 0, 0,
                                 name == "mirror" ? 0.8
                                 : name == "dim"  ? 0.5
                                                  : 0));
    walls.back().name = name;
    walls.back().uncollided = Uncollided::yes;
  }
  const Problem room(mesh, {}, {uniform_medium(1, 0, 0, 0)}, walls);
  const LightSetup lights(room);
  const Vec3 place(0.7, 0.35, 0.2), normal = Vec3(0.4, 0.2, 0.9).normalized();
  const std::array<Vec3, 4> ceiling = {Vec3(0, 0, 1), {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  double irradiance = 0, fluence = 0;
  for (const bool in_x : {false, true})
    for (const bool in_y : {false, true}) {
      const double left = (in_x ? 0.8 : 1) * (in_y ? 0.5 : 1) * 2;
      std::array<Vec3, 4> seen = ceiling;
      for (Vec3& corner : seen) {
        if (in_x) corner.x() = 2 - corner.x();
        if (in_y) corner.y() = 2 - corner.y();
        corner -= place;
      }
      irradiance += left * polygon_irradiance(seen, normal);
      fluence += left * (triangle_solid_angle({seen[0], seen[1], seen[2]}) +
                         triangle_solid_angle({seen[0], seen[2], seen[3]}));
    }
  const UncollidedAtPoint found =
      LightIrradiance(lights).at({CellLocator(mesh).find(place).front().cell, place}, normal);
  EXPECT_NEAR(found.irradiance[0] / irradiance, 1, 1e-9);
  EXPECT_NEAR(found.fluence[0] / fluence, 1, 1e-9);
}

// A bulb inside a closed box of polygons sends its power through them, at order 2 and better in their parts.
TEST(SensorReader, FluxThroughPolygonsConvergesToThePowerInside) {
  const TetrahedralMesh mesh = box();
  const Problem room =
      problem_with(mesh, uniform_medium(1, 0, 0, 0), uniform_wall(1, 0, 0, 0),
                   {{"bulb", PointLight{{0.5, 0.45, 0.55}, {3}, Vec3::UnitZ(), {}, {}}, {}}});
  const Laboratory laboratory(room, directions_product(2));
  std::vector<double> errors;
  for (const int parts : {2, 4, 8}) {
    double power = 0;
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {-1., 1.}) {
        const Vec3 n = side * Vec3::Unit(axis), u = Vec3::Unit((axis + 1) % 3), v = n.cross(u);
        Sensor sensor;
        sensor.kind = SensorKind::flux;
        sensor.count = {parts, parts};
        sensor.rays = 68;
        for (const auto& [a, b] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
          sensor.polygon.push_back(Vec3(0.5, 0.5, 0.5) + 0.3 * (n + a * u + b * v));
        const Measurement net = laboratory.read(sensor).measurements.at(2);
        power += net.uncollided[0] + net.collided[0];
      }
    errors.push_back(std::abs(power / 3 - 1));
  }
  EXPECT_GT(errors[0] / errors[1], 4);
  EXPECT_GT(errors[1] / errors[2], 4);
  EXPECT_LT(errors[2], 1e-4);
}

}  // namespace
}  // namespace etendue::sensor_reading_test
