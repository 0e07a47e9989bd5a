// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/kernel/reference_sweep.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/transport/cells/cell_coefficients.h"
#include "solver/transport/order/sweep_order.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::reference_sweep_test {
namespace {

/// All cells, each after its neighbors upwind.
std::vector<CellIndex> downwind_order(const TetrahedralMesh& mesh, const Vec3& direction) {
  const SweepTiles tiles(mesh, static_cast<std::size_t>(mesh.cell_count()));
  const SweepGraph graph(mesh);
  std::vector<SweepVisit> visits(graph.cell_count());
  const SweepOrder order = SweepOrderMaker(graph, tiles, LevelOrder::neighbours).make(direction, visits);
  std::vector<CellIndex> cells;
  for (const SweepVisit& visit : order.visits) cells.emplace_back(visited_cell(visit));
  return cells;
}

/// Radiance [cell][4] of one ordinate in one band of a problem that neither scatters nor reflects.
std::vector<double> swept_plainly(const Problem& problem, const Vec3& direction, int band) {
  const TetrahedralMesh& mesh = problem.mesh();
  std::vector<double> extinction, source, inflow;
  std::vector<char> lumped;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    extinction.push_back(problem.absorption(cell, band));
    lumped.push_back(extinction.back() * cell_size(mesh.volume(cell)) > lumping_thickness);
    source.insert(source.end(), 4, problem.emission(cell, band));
  }
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    inflow.insert(inflow.end(), 3,
                  problem.wall(mesh.wall(FaceIndex(f))).radiance[static_cast<std::size_t>(band)]);
  const std::vector<CellIndex> order = downwind_order(mesh, direction);
  return reference_sweep({mesh, direction, order, extinction, lumped, source, inflow});
}

TEST(ReferenceSweep, KeepsAUniformRadianceInVacuum) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0, 0, 0), uniform_wall(1, 0.7, 0, 0));
  const std::vector<double> radiance = swept_plainly(problem, Vec3(1, 2, -3).normalized(), 0);
  ASSERT_EQ(radiance.size(), 4 * static_cast<std::size_t>(mesh.cell_count()));
  for (const double value : radiance) EXPECT_NEAR(value, 0.7, 1e-13);
}

TEST(ReferenceSweep, AgreesWithTheFastKernel) {
  const TetrahedralMesh mesh = cube_with_ball(5e-3);
  for (const int bands : {1, 2, 3, 8, 11, 16}) {
    // Thick enough in the first bands that some cells are lumped and others are not; no band is like another.
    Medium medium = uniform_medium(bands, 12.8, 0, 0.7, PhaseIsotropic{});
    Wall wall = uniform_wall(bands, 0.9, 0, 0);
    for (std::size_t b = 0; b < static_cast<std::size_t>(bands); ++b) {
      const auto number = static_cast<double>(b + 1);
      medium.absorption[b] = Coefficient(12.8 / number);
      medium.emission[b] = Coefficient(0.7 * number);
      wall.radiance[b] = 0.9 + 0.1 * number;
    }
    const Problem problem = uniform_problem(mesh, medium, wall);
    const DirectionSet directions = directions_product(4);
    SolveOptions options = tight_options(Lumping::automatic);
    options.keep_ordinates = {5, 20};
    const Solution solution = solve(problem, directions, options);
    ASSERT_EQ(solution.radiance.size(), options.keep_ordinates.size());
    for (const OrdinateRadiance& kept : solution.radiance)
      for (int band = 0; band < bands; ++band) {
        const std::vector<double> plain =
            swept_plainly(problem, directions.direction(OrdinateIndex(kept.ordinate)), band);
        ASSERT_EQ(plain.size(), 4 * static_cast<std::size_t>(mesh.cell_count()));
        ASSERT_EQ(kept.values.size(), plain.size() * static_cast<std::size_t>(bands));
        for (std::size_t i = 0; i < plain.size(); ++i)
          EXPECT_NEAR(kept.values[i * static_cast<std::size_t>(bands) + static_cast<std::size_t>(band)],
                      plain[i], 1e-13 * (1 + plain[i]));
      }
  }
}

}  // namespace
}  // namespace etendue::reference_sweep_test
