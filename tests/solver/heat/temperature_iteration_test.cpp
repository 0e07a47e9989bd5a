// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/heat/temperature_iteration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/blackbody.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/solution/balance.h"
#include "solver/transport/solve/solve.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"
#include "tests/solver/heat/heated_room.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::temperature_iteration_test {
namespace {

using heated_room::Room;
using heated_room::walls_of;

const Bands kTwoBands{{"short", "long"}, {1, 4000, 1e9}};

/// An absorption of 0.4 in the first band and five times as much in the next.
Medium medium_of(const Bands& bands, double scattering) {
  Medium medium = uniform_medium(bands.count(), 0.4, scattering, 0);
  if (bands.count() > 1) medium.absorption[1] = Coefficient(2.0);
  return medium;
}

struct Heated {
  Solution solution;
  std::vector<double> temperatures;  ///< [cell][4]
  std::vector<double> conducted;     ///< [wall]
  double radiated_into_walls = 0;
};

Heated solved(const Room& room, const DirectionSet& directions = directions_product(4)) {
  Problem problem = room.problem();
  const HeatProblem heat = room.heat();
  TemperatureIteration temperatures(problem, heat);
  SolveOptions options = tight_options();
  options.tolerance = 1e-9;
  options.following_emission = &temperatures;
  Heated result{solve(problem, directions, options), {}, {}};
  result.temperatures = temperatures.solution().temperature;
  result.conducted = temperatures.solution().conducted;
  problem.set_following(temperatures.sources());
  for (const auto& wall : wall_powers(problem, result.solution))
    for (const WallPower& band : wall) result.radiated_into_walls += band.incoming - band.outgoing;
  return result;
}

/// Largest difference to a temperature that is a function of the place, over all vertices of cells [K].
template <class Temperature>
double largest_difference(const Room& room, const Heated& heated, const Temperature& exact) {
  double largest = 0;
  for (std::int32_t c = 0; c < room.mesh.cell_count(); ++c)
    for (std::size_t i = 0; i < 4; ++i)
      largest = std::max(largest, std::abs(heated.temperatures[4 * static_cast<std::size_t>(c) + i] -
                                           exact(corner_of(room.mesh, CellIndex(c), i))));
  return largest;
}

TEST(TemperatureIteration, KeepsAnIsothermalEnclosure) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  for (const double conductivity : {0.0, 5.0})
    for (const Bands& bands : {Bands{}, kTwoBands}) {
      const Room room{mesh, bands, medium_of(bands, 0.5), 0.7, walls_of(mesh, 800, 800), conductivity};
      const Heated heated = solved(room);
      EXPECT_TRUE(heated.solution.converged());
      EXPECT_LT(largest_difference(room, heated, [](const Vec3&) { return 800.0; }), 1e-5);
      for (const double heat : heated.conducted) EXPECT_NEAR(heat, 0, 1e-4);
    }
}

// Without absorption the temperature is that of conduction alone: linear between two walls, and the flux k
// dT/dz.
TEST(TemperatureIteration, ConductsAsFourierSays) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  Room room{mesh, Bands{}, uniform_medium(1, 0, 0, 0), 1, {}, 3};
  for (const std::string& name : mesh.wall_names())
    room.wall_temperatures.push_back(name == "zmin" ? 400 : name == "zmax" ? 700 : 500);
  HeatProblem heat = room.heat();
  for (std::size_t w = 0; w < mesh.wall_names().size(); ++w)
    if (mesh.wall_names()[w] != "zmin" && mesh.wall_names()[w] != "zmax") heat.wall_temperatures[w].reset();
  const Problem problem = room.problem();
  TemperatureIteration temperatures(problem, heat);
  const std::vector<double> dark(static_cast<std::size_t>(4 * mesh.cell_count()), 0);
  for (int step = 0; step < 8; ++step) temperatures.improve({dark, dark, {}});
  const Heated heated{{}, temperatures.solution().temperature, temperatures.solution().conducted};
  EXPECT_LT(largest_difference(room, heated, [](const Vec3& p) { return 400 + 300 * p.z(); }), 1e-6);
  for (std::size_t w = 0; w < mesh.wall_names().size(); ++w) {
    const std::string& name = mesh.wall_names()[w];
    EXPECT_NEAR(heated.conducted[w], name == "zmin" ? 900 : name == "zmax" ? -900 : 0, 1e-5) << name;
  }
}

