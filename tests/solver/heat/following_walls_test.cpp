// SPDX-License-Identifier: AGPL-3.0-or-later
// Walls whose temperature follows, against closed forms between parallel plates and gray walls that reflect
// what they absorb.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/blackbody.h"
#include "solver/heat/temperature_iteration.h"
#include "solver/problem/band_blackbody.h"
#include "solver/solution/balance.h"
#include "solver/transport/solve/solve.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::following_walls_test {
namespace {

const Bands two_bands{{"short", "long"}, {1, 4000, 1e9}};
using Emissivities = std::vector<double>;  ///< [band]

/// A wall of a cube: its temperature, or the heat that it follows from; a mirror where it has neither.
struct Plate {
  Emissivities emissivity = {};
  std::optional<double> temperature = {};
  std::optional<HeatWall> heat = {};
};

struct Cube {
  Bands bands;
  Medium medium;
  double conductivity = 0;
  Plate below, above;
  Plate sides = {};
  double start = HeatProblem{}.start;

  const Plate& plate(const std::string& wall) const {
    return wall == "zmin" ? below : wall == "zmax" ? above : sides;
  }
};

struct Balanced {
  Solution solution;
  HeatSolution heat;
  std::vector<double> net;  ///< [wall] by radiation [W]

  /// Of the vertices of one wall.
  std::pair<double, double> range(const TetrahedralMesh& mesh, const std::string& name) const {
    std::vector<double> values;
    for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
      for (std::size_t i = 0; i < 3; ++i)
        if (mesh.wall_names()[static_cast<std::size_t>(mesh.wall(FaceIndex(f)))] == name)
          values.push_back(heat.wall_temperature[static_cast<std::size_t>(3 * f) + i]);
    const auto [least, most] = std::ranges::minmax(values);
    return {least, most};
  }
};

DirectionSet directions() { return directions_product(4); }

Balanced solved(const TetrahedralMesh& mesh, const Cube& cube, double tolerance = 1e-10) {
  std::vector<Wall> walls;
  HeatProblem heat;
  const int bands = cube.bands.count();
  for (const std::string& name : mesh.wall_names()) {
    const Plate& plate = cube.plate(name);
    Wall wall = uniform_wall(bands, 0, 0, plate.emissivity.empty() ? 1 : 0);
    wall.name = name;
    for (std::size_t b = 0; b < plate.emissivity.size(); ++b) {
      wall.diffuse[b] = 1 - plate.emissivity[b];
      if (plate.temperature)
        wall.radiance[b] =
            plate.emissivity[b] * band_blackbody(cube.bands, static_cast<int>(b), *plate.temperature);
    }
    wall.emission_follows = plate.heat.has_value();
    walls.push_back(wall);
    heat.wall_temperatures.emplace_back();
    if (plate.temperature) heat.wall_temperatures.back() = Coefficient(*plate.temperature);
    heat.walls.push_back(plate.heat);
  }
  heat.media.resize(mesh.region_names().size());
  heat.start = cube.start;
  if (cube.conductivity > 0) heat.media.front() = HeatMedium{cube.conductivity, 0};
  Problem problem(mesh, cube.bands, std::vector<Medium>(mesh.region_names().size(), cube.medium), walls);
  TemperatureIteration temperatures(problem, heat);
  SolveOptions options = tight_options();
  options.tolerance = tolerance;
  options.following_emission = &temperatures;
  Balanced result{solve(problem, directions(), options), temperatures.solution(), {}};
  problem.set_following(temperatures.sources());
  for (const auto& wall : wall_powers(problem, result.solution)) {
    result.net.push_back(0);
    for (const WallPower& band : wall) result.net.back() += band.incoming - band.outgoing;
  }
  return result;
}

std::size_t number_of(const TetrahedralMesh& mesh, const std::string& wall) {
  return static_cast<std::size_t>(std::ranges::find(mesh.wall_names(), wall) - mesh.wall_names().begin());
}

/// Where a function that rises is zero.
template <class Function>
double zero_of(const Function& function, double low, double high) {
  for (int i = 0; i < 200; ++i) (function((low + high) / 2) < 0 ? low : high) = (low + high) / 2;
  return low;
}

/// Net radiative heat flux between infinite parallel plates, from the first to the second [W/m^2], where a
/// wall sends its radiance times the half range of the directions.
double plates_flux(const Cube& cube, double first, double second) {
  double flux = 0;
  for (int band = 0; band < cube.bands.count(); ++band) {
    const auto b = static_cast<std::size_t>(band);
    flux += directions().half_range(Vec3::UnitZ()) *
            (band_blackbody(cube.bands, band, first) - band_blackbody(cube.bands, band, second)) /
            (1 / cube.below.emissivity[b] + 1 / cube.above.emissivity[b] - 1);
  }
  return flux;
}

TEST(FollowingWalls, HaveTheTemperatureOfAnIsothermalEnclosure) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  for (const double conductivity : {0.0, 2.0}) {
    const Plate given{{0.7, 0.4}, 800.0, {}};
    const Plate adiabatic{{0.3, 0.8}, {}, HeatWall{}};
    const Plate convective{{0.6, 0.9}, {}, HeatWall{0, 20, 800}};
    // A medium whose temperature does not follow is transparent.
    const double absorption = conductivity > 0 ? 0.5 : 0;
    const Balanced found = solved(
        mesh, {two_bands, uniform_medium(2, absorption, 0.5, 0), conductivity, given, adiabatic, convective});
    ASSERT_TRUE(found.solution.converged());
    for (const char* wall : {"zmax", "xmin", "ymax"}) {
      EXPECT_NEAR(found.range(mesh, wall).first, 800, 1e-4) << wall;
      EXPECT_NEAR(found.range(mesh, wall).second, 800, 1e-4) << wall;
    }
  }
}

