// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "solver/transport/sweep/transport_sweep.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::active_band_sweep_test {
namespace {

constexpr int bands = 5;

/// A different medium and wall in each band; diffuse reflection, and mirrors, in all.
Problem varied_problem(const TetrahedralMesh& mesh, const std::vector<PhaseFunction>& phase,
                       std::optional<ScatteringBackend> backend = std::nullopt, double specular = 0.2) {
  Medium medium = uniform_medium(bands, 0.1, 1, 0.3);
  medium.phase = phase;
  if (backend) medium.choice.assign(bands, {*backend, 2});
  Wall wall = uniform_wall(bands, 0.2, 0.3, specular);
  for (std::size_t b = 0; b < bands; ++b) {
    medium.scattering[b] = Coefficient(0.5 * static_cast<double>(b + 1));
    wall.diffuse[b] = 0.1 * static_cast<double>(b);
  }
  return uniform_problem(mesh, medium, wall);
}

struct Swept {
  Swept(const Problem& problem, const DirectionSet& directions)
      : extinction(extinction_of(problem)), sweep(problem, directions, extinction, tight_options()) {}

  std::vector<double> extinction;
  TransportSweep sweep;
};

/// Values in some bands, zero in the others.
TransportState state_of(const TransportSweep& sweep, const std::vector<char>& active) {
  TransportState state(sweep.layout());
  const auto stride = static_cast<std::size_t>(sweep.cells().stride());
  for (std::size_t i = 0; i < state.values().size(); ++i)
    if (i % stride < bands && active[i % stride])
      state.values()[i] = 1 + std::sin(static_cast<double>(i * i % 1013));
  return state;
}

/// Largest difference between sweeps of some bands alone and of all together, relative to the largest value.
double difference_of(TransportSweep& sweep, const std::vector<char>& active) {
  const TransportState last = state_of(sweep, active);
  TransportState together(sweep.layout()), alone(sweep.layout());
  sweep.apply_linear(last, together);
  sweep.apply_linear(last, alone, active);
  double difference = 0, largest = 0;
  for (std::size_t i = 0; i < together.values().size(); ++i) {
    difference = std::max(difference, std::abs(together.values()[i] - alone.values()[i]));
    largest = std::max(largest, std::abs(together.values()[i]));
  }
  EXPECT_GT(largest, 0.1);
  return difference / largest;
}

void expect_fewer_lanes_and_the_same_values(const Problem& problem) {
  const DirectionSet directions = directions_product(4);
  Swept swept(problem, directions);
  const std::vector<std::pair<std::vector<char>, int>> sequence = {
      {{1, 1, 1, 1, 1}, 8}, {{1, 0, 1, 1, 1}, 4}, {{1, 0, 0, 1, 1}, 4}, {{0, 0, 0, 1, 1}, 2},
      {{0, 0, 0, 1, 0}, 1}, {{0, 1, 0, 1, 1}, 4}, {{1, 1, 1, 1, 1}, 8}};
  for (const auto& [active, lanes] : sequence) {
    EXPECT_LT(difference_of(swept.sweep, active), 1e-13);
    EXPECT_EQ(swept.sweep.lanes(), lanes);
  }
}

TEST(ActiveBandSweep, GivesTheSameInFewerLanes) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  expect_fewer_lanes_and_the_same_values(
      varied_problem(mesh, std::vector<PhaseFunction>(bands, PhaseIsotropic{})));
}

TEST(ActiveBandSweep, GivesTheSameWithMomentsAndMatrices) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  std::vector<PhaseFunction> phase;
  for (int b = 0; b < bands; ++b) phase.emplace_back(PhaseHenyeyGreenstein{0.5 + 0.05 * b});
  for (const ScatteringBackend backend : {ScatteringBackend::moments, ScatteringBackend::dense})
    expect_fewer_lanes_and_the_same_values(varied_problem(mesh, phase, backend));
}

TEST(ActiveBandSweep, GivesTheSameAcrossLaggedFaces) {
  // Turned so that an ordinate of the set lies along the ring's axis.
  const DirectionSet directions = directions_product(4);
  const TetrahedralMesh mesh = cyclic_ring_about(directions.direction(OrdinateIndex(0)));
  const Problem problem = varied_problem(mesh, std::vector<PhaseFunction>(bands, PhaseIsotropic{}), {}, 0);
  ASSERT_GT(Swept(problem, directions).sweep.discretization().orders->lagged_total(), 0u);
  expect_fewer_lanes_and_the_same_values(problem);
}

TEST(ActiveBandSweep, StaysWideWhereBandsHandOnLess) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  std::vector<PhaseFunction> phase(bands, PhaseIsotropic{});
  phase[0] = PhaseHenyeyGreenstein{0.5};
  const Problem problem = varied_problem(mesh, phase);
  const DirectionSet directions = directions_product(4);
  Swept swept(problem, directions);
  EXPECT_LT(difference_of(swept.sweep, {0, 1, 0, 0, 0}), 1e-13);
  EXPECT_EQ(swept.sweep.lanes(), 8);
}

TEST(ActiveBandSweep, CountsOnlyTheBandsThatItSweeps) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  const Problem problem = varied_problem(mesh, std::vector<PhaseFunction>(bands, PhaseIsotropic{}));
  const DirectionSet directions = directions_product(4);
  Swept swept(problem, directions);
  const std::vector<char> active = {0, 1, 0, 1, 0};
  const TransportState last = state_of(swept.sweep, active);
  TransportState next(swept.sweep.layout());
  swept.sweep.apply_linear(last, next, active);
  EXPECT_EQ(swept.sweep.band_sweep_count(), 2);
  EXPECT_GT(swept.sweep.processor_seconds(), 0);
}

}  // namespace
}  // namespace etendue::active_band_sweep_test