// With k = k_0 + b T the integral of k dT is linear between two walls (Kirchhoff 1894).
TEST(TemperatureIteration, ConductsByATemperatureThatChangesTheConductivity) {
  std::vector<double> errors;
  for (const double volume : {3e-2, 3e-3}) {
    const TetrahedralMesh mesh = cube_mesh(volume);
    Room room{mesh, Bands{}, uniform_medium(1, 0, 0, 0), 1, walls_of(mesh, 300, 900)};
    HeatProblem heat = room.heat();
    for (auto& medium : heat.media)
      medium->conductivity = ThermalProperty(Expression(Formula("1+0.002*(T-300)"), {"x", "y", "z", "T"}));
    for (std::size_t w = 0; w < mesh.wall_names().size(); ++w)
      if (!mesh.wall_names()[w].starts_with("z")) heat.wall_temperatures[w].reset();
    const Problem problem = room.problem();
    TemperatureIteration temperatures(problem, heat);
    const std::vector<double> dark(static_cast<std::size_t>(4 * mesh.cell_count()), 0);
    double change = 1;
    int steps = 0;
    for (; steps < 30 && change > 1e-9; ++steps) change = temperatures.improve({dark, dark, {}});
    EXPECT_LT(steps, 30);
    const Heated heated{{}, temperatures.solution().temperature, temperatures.solution().conducted};
    const auto exact = [](const Vec3& p) {
      // u + 0.001 u^2 = z (600 + 0.001 600^2), u = T - 300
      return 300 + 500 * (std::sqrt(1 + 0.004 * p.z() * 960) - 1);
    };
    errors.push_back(largest_difference(room, heated, exact));
    for (std::size_t w = 0; w < mesh.wall_names().size(); ++w) {
      const std::string& name = mesh.wall_names()[w];
      EXPECT_NEAR(heated.conducted[w] / 960, name == "zmin" ? 1 : name == "zmax" ? -1 : 0, 0.02) << name;
    }
    double sum = 0;
    for (const double flow : heated.conducted) sum += flow;
    EXPECT_NEAR(sum, 0, 1e-4);
  }
  EXPECT_LT(errors[1], errors[0] / 3);
  EXPECT_LT(errors[1], 4);
}

// In glass of the refractive index n light carries n^2 times as much, so that conduction is to be n^2 times
// as much too for the same temperatures; and all heat is n^2 times as much.
TEST(TemperatureIteration, SendsMoreIntoDenserMedia) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  Bands glass = kTwoBands;
  glass.refractive_index = 1.5;
  const Room thin{mesh, kTwoBands, medium_of(kTwoBands, 0.5), 0.8, walls_of(mesh, 500, 1200), 3, 20000};
  const Room dense{mesh,     glass,       medium_of(glass, 0.5), 0.8, walls_of(mesh, 500, 1200),
                   3 * 2.25, 20000 * 2.25};
  const Heated one = solved(thin), other = solved(dense);
  ASSERT_EQ(one.temperatures.size(), other.temperatures.size());
  for (std::size_t i = 0; i < one.temperatures.size(); ++i)
    EXPECT_NEAR(other.temperatures[i], one.temperatures[i], 1e-5);
  EXPECT_NEAR(other.radiated_into_walls / (2.25 * one.radiated_into_walls), 1, 1e-8);
}

TEST(TemperatureIteration, GivesAllHeatToTheWalls) {
  const TetrahedralMesh mesh = cube_mesh(4e-3);
  for (const double conductivity : {0.0, 2.0, 200.0}) {
    const Room room{mesh,         kTwoBands, medium_of(kTwoBands, 1), 0.8, walls_of(mesh, 500, 1200),
                    conductivity, 20000};
    const Heated heated = solved(room);
    ASSERT_TRUE(heated.solution.converged());
    double into_walls = heated.radiated_into_walls;
    for (const double heat : heated.conducted) into_walls += heat;
    EXPECT_NEAR(into_walls / 20000, 1, 1e-6) << conductivity;
  }
}

