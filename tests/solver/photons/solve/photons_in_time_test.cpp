// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/solve/photons_in_time.h"

#include "tests/solver/photons/solve/photon_samples.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::photons_in_time_test {
namespace {

constexpr double pi = std::numbers::pi;

TimedPlaces places_of(const Problem& problem, const std::vector<Vec3>& points, double slowness) {
  const CellLocator locator(problem.mesh());
  TimedPlaces places;
  for (const Vec3& point : points) places.fluence.push_back(locator.find(point));
  places.slowness.assign(problem.media().size(), slowness);
  return places;
}

std::vector<TimedNumbers> found(const Problem& problem, const TimedPlaces& places,
                                const std::vector<TimeWindow>& windows, double photons, int threads = 2) {
  const CellLocator locator(problem.mesh());
  return photons_in_time(problem, locator, places, windows, {photons, 1, threads});
}

/// Within four standard errors, which are a part of the value at most.
void expect_near(const Estimate& estimate, double expected, double largest_error, const std::string& what) {
  EXPECT_NEAR(estimate.value, expected, 4 * estimate.error + 1e-12 * std::abs(expected)) << what;
  EXPECT_LE(estimate.error, largest_error * std::abs(expected)) << what;
}

/// Between mirrors nothing depends on the place: after a pulse the fluence is 4 pi q c/n e^(-sigma_a c t/n).
TEST(PhotonsInTime, LetAPulseDecayBetweenMirrors) {
  const TetrahedralMesh mesh = cube_with_ball(4e-2);
  Medium medium = uniform_medium(2, 0.5, 2, 0.25, PhaseHenyeyGreenstein{0.6});
  medium.absorption[1] = Coefficient(1.5);
  const Problem problem = uniform_problem(mesh, medium, uniform_wall(2, 0, 0, 1));
  const double slowness = 1.4;
  const TimedPlaces places = places_of(problem, {{0.5, 0.5, 0.5}, {0.1, 0.8, 0.3}}, slowness);
  // One after the other, within each other, and from the beginning on.
  const std::vector<TimeWindow> windows = {{0.9, 1.1, 0.2}, {0.5, 3, 2.5}, {0, 1.1, 1}, {0, 40, 1}};
  const std::vector<TimedNumbers> numbers = found(problem, places, windows, 2e5);
  ASSERT_EQ(numbers.size(), windows.size());
  for (std::size_t k = 0; k < windows.size(); ++k)
    for (std::size_t b = 0; b < 2; ++b) {
      const double rate = (b == 0 ? 0.5 : 1.5) / slowness;
      const double expected = 4 * pi * 0.25 / slowness *
                              (std::exp(-rate * windows[k].begin) - std::exp(-rate * windows[k].end)) / rate /
                              windows[k].divisor;
      const std::string what = "window " + std::to_string(k) + ", band " + std::to_string(b);
      for (std::size_t i = 0; i < 2; ++i) expect_near(numbers[k].fluence[i][b], expected, 0.1, what);
      for (std::size_t r = 0; r < mesh.region_names().size(); ++r) {
        double volume = 0;
        for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
          if (mesh.region(CellIndex(c)) == static_cast<int>(r)) volume += mesh.volume(CellIndex(c));
        expect_near(numbers[k].fluence_mean[r][b], expected, 0.02, what);
        expect_near(numbers[k].absorbed[r][b], expected * volume * rate * slowness, 0.02, what);
      }
      double incoming = 0, error = 0;
      for (const std::vector<Estimate>& wall : numbers[k].incoming) {
        incoming += wall[b].value;
        error += wall[b].error;
      }
      EXPECT_NEAR(incoming, 6 * expected / 4, 4 * error) << what;
    }
}

/// A slab of unit thickness between mirrors, lit through its floor.
Problem slab(const TetrahedralMesh& mesh, double albedo, bool diffuse) {
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, diffuse && name == "zmin" ? 1 / pi : 0, 0, name[0] == 'z' ? 0 : 1));
    walls.back().name = name;
  }
  Medium medium = uniform_medium(1, 1 - albedo, albedo, 0);
  medium.name = mesh.region_names().front();
  std::vector<Light> lights;
  if (!diffuse) {
    BeamLight beam;
    beam.direction = Vec3::UnitZ();
    beam.irradiance = {1};
    beam.walls = {static_cast<int>(wall_of(mesh, "zmin"))};
    lights.push_back({"beam", beam, {}, Uncollided::automatic});
  }
  return Problem(mesh, {}, {medium}, walls, AngularSpace::sphere, lights);
}

/// Reflected or transmitted flux over the incident one, switched on at t = 0.
struct SlabValue {
  double albedo;
  bool diffuse;
  const char* wall;
  double t, value;
};

