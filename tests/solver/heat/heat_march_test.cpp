// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/heat/heat_march.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/blackbody.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/transport/solve/transport_solver.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"
#include "tests/solver/heat/heated_room.h"

namespace etendue::heat_march_test {
namespace {

using heated_room::Room;
using heated_room::walls_of;

constexpr double kTolerance = 1e-10;

HeatProblem in_time(HeatProblem heat, const ThermalProperty& capacity, const Coefficient& initial) {
  heat.changes_in_time = true;
  for (auto& medium : heat.media) {
    medium->in_time.capacity = capacity;
    medium->in_time.initial = initial;
  }
  return heat;
}

/// Walls that give no heat away and hold none, of a room whose walls follow.
HeatProblem insulated(HeatProblem heat) {
  for (std::size_t w = 0; w < heat.walls.size(); ++w) {
    heat.wall_temperatures[w].reset();
    heat.walls[w] = HeatWall{};
  }
  return heat;
}

ThermalProperty by_temperature(const char* formula) {
  return ThermalProperty(Expression(Formula(formula), {"x", "y", "z", "T"}));
}

struct Marched {
  std::vector<double> times;
  std::vector<std::vector<double>> temperatures;  ///< [step][cell][4] [K]
  std::vector<HeatSolution> heat;                 ///< [step]
  double missing = 0;                             ///< the largest of a step [J]
  std::vector<double> stored;                     ///< [step] [J]

  double mean(std::size_t step) const {
    double sum = 0;
    for (const double kelvin : temperatures[step]) sum += kelvin;
    return sum / static_cast<double>(temperatures[step].size());
  }
};

Marched march(const Room& room, const HeatProblem& heat, const StepPlan& plan,
              const DirectionSet& directions = directions_product(2)) {
  Problem problem = room.problem();
  TemperatureIteration temperatures(problem, heat);
  SolveOptions options = tight_options();
  options.tolerance = kTolerance;
  options.following_emission = &temperatures;
  TransportSolver solver(problem, directions, options);
  Marched result;
  march_heat(
      temperatures, [&] { return solver.solve(); }, plan,
      [&](const HeatStep& step) {
        EXPECT_TRUE(step.converged);
        result.times.push_back(step.end);
        result.heat.push_back(temperatures.solution());
        result.temperatures.push_back(result.heat.back().temperature);
        result.missing = std::max(result.missing, step.missing);
        result.stored.push_back(step.stored);
        return true;
      });
  return result;
}

StepPlan even(StepMethod method, double until, int steps) { return {method, until, until / steps, 0, {}}; }

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

// In a closed room of one temperature radiation and conduction move nothing: c dT/dt = s.
TEST(HeatMarch, HeatsAClosedRoomByItsSource) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  for (const double conductivity : {0.0, 5.0})
    for (const StepMethod method : {StepMethod::sdirk2, StepMethod::bdf2}) {
      const Room room{mesh, Bands{}, uniform_medium(1, 0.7, 0.2, 0), 0.8, walls_of(mesh, 0, 0), conductivity,
                      2000, true};
      const HeatProblem heat = insulated(in_time(room.heat(), 40.0, 500.0));
      const Marched marched = march(room, heat, even(method, 6, 3));
      ASSERT_EQ(marched.times.size(), 3u);
      for (std::size_t step = 0; step < 3; ++step) {
        const double exact = 500 + 2000 / 40.0 * marched.times[step];
        for (const double kelvin : marched.temperatures[step]) EXPECT_NEAR(kelvin, exact, 1e-4);
        EXPECT_NEAR(marched.stored[step], 2000 * marched.times[step], 0.01);
      }
      EXPECT_LT(marched.missing, 0.01);
    }
}

// With c = a T^3 the heat is a T^4/4: the stages know it exactly, and steps of second order keep it.
TEST(HeatMarch, StoresHeatByACapacityThatGrows) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  const Room room{mesh, Bands{}, uniform_medium(1, 0.7, 0, 0), 1, walls_of(mesh, 0, 0), 0, 3000, true};
  const HeatProblem heat = insulated(in_time(room.heat(), by_temperature("4e-7*T^3"), 300.0));
  const Marched marched = march(room, heat, even(StepMethod::sdirk2, 8, 2));
  ASSERT_EQ(marched.times.size(), 2u);
  const double exact = std::pow(std::pow(300.0, 4) + 3000 * 8 / 1e-7, 0.25);
  for (const double kelvin : marched.temperatures.back()) EXPECT_NEAR(kelvin, exact, 1e-4);
}