TEST(TemperatureIteration, ConductsNothingWhereNearlyNothingConducts) {
  const TetrahedralMesh mesh = cube_mesh(4e-3);
  const Room room{mesh, Bands{}, uniform_medium(1, 1, 0, 0), 1, walls_of(mesh, 500, 1200), 1e-9, 20000};
  const Heated heated = solved(room);
  ASSERT_TRUE(heated.solution.converged());
  for (const double heat : heated.conducted) EXPECT_NEAR(heat, 0, 1e-3);
}

// A gray medium that does not conduct scatters what it absorbs: solved so, and by temperatures in two bands
// that are alike, it is the same.
TEST(TemperatureIteration, AgreesWithScatteringInGrayMedia) {
  const TetrahedralMesh mesh = cube_mesh(4e-3);
  const Room room{mesh, kTwoBands, uniform_medium(2, 2, 0.5, 0), 0.9, walls_of(mesh, 300, 1500), 0, 30000};
  const Heated heated = solved(room);
  ASSERT_TRUE(heated.solution.converged());
  Room gray{mesh, Bands{}, uniform_medium(1, 0, 2.5, 0), 0.9, room.wall_temperatures};
  gray.medium.emission = {Coefficient(30000 / (4 * std::numbers::pi))};
  SolveOptions options = tight_options();
  options.tolerance = 1e-9;
  const Solution scattered = solve(gray.problem(), directions_product(4), options);
  double largest = 0;
  for (std::size_t i = 0; i < scattered.fluence.size(); ++i) {
    const double power = scattered.fluence[i] / 4 + 30000.0 / (4 * 2);
    largest = std::max(largest, std::abs(heated.temperatures[i] - std::pow(power / stefan_boltzmann, 0.25)));
  }
  EXPECT_LT(largest, 1e-3);
}

TEST(TemperatureIteration, TakesFewSweepsWhereNothingScatters) {
  const TetrahedralMesh mesh = cube_mesh(4e-3);
  for (const double absorption : {0.1, 1.0, 10.0, 100.0})
    for (const double conductivity : {0.0, 1.0, 100.0}) {
      const Room room{mesh,        Bands{}, uniform_medium(1, absorption, 0, 0), 1, walls_of(mesh, 300, 1500),
                      conductivity};
      Problem problem = room.problem();
      const HeatProblem heat = room.heat();
      TemperatureIteration temperatures(problem, heat);
      SolveOptions options;
      options.tolerance = 1e-6;
      options.following_emission = &temperatures;
      const Solution solution = solve(problem, directions_product(4), options);
      EXPECT_TRUE(solution.converged());
      EXPECT_LE(solution.convergence.front().sweeps, 25) << absorption << " " << conductivity;
    }
}

// Errors of light that is scattered back become larger ones of the temperature.
TEST(TemperatureIteration, TakesFewSweepsWhereMuchLightReturns) {
  const TetrahedralMesh mesh = cube_mesh(4e-3);
  Medium medium = medium_of(kTwoBands, 0.05);
  for (Coefficient& scattering : medium.scattering) scattering = Coefficient(4.0);
  const Room room{mesh, kTwoBands, medium, 0.5, walls_of(mesh, 300, 1500)};
  const auto solved_to = [&](double tolerance) {
    Problem problem = room.problem();
    const HeatProblem heat = room.heat();
    TemperatureIteration temperatures(problem, heat);
    SolveOptions options;
    options.tolerance = tolerance;
    options.following_emission = &temperatures;
    const Solution solution = solve(problem, directions_product(4), options);
    EXPECT_TRUE(solution.converged());
    return std::pair(solution.convergence.front().sweeps, temperatures.solution().temperature);
  };
  const auto [sweeps, kelvin] = solved_to(1e-6);
  EXPECT_LE(sweeps, 70);
  const auto [more, exact] = solved_to(1e-9);
  ASSERT_EQ(kelvin.size(), exact.size());
  for (std::size_t i = 0; i < kelvin.size(); ++i) EXPECT_NEAR(kelvin[i], exact[i], 1e-5 * 1500);
}