/// From inversion of Laplace transforms with eigenvectors of 32 double-Gauss angles
/// (validation/reference/slab_switched_on.csv).
constexpr SlabValue slab_values[] = {
    {1, true, "zmin", 0.5, 0.09214655035},    {1, true, "zmin", 2.5, 0.3242885161},
    {1, true, "zmin", 7, 0.438947701},        {1, true, "zmax", 1.5, 0.2543516867},
    {1, true, "zmax", 4, 0.5050143172},       {1, true, "zmax", 20, 0.5534031816},
    {0.9, true, "zmin", 2.5, 0.2730323416},   {0.9, true, "zmax", 2.5, 0.3885894118},
    {1, false, "zmin", 0.5, 0.07023929406},   {1, false, "zmin", 7, 0.3361347394},
    {1, false, "zmax", 1.5, 0.4938674446},    {1, false, "zmax", 2.5, 0.5757501457},
    {0.9, false, "zmin", 0.5, 0.06223037167}, {0.9, false, "zmax", 1.5, 0.4767723018}};

TEST(PhotonsInTime, PassASlabAsItsTransformsSay) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  std::vector<TimeWindow> windows;
  for (const SlabValue& value : slab_values) windows.push_back({0, value.t, 1});
  for (const double albedo : {1.0, 0.9})
    for (const bool diffuse : {true, false}) {
      const Problem problem = slab(mesh, albedo, diffuse);
      const std::vector<TimedNumbers> numbers = found(problem, places_of(problem, {}, 1), windows, 4e5);
      ASSERT_EQ(numbers.size(), windows.size());
      for (std::size_t k = 0; k < windows.size(); ++k) {
        const SlabValue& expected = slab_values[k];
        if (expected.albedo != albedo || expected.diffuse != diffuse) continue;
        expect_near(numbers[k].incoming[wall_of(mesh, expected.wall)][0], expected.value, 0.01,
                    expected.wall + std::to_string(expected.t));
      }
    }
}

/// Behind a wall of radiance 1 that is switched on: phi = 2 pi times the integral over mu > x/t of
/// exp(-sigma x/mu), and nothing before t = x.
TEST(PhotonsInTime, HaveSharpFronts) {
  const TetrahedralMesh mesh = cube_mesh(2e-4);
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names())
    walls.push_back(uniform_wall(1, name == "zmin" ? 1 : 0, 0, name[0] == 'z' ? 0 : 1));
  Medium medium = uniform_medium(1, 1, 0, 0);
  const Problem problem(mesh, {}, {medium}, walls);
  const std::vector<Vec3> points = {{0.5, 0.5, 0.5}, {0.2, 0.3, 0.5}, {0.7, 0.6, 0.5}, {0.4, 0.8, 0.5}};
  const std::vector<TimedNumbers> numbers =
      found(problem, places_of(problem, points, 1), {{0, 0.4, 1}, {0, 1, 1}, {0, 2.5, 1}}, 1e6);
  ASSERT_EQ(numbers.size(), 3U);
  const double expected[] = {0, 1.585851523, 2.027485388};
  for (std::size_t k = 0; k < 3; ++k) {
    double mean = 0, square = 0;
    for (const std::vector<Estimate>& point : numbers[k].fluence) {
      mean += point[0].value / 4;
      square += std::pow(point[0].error / 4, 2);
    }
    // The linear field of a cell of a size of 0.1 is off by some 1e-3.
    EXPECT_NEAR(mean, expected[k], 4 * std::sqrt(square) + 4e-3 * expected[k]) << k;
    EXPECT_LE(std::sqrt(square), 0.02 * expected[k]) << k;
  }
}

TEST(PhotonsInTime, AreTheSameBitsForAnyNumberOfThreads) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  const Problem problem = slab(mesh, 0.9, true);
  std::vector<double> first;
  for (const int threads : {1, 2, 3}) {
    const std::vector<TimedNumbers> numbers =
        found(problem, places_of(problem, {{0.5, 0.5, 0.5}}, 1), {{0.5, 1, 0.5}}, 2e4, threads);
    const std::vector<double> values = {numbers[0].fluence[0][0].value, numbers[0].absorbed[0][0].value,
                                        numbers[0].incoming[0][0].value, numbers[0].fluence[0][0].error};
    if (threads == 1) first = values;
    EXPECT_EQ(values, first);
  }
}

TEST(PhotonsInTime, EndWhereTheyAreStopped) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  const Problem problem = slab(mesh, 0.9, true);
  const CellLocator locator(mesh);
  EXPECT_TRUE(
      photons_in_time(problem, locator, places_of(problem, {}, 1), {{0, 1, 1}}, {1e7, 1, 2}, [](double) {
        return false;
      }).empty());
}

}  // namespace
}  // namespace etendue::photons_in_time_test