TEST(HeatMarch, FollowsASourceInTime) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  const Room room{mesh, Bands{}, uniform_medium(1, 0.7, 0, 0), 1, walls_of(mesh, 0, 0), 0, 2000, true};
  HeatProblem heat = insulated(in_time(room.heat(), 40.0, 500.0));
  for (auto& medium : heat.media) medium->in_time.factor = [](double t) { return t; };
  const Marched marched = march(room, heat, even(StepMethod::sdirk2, 6, 2));
  ASSERT_EQ(marched.times.size(), 2u);
  EXPECT_NEAR(marched.mean(1), 500 + 2000 / 40.0 * 18, 1e-4);
}

// A thin gas among cold walls loses what it emits: c dT/dt = -4 kappa sigma T^4. By steps of second order,
// errors fall by four where steps are halved.
TEST(HeatMarch, CoolsAThinGasInSecondOrder) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  const double kappa = 1e-6, capacity = 1e-3;
  const Room room{mesh, Bands{}, uniform_medium(1, kappa, 0, 0), 1, walls_of(mesh, 0, 0)};
  const HeatProblem heat = in_time(room.heat(), capacity, 1500.0);
  const double until = 3;
  const double exact =
      1500 * std::cbrt(1 / (1 + 12 * kappa * stefan_boltzmann * std::pow(1500.0, 3) * until / capacity));
  ASSERT_LT(exact, 1100);
  for (const StepMethod method : {StepMethod::sdirk2, StepMethod::bdf2}) {
    std::vector<double> errors;
    for (const int steps : {8, 16, 32})
      errors.push_back(std::abs(
          march(room, heat, even(method, until, steps)).mean(static_cast<std::size_t>(steps - 1)) - exact));
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.25);
    EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2, 0.15);
    EXPECT_LT(errors[2], 2);
  }
}

TEST(HeatMarch, AdaptsItsStepsToATolerance) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  const double kappa = 1e-6, capacity = 1e-3;
  const Room room{mesh, Bands{}, uniform_medium(1, kappa, 0, 0), 1, walls_of(mesh, 0, 0)};
  const HeatProblem heat = in_time(room.heat(), capacity, 1500.0);
  const Marched marched = march(room, heat, {StepMethod::sdirk2, 300, 100, 1e-3, {50}});
  const double rate = 12 * kappa * stefan_boltzmann * std::pow(1500.0, 3) / capacity;
  ASSERT_GT(marched.times.size(), 8u);
  EXPECT_LT(marched.times.front(), marched.times.back() - marched.times[marched.times.size() - 2]);
  EXPECT_NE(std::ranges::find(marched.times, 50.0), marched.times.end());
  EXPECT_EQ(marched.times.back(), 300);
  for (std::size_t step = 0; step < marched.times.size(); ++step)
    EXPECT_NEAR(marched.mean(step) / 1500, std::cbrt(1 / (1 + rate * marched.times[step])), 2e-3);
}

/// Error of the slowest mode between two walls, which decays as exp(-k pi^2 t / c), after some even steps
/// [K].
double error_of_mode(const TetrahedralMesh& mesh, int steps, std::vector<double>& temperatures) {
  const double rate = 1.5 * std::numbers::pi * std::numbers::pi / 30;
  const Room room{mesh, Bands{}, uniform_medium(1, 0, 0, 0), 1, walls_of(mesh, 400, 400), 1.5};
  HeatProblem heat =
      in_time(room.heat(), 30.0, Coefficient(Expression(Formula("400+100*sin(pi*z)"), {"x", "y", "z"})));
  for (std::size_t w = 0; w < mesh.wall_names().size(); ++w)
    if (!mesh.wall_names()[w].starts_with("z")) heat.wall_temperatures[w].reset();
  const Marched marched = march(room, heat, even(StepMethod::sdirk2, 2, steps));
  if (marched.temperatures.empty()) return INFINITY;
  temperatures = marched.temperatures.back();
  double squares = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    for (std::size_t i = 0; i < 4; ++i) {
      const double z = corner_of(mesh, CellIndex(c), i).z();
      const double exact = 400 + 100 * std::exp(-2 * rate) * std::sin(std::numbers::pi * z);
      squares += mesh.volume(CellIndex(c)) / 4 *
                 std::pow(temperatures[4 * static_cast<std::size_t>(c) + i] - exact, 2);
    }
  return std::sqrt(squares);
}