TEST(FollowingWalls, ByConvectionBetweenPlates) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  for (const double h : {1.0, 30.0, 3000.0})
    for (const double flux : {0.0, 8000.0}) {
      const Cube cube{two_bands,
                      uniform_medium(2, 0, 0, 0),
                      0,
                      {{0.9, 0.5}, 1300.0, {}},
                      {{0.4, 0.8}, {}, HeatWall{flux, h, 350}}};
      const Balanced found = solved(mesh, cube);
      ASSERT_TRUE(found.solution.converged());
      const double exact =
          zero_of([&](double t) { return h * (t - 350) - flux - plates_flux(cube, 1300, t); }, 100, 3000);
      EXPECT_NEAR(found.range(mesh, "zmax").first, exact, 1e-5) << h << " " << flux;
      EXPECT_NEAR(found.range(mesh, "zmax").second, exact, 1e-5) << h << " " << flux;
      const std::size_t wall = number_of(mesh, "zmax");
      EXPECT_NEAR(found.heat.convected[wall], h * (exact - 350), 1e-6 * (h * (exact - 350) + flux));
      EXPECT_NEAR(found.net[wall] + flux, found.heat.convected[wall], 1e-6 * (h * (exact - 350) + flux));
    }
}

TEST(FollowingWalls, ByConvectionFarHotterThanAllElse) {
  const TetrahedralMesh mesh = cube_mesh(4e-3);
  for (const double ambient : {1000.0, 2200.0})
    for (const double h : {1.0, 1e2, 1e3, 1e4, 1e5}) {
      const Cube cube{two_bands,
                      uniform_medium(2, 0, 0, 0),
                      0,
                      {{0.9, 0.5}, 300.0, {}},
                      {{0.4, 0.8}, {}, HeatWall{0, h, ambient}},
                      {{1, 1}, 300.0, {}}};
      const Balanced found = solved(mesh, cube, 1e-8);
      ASSERT_TRUE(found.solution.converged()) << ambient << " " << h;
      EXPECT_LE(found.solution.convergence.front().sweeps, 60) << ambient << " " << h;
      const auto [least, most] = found.range(mesh, "zmax");
      EXPECT_GT(least, 300) << ambient << " " << h;
      EXPECT_LT(most, ambient) << ambient << " " << h;
      const std::size_t wall = number_of(mesh, "zmax");
      EXPECT_NEAR(found.net[wall] / found.heat.convected[wall], 1, 1e-5) << ambient << " " << h;
    }
}

