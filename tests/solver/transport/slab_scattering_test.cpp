// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Slabs of optical thickness 1 under a diffuse sky, through moments and matrices, against
// validation/reference/slab_diffuse.csv (which names its source).
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>

#include "solver/solution/balance.h"
#include "solver/transport/solve/solve.h"
#include "tests/solver/transport/sample_problems.h"
#include "tests/support/checkout.h"

namespace etendue::slab_scattering_test {
namespace {

struct Slab {
  double asymmetry, albedo;
  double reflected = -1, transmitted = -1;  ///< parts of the incident flux
};

/// Slabs of thickness 1, from the lines g, w, tau, R, T …
Slab known_slab(double asymmetry, double albedo) {
  std::ifstream file(test::checkout("validation/reference/slab_diffuse.csv"));
  Slab slab{asymmetry, albedo};
  for (std::string line; std::getline(file, line);) {
    std::istringstream cells(line);
    std::vector<double> numbers;
    for (std::string cell; std::getline(cells, cell, ',') && !cell.empty() && std::isdigit(cell[0]) != 0;)
      numbers.push_back(std::stod(cell));
    if (numbers.size() > 4 && numbers[0] == asymmetry && numbers[1] == albedo && numbers[2] == 1) {
      slab.reflected = numbers[3];
      slab.transmitted = numbers[4];
    }
  }
  return slab;
}

Medium medium_of(const std::vector<Slab>& slabs, ScatteringBackend backend) {
  Medium medium = uniform_medium(static_cast<int>(slabs.size()), 0, 0, 0);
  for (std::size_t band = 0; band < slabs.size(); ++band) {
    medium.scattering[band] = slabs[band].albedo;
    medium.absorption[band] = 1 - slabs[band].albedo;
    medium.phase[band] = PhaseHenyeyGreenstein{slabs[band].asymmetry};
    medium.choice.push_back({backend, -1, ForwardPeak::keep});
  }
  return medium;
}

/// The largest error of R and T over the slabs, as a part of the incident flux.
double largest_error(const std::vector<Slab>& slabs, ScatteringBackend backend, const DirectionSet& set) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const auto count = static_cast<int>(slabs.size());
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    const bool end = name == "zmin" || name == "zmax";
    walls.push_back(uniform_wall(count, name == "zmin" ? 1 / std::numbers::pi : 0, 0, end ? 0 : 1));
    walls.back().name = name;
  }
  Bands bands;
  bands.names.clear();
  for (int band = 0; band < count; ++band) bands.names.push_back(std::to_string(band));
  const Problem problem(mesh, bands, {medium_of(slabs, backend)}, walls);
  SolveOptions options;
  options.tolerance = 1e-5;
  const Solution solution = solve(problem, set, options);
  EXPECT_TRUE(solution.converged());
  const auto powers = wall_powers(problem, solution);
  double largest = 0;
  for (std::size_t band = 0; band < slabs.size(); ++band) {
    double sent = 0, back = 0, through = 0;
    for (std::size_t wall = 0; wall < walls.size(); ++wall) {
      if (walls[wall].name == "zmin") sent = powers[wall][band].outgoing, back = powers[wall][band].incoming;
      if (walls[wall].name == "zmax") through = powers[wall][band].incoming;
    }
    EXPECT_GE(slabs[band].reflected, 0) << "no such line";
    largest = std::max({largest, std::abs(back / sent - slabs[band].reflected),
                        std::abs(through / sent - slabs[band].transmitted)});
  }
  return largest;
}

std::vector<Slab> bright_slabs() {
  return {known_slab(0.5, 0.99), known_slab(0.8, 0.99), known_slab(0.9, 0.999)};
}

constexpr double half_a_percent = 5e-3;

TEST(SlabUnderADiffuseSky, IsMetThroughMomentsWithLdfeSq) {
  EXPECT_LT(largest_error(bright_slabs(), ScatteringBackend::moments, directions_ldfe_sq(2)), half_a_percent);
}

TEST(SlabUnderADiffuseSky, IsMetThroughAMatrixWithLdfeSq) {
  EXPECT_LT(largest_error(bright_slabs(), ScatteringBackend::dense, directions_ldfe_sq(2)), half_a_percent);
}

TEST(SlabUnderADiffuseSky, IsMetThroughMomentsWithAProduct) {
  EXPECT_LT(largest_error(bright_slabs(), ScatteringBackend::moments, directions_product(16)),
            half_a_percent);
}

TEST(SlabUnderADiffuseSky, IsMetThroughAMatrixWithAProduct) {
  EXPECT_LT(largest_error({known_slab(0.9, 0.999)}, ScatteringBackend::dense, directions_product(16)),
            half_a_percent);
}

}  // namespace
}  // namespace etendue::slab_scattering_test
