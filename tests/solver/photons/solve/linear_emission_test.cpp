// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Photons of emission that is linear in the cells, on a mesh whose cells are two free paths wide.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/photons/solve/probe_histories.h"
#include "solver/solution/balance.h"
#include "tests/solver/photons/solve/photon_samples.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::linear_emission_test {
namespace {

using std::numbers::pi;

constexpr double kappa = 4;

/// A slab of absorption kappa and blackbody radiance z, black walls of 0 below and 1 above, mirrors around.
Problem slab(const TetrahedralMesh& mesh) {
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 1));
  walls[wall_of(mesh, "zmin")] = uniform_wall(1, 0, 0, 0);
  walls[wall_of(mesh, "zmax")] = uniform_wall(1, 1, 0, 0);
  Medium medium = uniform_medium(1, kappa, 0, 0);
  medium.blackbody = {Coefficient(Expression("z", {"x", "y", "z"}))};
  return Problem(mesh, {}, {medium}, walls);
}

/// Exponential integral E_4, by E_(n+1)(x) = (e^-x - x E_n(x))/n (Abramowitz and Stegun 5.1.14).
double e4(double x) {
  double value = -std::expint(-x);
  for (int n = 1; n < 4; ++n) value = (std::exp(-x) - x * value) / n;
  return value;
}

// The irradiance below is 2 pi times the integral of mu (mu/kappa) (1 - e^(-kappa/mu)) over mu.
double irradiance_below() { return 2 * pi / kappa * (1. / 3 - e4(kappa)); }

TEST(LinearEmission, BringsTheIrradianceOfASlabForwards) {
  const TetrahedralMesh mesh = cube_mesh(0.2);
  const Problem problem = slab(mesh);
  ASSERT_LT(mesh.cell_count(), 60);
  const std::size_t below = wall_of(mesh, "zmin");
  const PhotonSolution found = solved(problem, 400000, [&](const Solution& batch) {
    return std::vector<double>{wall_powers(problem, batch)[below][0].incoming};
  });
  EXPECT_LT(found.sums.derived.error(0), 0.01 * irradiance_below());
  EXPECT_NEAR(found.sums.derived.mean(0), irradiance_below(), 3 * found.sums.derived.error(0));
}

TEST(LinearEmission, BringsTheIrradianceOfASlabBackwards) {
  const TetrahedralMesh mesh = cube_mesh(0.2);
  const Problem problem = slab(mesh);
  const CellLocator locator(mesh);
  const auto seen = walk_back_from({{Vec3(0.45, 0.35, 0), Vec3(0, 0, 1)}}, problem, locator, {40000, 1, 2});
  ASSERT_TRUE(seen[0][0].irradiance);
  EXPECT_LT(seen[0][0].irradiance->error, 0.005 * irradiance_below());
  EXPECT_NEAR(seen[0][0].irradiance->value, irradiance_below(), 3 * seen[0][0].irradiance->error);
}

}  // namespace
}  // namespace etendue::linear_emission_test