TEST(FollowingWalls, BesideAConductor) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  for (const double k : {0.01, 5.0, 500.0}) {
    const Cube cube{
        Bands{}, uniform_medium(1, 0, 0, 0), k, {{0.9}, 900.0, {}}, {{0.6}, {}, HeatWall{500, 40, 300}}};
    const Balanced found = solved(mesh, cube);
    ASSERT_TRUE(found.solution.converged());
    const double exact =
        zero_of([&](double t) { return 40 * (t - 300) - 500 - plates_flux(cube, 900, t) - k * (900 - t); },
                100, 3000);
    EXPECT_NEAR(found.range(mesh, "zmax").first, exact, 1e-5) << k;
    EXPECT_NEAR(found.range(mesh, "zmax").second, exact, 1e-5) << k;
    const std::size_t wall = number_of(mesh, "zmax");
    EXPECT_NEAR(found.heat.conducted[wall], k * (900 - exact), 1e-6 * k * 900) << k;
  }
}

// A gray wall that gives back what it absorbs reflects it: so, and by temperatures in two bands that are
// alike, it is the same.
TEST(FollowingWalls, AgreeWithReflectionInGrayRooms) {
  const TetrahedralMesh mesh = cube_mesh(4e-3);
  const Plate hot{{0.8, 0.8}, 1400.0, {}}, cold{{0.5, 0.5}, 400.0, {}};
  const Plate refractory{
      {0.6, 0.6}, {}, HeatWall{3000 * directions().half_range(Vec3::UnitZ()) / std::numbers::pi}};
  const Balanced found = solved(mesh, {two_bands, uniform_medium(2, 0.3, 0.2, 0), 0, hot, refractory, cold});
  ASSERT_TRUE(found.solution.converged());
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    Wall wall = uniform_wall(1, 0, name == "zmin" ? 0.2 : name == "zmax" ? 1 : 0.5, 0);
    wall.radiance.front() = name == "zmax" ? 3000 / std::numbers::pi
                                           : (1 - wall.diffuse.front()) * stefan_boltzmann /
                                                 std::numbers::pi * std::pow(name == "zmin" ? 1400 : 400, 4);
    wall.name = name;
    walls.push_back(wall);
  }
  const Problem gray(mesh, Bands{}, {uniform_medium(1, 0.3, 0.2, 0)}, walls);
  SolveOptions options = tight_options();
  options.tolerance = 1e-10;
  const Solution reflected = solve(gray, directions(), options);
  double largest = 0;
  std::size_t compared = 0;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    if (mesh.wall_names()[static_cast<std::size_t>(mesh.wall(FaceIndex(f)))] != "zmax") continue;
    for (std::size_t i = 0; i < 3; ++i, ++compared) {
      const std::size_t at = static_cast<std::size_t>(3 * f) + i;
      // Of radiances times the half range, as all walls send.
      const double radiance = reflected.irradiance[at] / reflected.half_range[static_cast<std::size_t>(f)] +
                              3000 / 0.6 / std::numbers::pi;
      largest = std::max(largest, std::abs(found.heat.wall_temperature[at] -
                                           std::pow(std::numbers::pi * radiance / stefan_boltzmann, 0.25)));
    }
  }
  EXPECT_GT(compared, 0u);
  EXPECT_LT(largest, 1e-4);
}

TEST(FollowingWalls, TakeFewSweeps) {
  const TetrahedralMesh mesh = cube_mesh(4e-3);
  for (const double emissivity : {0.3, 1.0})
    for (const double absorption : {0.0, 1.0}) {
      const Plate hot{{emissivity, emissivity}, 1400.0, {}}, cold{{emissivity, emissivity}, 400.0, {}};
      const Plate refractory{{emissivity, emissivity}, {}, HeatWall{}};
      const Balanced found = solved(
          mesh, {two_bands, uniform_medium(2, absorption, 0, 0), 0, hot, cold, refractory, 1180}, 1e-6);
      EXPECT_TRUE(found.solution.converged());
      EXPECT_LE(found.solution.convergence.front().sweeps, emissivity < 1 ? 50 : 15)
          << emissivity << " " << absorption;
    }
}

}  // namespace
}  // namespace etendue::following_walls_test