// Each temperature takes light of its own, so that diffusion pays where a single solution would do without.
TEST(TemperatureIteration, IsAcceleratedWhereMediaScatter) {
  const TetrahedralMesh mesh = cube_mesh(4e-3);
  const auto medium_of_scattering = [](double scattering) {
    Medium medium = medium_of(kTwoBands, 2);
    for (Coefficient& value : medium.scattering) value = Coefficient(scattering);
    return medium;
  };
  const auto solved_by = [&](double scattering, Acceleration acceleration) {
    const Room room{mesh, kTwoBands, medium_of_scattering(scattering), 0.7, walls_of(mesh, 300, 1500)};
    Problem problem = room.problem();
    const HeatProblem heat = room.heat();
    TemperatureIteration temperatures(problem, heat);
    SolveOptions options;
    options.tolerance = 1e-6;
    options.acceleration = acceleration;
    options.following_emission = &temperatures;
    return solve(problem, directions_product(4), options);
  };
  const auto without = [](const Solution& solution) {
    return std::ranges::any_of(solution.notes,
                               [](const std::string& note) { return note.starts_with("not accelerated"); });
  };
  EXPECT_TRUE(without(solved_by(0, Acceleration::automatic)));
  const Room alone{mesh, kTwoBands, medium_of_scattering(0.5), 0.7, walls_of(mesh, 300, 1500)};
  EXPECT_TRUE(without(solve(alone.problem(), directions_product(4), SolveOptions())));
  const Solution fast = solved_by(0.5, Acceleration::automatic);
  const Solution plain = solved_by(0.5, Acceleration::none);
  EXPECT_FALSE(without(fast));
  EXPECT_TRUE(fast.converged());
  EXPECT_TRUE(plain.converged());
  EXPECT_LT(fast.convergence.front().sweeps, plain.convergence.front().sweeps);
}

TEST(TemperatureIteration, RefusesWhatHasNoTemperature) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  const Room room{mesh, Bands{}, uniform_medium(1, 0, 0, 0), 1, walls_of(mesh, 300, 300)};
  const Problem problem = room.problem();
  const HeatProblem heat = room.heat();
  EXPECT_THROW(TemperatureIteration(problem, heat), InputError);
}

TEST(TemperatureIteration, RefusesSourcesThatAreNoNumberOrBelowZero) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  const Room room{mesh, Bands{}, uniform_medium(1, 1, 0, 0), 1, walls_of(mesh, 300, 300), 1};
  const Problem problem = room.problem();
  for (const char* formula : {"sqrt(x-0.5)", "-x"}) {
    HeatProblem heat = room.heat();
    heat.media.front()->source = Coefficient(Expression(Formula(formula), {"x", "y", "z"}));
    try {
      TemperatureIteration(problem, heat);
      ADD_FAILURE() << formula;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("heat_source"), std::string::npos) << error.what();
    }
  }
}

TEST(TemperatureIteration, RefusesAConductorThatNothingCools) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  const Room room{mesh, Bands{}, uniform_medium(1, 0, 0, 0), 1, walls_of(mesh, 300, 300), 1};
  const Problem problem = room.problem();
  HeatProblem heat = room.heat();
  EXPECT_NO_THROW(TemperatureIteration(problem, heat));
  for (auto& wall : heat.wall_temperatures) wall.reset();
  EXPECT_THROW(TemperatureIteration(problem, heat), InputError);
}

TEST(TemperatureIteration, IsNotConvergedWithTooFewSweeps) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  const Room room{mesh, Bands{}, uniform_medium(1, 2, 3, 0), 0.5, walls_of(mesh, 300, 1500), 1};
  Problem problem = room.problem();
  const HeatProblem heat = room.heat();
  TemperatureIteration temperatures(problem, heat);
  SolveOptions options;
  options.max_sweeps = 6;
  options.following_emission = &temperatures;
  const Solution solution = solve(problem, directions_product(4), options);
  EXPECT_FALSE(solution.converged());
  EXPECT_LE(solution.convergence.front().sweeps, 6);
}

}  // namespace
}  // namespace etendue::temperature_iteration_test
