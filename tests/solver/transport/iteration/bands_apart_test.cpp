// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Bands that are done earlier than others leave the sweeps; every band's answer is the one it has alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "solver/solution/solve_observer.h"
#include "solver/transport/acceleration/diffusion_acceleration.h"
#include "solver/transport/iteration/source_iteration.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::bands_apart_test {
namespace {

constexpr std::size_t bands = 3;

/// The bands scatter 0.1, 2 and 12 times on a unit length.
Medium medium_of_bands() {
  Medium medium = uniform_medium(bands, 0.2, 0, 0.2);
  medium.scattering = {Coefficient(0.1), Coefficient(2.0), Coefficient(12.0)};
  return medium;
}

Solution solved(const Problem& problem, const DirectionSet& directions, Method method) {
  SolveOptions options = tight_options();
  options.method = method;
  options.acceleration = Acceleration::none;  // which brings all bands to their answers at once
  options.tolerance = 1e-11;
  return solve(problem, directions, options);
}

/// The fluence of one band.
std::vector<double> fluence_of(const Solution& solution, std::size_t count, std::size_t band) {
  std::vector<double> values;
  for (std::size_t i = band; i < solution.fluence.size(); i += count) values.push_back(solution.fluence[i]);
  return values;
}

void expect_each_band_as_alone(const Problem& problem, const DirectionSet& directions) {
  for (const Method method : {Method::gmres, Method::source_iteration}) {
    const Solution together = solved(problem, directions, method);
    ASSERT_TRUE(together.converged());
    EXPECT_LT(together.convergence[0].sweeps, together.convergence[2].sweeps) << "none is done earlier";
    for (std::size_t band = 0; band < bands; ++band) {
      const int wanted[] = {static_cast<int>(band)};
      Solution alone = solved(problem.of_bands(wanted), directions, method);
      Solution of_band;
      of_band.fluence = fluence_of(together, bands, band);
      alone.fluence = fluence_of(alone, 1, 0);
      EXPECT_LT(difference(of_band, alone, 1, 0), 1e-10) << together.method << ", band " << band;
    }
  }
}

TEST(BandsApart, HaveTheAnswersOfEachBandAlone) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  Medium medium = medium_of_bands();
  medium.phase.assign(bands, PhaseHenyeyGreenstein{0.5});
  expect_each_band_as_alone(uniform_problem(mesh, medium, uniform_wall(bands, 0.3, 0.4, 0.2)),
                            directions_triangular(2));
}

TEST(BandsApart, HaveThemAmongLeaves) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  Medium medium = medium_of_bands();
  for (const double reflectance : {0.1, 0.3, 0.5})
    medium.directional.emplace_back(LeafCanopy{LeafAngles::planophile, reflectance, 0.3});
  expect_each_band_as_alone(uniform_problem(mesh, medium, uniform_wall(bands, 0.3, 0.2, 0)),
                            directions_product(4));
}

TEST(BandsApart, HaveThemInThePlane) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(name[0] == 'z' ? uniform_wall(bands, 0, 0, 1) : uniform_wall(bands, 0.5, 0.3, 0));
    walls.back().name = name;
  }
  Medium medium = medium_of_bands();
  medium.name = mesh.region_names().front();
  Bands names{{"a", "b", "c"}, {}};
  expect_each_band_as_alone(Problem(mesh, names, {medium}, walls, AngularSpace::plane),
                            directions_flatland(12));
}

TEST(BandsApart, HaveThemWhereMatterShinesByDirection) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  Medium medium = medium_of_bands();
  medium.emission_by_direction.assign(bands, AngularFormula("1 + 0.5*wx + x*wz^2"));
  expect_each_band_as_alone(uniform_problem(mesh, medium, uniform_wall(bands, 0, 0.3, 0)),
                            directions_triangular(2));
}

struct Iterated {
  IterationResult result;
  std::int64_t band_sweeps = 0;
};

Iterated iterate(const Problem& problem, const DirectionSet& directions, bool accelerated) {
  const std::size_t values = problem.absorption().size();
  std::vector<double> extinction(values);
  for (std::size_t i = 0; i < values; ++i) extinction[i] = problem.absorption()[i] + problem.scattering()[i];
  TransportSweep sweep(problem, directions, extinction, tight_options());
  TransportState state(sweep.layout());
  std::unique_ptr<DiffusionAcceleration> acceleration;
  if (accelerated) acceleration = std::make_unique<DiffusionAcceleration>(problem, sweep, extinction);
  const std::int64_t before = sweep.band_sweep_count();
  IterationResult result =
      SourceIteration().run(sweep, state, {1e-9, 500, acceleration.get()}, SolveObserver());
  return {std::move(result), sweep.band_sweep_count() - before};
}

TEST(BandsApart, CostSourceIterationTheLanesThatAreLeft) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  Medium medium = medium_of_bands();
  // Of three bands in four lanes, then two, then one.
  const Problem problem = uniform_problem(mesh, medium, uniform_wall(bands, 0, 0.3, 0));
  for (const bool accelerated : {false, true}) {
    const Iterated run = iterate(problem, directions_triangular(2), accelerated);
    std::int64_t sweeps = 0;
    for (const BandConvergence& band : run.result.bands) {
      EXPECT_TRUE(band.converged);
      sweeps += band.sweeps;
    }
    EXPECT_LT(sweeps, 3 * run.result.sweeps);
    EXPECT_EQ(run.band_sweeps, sweeps);
  }
}

TEST(SourceIteration, ThatDivergesWithDiffusionGoesOnWithout) {
  const TetrahedralMesh mesh = random_cells(cube_mesh(1e-2));
  std::vector<Medium> media;
  for (const std::string& name : mesh.region_names()) {
    media.push_back(name == "ball" ? uniform_medium(1, 4, 996, 1) : uniform_medium(1, 4e-4, 0.0996, 1));
    media.back().name = name;
  }
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  for (std::size_t i = 0; i < walls.size(); ++i) walls[i].name = mesh.wall_names()[i];
  const Problem problem(mesh, Bands{}, media, walls);
  SolveOptions options = tight_options();
  options.acceleration = Acceleration::diffusion;
  options.tolerance = 1e-7;
  options.max_sweeps = 3000;
  const Solution exact = solve(problem, directions_triangular(4), options);
  options.method = Method::source_iteration;
  const Solution solution = solve(problem, directions_triangular(4), options);
  EXPECT_TRUE(solution.converged());
  EXPECT_LT(difference(solution, exact, 1, 0), 1e-6);
  EXPECT_EQ(
      std::count_if(solution.notes.begin(), solution.notes.end(),
                    [](const std::string& note) { return note.find("diverges in band") < note.size(); }),
      1);
}

}  // namespace
}  // namespace etendue::bands_apart_test
