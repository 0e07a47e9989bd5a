// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/radiance/quadratic_reconstruction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

#include "tests/solver/transport/linear_fits.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::quadratic_reconstruction_test {
namespace {

using Function = std::function<double(const Vec3&)>;

/// Its fluence is that, and its two moments in the cells with a row are that and minus twice that.
SavedState state_of(const std::vector<double>& nodal, std::span<const std::int32_t> rows) {
  SavedState state;
  state.bands = 1;
  state.fluence = nodal;
  for (std::size_t c = 0; c < rows.size(); ++c) {
    if (rows[c] == 0) continue;
    for (const double factor : {1., -2.})
      for (std::size_t i = 0; i < 4; ++i) state.moments.push_back(factor * nodal[4 * c + i]);
  }
  return state;
}

std::vector<std::int32_t> every_cell(const TetrahedralMesh& mesh) {
  std::vector<std::int32_t> rows(static_cast<std::size_t>(mesh.cell_count()));
  std::iota(rows.begin(), rows.end(), 1);
  return rows;
}

/// A reconstructed cell in the middle of an edge.
double in_middle(const double* reconstructed, std::size_t edge) {
  return (reconstructed[cell_edges[edge].first] + reconstructed[cell_edges[edge].second]) / 2 +
         reconstructed[4 + edge];
}

struct Errors {
  double largest;
  double root_mean_square;
};

/// Of the values at the vertices and in the middles of edges.
Errors errors_of(const TetrahedralMesh& mesh, const std::vector<double>& reconstructed,
                 const Function& truth) {
  double largest = 0, squares = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const double* values = &reconstructed[static_cast<std::size_t>(c) * quadratic_nodes];
    const auto point = [&](std::size_t i) { return mesh.point(VertexIndex(mesh.vertices(CellIndex(c))[i])); };
    const auto add = [&](double value, const Vec3& place) {
      const double error = std::abs(value - truth(place));
      largest = std::max(largest, error);
      squares += error * error / static_cast<double>(reconstructed.size());
    };
    for (std::size_t i = 0; i < 4; ++i) add(values[i], point(i));
    for (std::size_t e = 0; e < 6; ++e)
      add(in_middle(values, e), (point(cell_edges[e].first) + point(cell_edges[e].second)) / 2);
  }
  return {largest, std::sqrt(squares)};
}

double quadratic(const Vec3& p) {
  return 1 + p.x() - 2 * p.y() + 3 * p.x() * p.y() - p.z() * p.z() + 0.5 * p.x() * p.x() + p.y() * p.z();
}

TEST(QuadraticReconstruction, FindsAQuadraticAgainFromItsFits) {
  for (const double volume : {2e-2, 2e-3}) {
    const TetrahedralMesh mesh = cube_mesh(volume);
    const Problem problem = uniform_problem(mesh, uniform_medium(1, 1, 1, 1), uniform_wall(1, 0, 0, 0));
    const SavedState state = state_of(linear_fits(mesh, quadratic), every_cell(mesh));
    const SavedState reconstructed = quadratic_reconstruction(problem, state, every_cell(mesh), 2);
    EXPECT_LT(errors_of(mesh, reconstructed.fluence, quadratic).largest, 1e-11);
    for (std::size_t c = 0; c < static_cast<std::size_t>(mesh.cell_count()); ++c)
      for (std::size_t i = 0; i < quadratic_nodes; ++i) {
        EXPECT_EQ(reconstructed.moments[2 * c * quadratic_nodes + i],
                  reconstructed.fluence[c * quadratic_nodes + i]);
        EXPECT_NEAR(reconstructed.moments[(2 * c + 1) * quadratic_nodes + i],
                    -2 * reconstructed.fluence[c * quadratic_nodes + i], 1e-11);
      }
  }
}

TEST(QuadraticReconstruction, NearsASmoothFieldAtOrderThree) {
  const Function smooth = [](const Vec3& p) { return std::sin(3 * p.x() + 1) * std::exp(p.y() - p.z()); };
  const auto error = [&](double volume) {
    const TetrahedralMesh mesh = cube_mesh(volume);
    const Problem problem = uniform_problem(mesh, uniform_medium(1, 1, 1, 1), uniform_wall(1, 0, 0, 0));
    const SavedState state = state_of(linear_fits(mesh, smooth), every_cell(mesh));
    return errors_of(mesh, quadratic_reconstruction(problem, state, every_cell(mesh), 2).fluence, smooth)
        .root_mean_square;
  };
  EXPECT_GT(std::log2(error(4e-3) / error(4e-3 / 64)) / 2, 2.7);
}

// A jump between two regions leaves both linear, and so do moments where those of a cell around are not
// known.
TEST(QuadraticReconstruction, LeavesRegionsApart) {
  const TetrahedralMesh mesh = two_region_mesh(0.02);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 1, 1, 1), uniform_wall(1, 0, 0, 0));
  std::vector<double> steps;
  std::vector<std::int32_t> rows;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    steps.insert(steps.end(), 4, mesh.region(CellIndex(c)) == 0 ? 1.0 : 5.0);
    rows.push_back(c == 0 ? 1 : 0);
  }
  const SavedState reconstructed = quadratic_reconstruction(problem, state_of(steps, rows), rows, 1);
  for (std::size_t c = 0; c < rows.size(); ++c)
    for (std::size_t i = 0; i < quadratic_nodes; ++i)
      EXPECT_NEAR(reconstructed.fluence[c * quadratic_nodes + i], i < 4 ? steps[4 * c] : 0, 1e-12);

  const SavedState alone =
      quadratic_reconstruction(problem, state_of(linear_fits(mesh, quadratic), rows), rows, 1);
  ASSERT_EQ(alone.moments.size(), 2 * quadratic_nodes);
  for (std::size_t e = 4; e < quadratic_nodes; ++e) EXPECT_EQ(alone.moments[e], 0);
}

}  // namespace
}  // namespace etendue::quadratic_reconstruction_test