TEST(HeatMarch, ConductsAsFourierSays) {
  const TetrahedralMesh mesh = cube_mesh(2e-3);
  std::vector<std::vector<double>> temperatures(3);
  const double coarse_cells = error_of_mode(cube_mesh(1.6e-2), 16, temperatures[0]);
  double fine_cells = 0;
  for (std::size_t i = 0; i < 3; ++i) fine_cells = error_of_mode(mesh, 4 << i, temperatures[i]);
  EXPECT_LT(fine_cells, coarse_cells / 3);
  EXPECT_LT(fine_cells, 1);
  const double coarse = largest_difference(temperatures[0], temperatures[1]);
  const double fine = largest_difference(temperatures[1], temperatures[2]);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.3);
}

TEST(HeatMarch, EndsInTheSteadyTemperatures) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  for (const double conductivity : {0.0, 3.0}) {
    const Room room{mesh,
                    Bands{{"short", "long"}, {1, 4000, 1e9}},
                    uniform_medium(2, 1.5, 0.5, 0),
                    0.8,
                    walls_of(mesh, 500, 1200),
                    conductivity,
                    20000};
    const Marched marched =
        march(room, in_time(room.heat(), 20.0, 300.0), {StepMethod::sdirk2, 60, 30, 3e-2, {}});
    Problem problem = room.problem();
    const HeatProblem heat = room.heat();
    TemperatureIteration temperatures(problem, heat);
    SolveOptions options = tight_options();
    options.tolerance = kTolerance;
    options.following_emission = &temperatures;
    ASSERT_TRUE(TransportSolver(problem, directions_product(2), options).solve().converged());
    ASSERT_FALSE(marched.temperatures.empty());
    EXPECT_LT(largest_difference(marched.temperatures.back(), temperatures.solution().temperature), 1e-2);
  }
}

// A wall that holds heat beside a void: c dT/dt = h (T_a - T), where it does not absorb.
TEST(HeatMarch, WarmsAWallByConvection) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  Room room{mesh, Bands{}, uniform_medium(1, 0, 0, 0), 0, walls_of(mesh, 300, 300), 0, 0, true};
  HeatProblem heat = room.heat();
  heat.changes_in_time = true;
  for (auto& medium : heat.media) medium.reset();
  for (std::size_t w = 0; w < heat.walls.size(); ++w) {
    heat.wall_temperatures[w].reset();
    heat.walls[w] = HeatWall{0, 25, 400, {5000, Coefficient(300.0), {}}, {}};
  }
  std::vector<double> errors;
  for (const int steps : {4, 8}) {
    const Marched marched = march(room, heat, even(StepMethod::sdirk2, 200, steps));
    ASSERT_FALSE(marched.heat.empty());
    const double exact = 400 - 100 * std::exp(-25 * 200.0 / 5000);
    errors.push_back(std::abs(marched.heat.back().wall_temperature.front() - exact));
    for (const double kelvin : marched.heat.back().wall_temperature)
      EXPECT_NEAR(kelvin, marched.heat.back().wall_temperature.front(), 1e-6);
  }
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.3);
}

TEST(HeatMarch, RefusesCapacitiesBelowZero) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  const Room room{mesh, Bands{}, uniform_medium(1, 1, 0, 0), 1, walls_of(mesh, 300, 300), 1};
  const Problem problem = room.problem();
  const HeatProblem heat = in_time(room.heat(), by_temperature("200-T"), 300.0);
  EXPECT_THROW(TemperatureIteration(problem, heat), InputError);
}

}  // namespace
}  // namespace etendue::heat_march_test
