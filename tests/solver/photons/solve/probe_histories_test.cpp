// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/solve/probe_histories.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>

#include "tests/solver/transport/sample_problems.h"

namespace etendue::probe_histories_test {
namespace {

using std::numbers::pi;

/// A cube of one medium, black and cold around it, seen from its middle and from the middle of a side.
std::vector<std::vector<ProbeEstimate>> looked_at(const Medium& medium, double histories) {
  const TetrahedralMesh mesh = cube_mesh(0.01);
  const Problem problem = uniform_problem(mesh, medium, uniform_wall(1, 0, 0, 0));
  const CellLocator locator(mesh);
  return walk_back_from({{Vec3(0.5, 0.5, 0.5), {}}, {Vec3(0.5, 0.5, 0), Vec3(0, 0, 1)}}, problem, locator,
                        {histories, 1, 2});
}

bool agrees(const Estimate& found, double exact) { return std::abs(found.value - exact) <= 3 * found.error; }

// validation/reference/cube_hot_medium_wall_flux.csv: kappa = 1, the middle of a side, for sigma T^4 = 1.
TEST(ProbeHistories, FindTheFluxOnTheWallOfAHotCube) {
  const auto found = looked_at(uniform_medium(1, 1, 0, 1 / pi), 16000);
  ASSERT_TRUE(found[1][0].irradiance);
  EXPECT_TRUE(agrees(*found[1][0].irradiance, 0.553727789)) << found[1][0].irradiance->value;
  EXPECT_LT(found[1][0].irradiance->error, 0.002);
  EXPECT_FALSE(found[0][0].irradiance);
  EXPECT_TRUE(agrees(found[0][0].net_flux[0], 0));
}

// A hot cube that scatters, extinction 1, albedo 0.9, g = 0.8; the emission is (1 - albedo)/pi. Point values
// by an independent program, 1e7 histories: irradiance in the middle of a side, fluence/4 in the middle.
TEST(ProbeHistories, FindTheLightOfAHotCubeThatScatters) {
  const auto found = looked_at(uniform_medium(1, 0.1, 0.9, 0.1 / pi, PhaseHenyeyGreenstein{0.8}), 20000);
  EXPECT_TRUE(agrees(*found[1][0].irradiance, 0.079700)) << found[1][0].irradiance->value;
  EXPECT_LT(found[1][0].irradiance->error, 0.001);
  EXPECT_TRUE(agrees(found[0][0].fluence, 4 * 0.060939)) << found[0][0].fluence.value;
  EXPECT_LT(found[0][0].fluence.error, 0.002);
}

// In matter of a million free paths that loses next to nothing a history takes minutes.
TEST(ProbeHistories, LeaveOutProbesThatAreNotWholeWhereTheyAreStopped) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 1e-9, 1e6, 1), uniform_wall(1, 0, 1, 0));
  const auto begun = std::chrono::steady_clock::now();
  const auto since = [&] { return std::chrono::steady_clock::now() - begun; };
  const auto found =
      walk_back_from({{Vec3(0.5, 0.5, 0.5), {}}, {Vec3(0.4, 0.5, 0.5), {}}}, problem, CellLocator(mesh),
                     {1e5, 1, 2}, [&](double) { return since() < std::chrono::milliseconds(300); });
  EXPECT_LT(since(), std::chrono::seconds(2));
  ASSERT_EQ(found.size(), 2U);
  for (const auto& of_bands : found) EXPECT_TRUE(of_bands.empty());
}

}  // namespace
}  // namespace etendue::probe_histories_test
