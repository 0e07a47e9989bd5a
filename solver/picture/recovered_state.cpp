// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/picture/recovered_state.h"

#include <algorithm>
#include <vector>

namespace etendue {
namespace {

/// A value at each vertex of each cell, [group][row][4][band]; rows from 1, and cells of row 0 have none.
struct NodalValues {
  std::vector<double>& values;
  std::size_t group_size;  ///< values of one group
  std::size_t groups;
  std::size_t bands;

  double& at(std::size_t group, std::int32_t row, std::size_t node, std::size_t band) const {
    return values[group * group_size + ((static_cast<std::size_t>(row) - 1) * 4 + node) * bands + band];
  }
};

/// Calls use(cell, node, vertex) for the cells of a region that have a row.
template <class Use>
void for_all_nodes(const TetrahedralMesh& mesh, int region, std::span<const std::int32_t> rows,
                   const Use& use) {
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    if (mesh.region(CellIndex(c)) != region || rows[static_cast<std::size_t>(c)] == 0) continue;
    const auto& vertices = mesh.vertices(CellIndex(c));
    for (std::size_t i = 0; i < 4; ++i) use(CellIndex(c), i, static_cast<std::size_t>(vertices[i]));
  }
}

void join(const TetrahedralMesh& mesh, std::span<const std::int32_t> rows, const NodalValues& nodal) {
  const auto vertices = static_cast<std::size_t>(mesh.vertex_count());
  for (int region = 0; region < static_cast<int>(mesh.region_names().size()); ++region)
    for (std::size_t group = 0; group < nodal.groups; ++group) {
      std::vector<double> sum(vertices * nodal.bands, 0), volume(vertices, 0);
      for_all_nodes(mesh, region, rows, [&](CellIndex cell, std::size_t node, std::size_t vertex) {
        volume[vertex] += mesh.volume(cell);
        for (std::size_t b = 0; b < nodal.bands; ++b)
          sum[vertex * nodal.bands + b] += mesh.volume(cell) * nodal.at(group, rows[cell.at()], node, b);
      });
      for_all_nodes(mesh, region, rows, [&](CellIndex cell, std::size_t node, std::size_t vertex) {
        for (std::size_t b = 0; b < nodal.bands; ++b)
          nodal.at(group, rows[cell.at()], node, b) = sum[vertex * nodal.bands + b] / volume[vertex];
      });
    }
}

}  // namespace

SavedState recovered_state(const Problem& problem, const SavedState& state,
                           std::span<const std::int32_t> rows) {
  const TetrahedralMesh& mesh = problem.mesh();
  const auto bands = static_cast<std::size_t>(problem.band_count());
  SavedState joined = state;
  std::vector<std::int32_t> every(static_cast<std::size_t>(mesh.cell_count()));
  std::int32_t most = 0;
  for (std::size_t c = 0; c < every.size(); ++c) {
    every[c] = static_cast<std::int32_t>(c) + 1;
    most = std::max(most, rows[c]);
  }
  join(mesh, every, {joined.fluence, joined.fluence.size(), 1, bands});
  if (most == 0) return joined;
  // [row][moment][4][band]: each moment by itself, as a list of rows.
  const std::size_t row_count = static_cast<std::size_t>(most);
  const std::size_t moments = joined.moments.size() / (row_count * 4 * bands);
  std::vector<double> by_moment(joined.moments.size());
  const auto place = [&](std::size_t row, std::size_t k) { return (row * moments + k) * 4 * bands; };
  for (std::size_t row = 0; row < row_count; ++row)
    for (std::size_t k = 0; k < moments; ++k)
      for (std::size_t i = 0; i < 4 * bands; ++i)
        by_moment[(k * row_count + row) * 4 * bands + i] = joined.moments[place(row, k) + i];
  join(mesh, rows, {by_moment, row_count * 4 * bands, moments, bands});
  for (std::size_t row = 0; row < row_count; ++row)
    for (std::size_t k = 0; k < moments; ++k)
      for (std::size_t i = 0; i < 4 * bands; ++i)
        joined.moments[place(row, k) + i] = by_moment[(k * row_count + row) * 4 * bands + i];
  return joined;
}

}  // namespace etendue
