// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/solution/flux_divergence.h"

#include <gtest/gtest.h>

#include <numbers>

#include "solver/solution/balance.h"
#include "tests/solver/problem/cube_mesh.h"
#include "tests/solver/solution/synthetic_solution.h"

namespace etendue::flux_divergence_test {
namespace {

TEST(FluxDivergence, IsEmittedLessAbsorbedPowerOfEachRegion) {
  const TetrahedralMesh mesh = cube_mesh();
  const std::vector<PhaseFunction> phase(2, PhaseIsotropic{});
  const Problem problem(
      mesh, Bands{{"a", "b"}, {}},
      {{"left", {2.0, 3.0}, {0.0, 1.0}, {0.7, 0.1}, phase, {}},
       {"right", {0.0, 0.5}, {0.0, 0.0}, {0.0, 0.2}, phase, {}}},
      {{"floor", {0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}, {}}, {"rest", {0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}, {}}});
  const Solution solution = solution_from(
      problem, [](const Vec3& x, int band) { return (1 + band) * (1 + x.z() * x.x()); },
      [](const Vec3&, int) { return Vec3(Vec3::Zero()); });
  const std::vector<double> divergence = flux_divergence(problem, solution);
  ASSERT_EQ(divergence.size(), static_cast<std::size_t>(mesh.cell_count()));
  std::vector<double> totals(2, 0.0);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    totals[static_cast<std::size_t>(mesh.region(CellIndex(c)))] +=
        divergence[static_cast<std::size_t>(c)] * mesh.volume(CellIndex(c));
  const auto regions = region_powers(problem, solution);
  ASSERT_EQ(regions.size(), 2u);
  for (std::size_t r = 0; r < 2; ++r) {
    ASSERT_EQ(regions[r].size(), 2u);
    EXPECT_NEAR(
        totals[r],
        regions[r][0].emitted + regions[r][1].emitted - regions[r][0].absorbed - regions[r][1].absorbed,
        1e-13);
  }
  EXPECT_GT(totals[0], 0);
}

}  // namespace
}  // namespace etendue::flux_divergence_test
