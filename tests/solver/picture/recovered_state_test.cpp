// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/picture/recovered_state.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/solver/ordinates/sample_problems.h"

namespace etendue {
namespace {

/// The means over the cells of a smooth function, as a field that jumps, in the fluence and in two moments.
SavedState means_of(const TetrahedralMesh& mesh, double (*function)(const Vec3&)) {
  SavedState state;
  state.bands = 1;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const double mean = function(mesh.centroid(CellIndex(c)));
    state.fluence.insert(state.fluence.end(), 4, mean);
    state.moments.insert(state.moments.end(), 4, mean);
    state.moments.insert(state.moments.end(), 4, -2 * mean);
  }
  return state;
}

double smooth(const Vec3& p) { return std::sin(2 * p.x()) + p.y() * p.z(); }

std::vector<std::int32_t> every_cell(const TetrahedralMesh& mesh) {
  std::vector<std::int32_t> rows;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) rows.push_back(c + 1);
  return rows;
}

TEST(RecoveredState, IsContinuousAndNearerToASmoothField) {
  const TetrahedralMesh mesh = cube_mesh(2e-3);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 1, 1, 1), uniform_wall(1, 0, 0, 0));
  const SavedState raw = means_of(mesh, smooth);
  const SavedState joined = recovered_state(problem, raw, every_cell(mesh));
  std::vector<double> at_vertex(static_cast<std::size_t>(mesh.vertex_count()), NAN);
  double before = 0, after = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    for (std::size_t i = 0; i < 4; ++i) {
      const auto vertex = static_cast<std::size_t>(mesh.vertices(CellIndex(c))[i]);
      const std::size_t node = 4 * static_cast<std::size_t>(c) + i;
      const double value = joined.fluence[node];
      if (std::isnan(at_vertex[vertex])) at_vertex[vertex] = value;
      EXPECT_EQ(value, at_vertex[vertex]);
      EXPECT_NEAR(joined.moments[8 * static_cast<std::size_t>(c) + i], value, 1e-14);
      EXPECT_NEAR(joined.moments[8 * static_cast<std::size_t>(c) + 4 + i], -2 * value, 1e-14);
      before += std::pow(raw.fluence[node] - smooth(mesh.points()[vertex]), 2);
      after += std::pow(value - smooth(mesh.points()[vertex]), 2);
    }
  // At the boundary the cells stand on one side of a vertex, so there it is not much nearer.
  EXPECT_LT(after, before / 2);
}

// What jumps between two regions goes on doing so; a constant stays.
TEST(RecoveredState, LeavesRegionsApart) {
  const TetrahedralMesh mesh = two_region_mesh(0.02);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 1, 1, 1), uniform_wall(1, 0, 0, 0));
  SavedState raw;
  raw.bands = 1;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    raw.fluence.insert(raw.fluence.end(), 4, mesh.region(CellIndex(c)) == 0 ? 1.0 : 5.0);
  const std::vector<std::int32_t> none(static_cast<std::size_t>(mesh.cell_count()), 0);
  const SavedState joined = recovered_state(problem, raw, none);
  for (std::size_t i = 0; i < raw.fluence.size(); ++i) EXPECT_NEAR(joined.fluence[i], raw.fluence[i], 1e-14);
}

}  // namespace
}  // namespace etendue
