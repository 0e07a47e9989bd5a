// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/exact/quadratic_nodes.h"

#include <algorithm>
#include <utility>

namespace etendue {
namespace {

using Edge = std::pair<std::int32_t, std::int32_t>;

constexpr std::array<std::array<std::size_t, 2>, 6> edges_of_cell = {
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
constexpr std::array<std::array<std::size_t, 2>, 3> edges_of_face = {{{0, 1}, {0, 2}, {1, 2}}};

/// Vertices of cells and faces are sorted, so an edge is the same pair from every side.
Edge edge_of(const std::array<std::int32_t, 4>& vertices, std::size_t edge) {
  return {vertices[edges_of_cell[edge][0]], vertices[edges_of_cell[edge][1]]};
}

}  // namespace

QuadraticNodes::QuadraticNodes(const TetrahedralMesh& mesh) : mesh_(mesh) {
  std::vector<Edge> edges;
  edges.reserve(6 * static_cast<std::size_t>(mesh.cell_count()));
  for (const auto& vertices : mesh.cell_vertices())
    for (std::size_t e = 0; e < 6; ++e) edges.push_back(edge_of(vertices, e));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const auto& [a, b] : edges)
    middles_.push_back((mesh.point(VertexIndex(a)) + mesh.point(VertexIndex(b))) / 2);
  for (const auto& vertices : mesh.cell_vertices()) {
    std::array<std::int32_t, 6>& of_cell = edges_.emplace_back();
    for (std::size_t e = 0; e < 6; ++e)
      of_cell[e] = static_cast<std::int32_t>(
          std::lower_bound(edges.begin(), edges.end(), edge_of(vertices, e)) - edges.begin());
  }
}

const Vec3& QuadraticNodes::point(std::size_t node) const {
  const std::size_t vertices = mesh_.points().size();
  return node < vertices ? mesh_.points()[node] : middles_[node - vertices];
}

std::array<std::size_t, 10> QuadraticNodes::nodes(CellIndex cell) const {
  std::array<std::size_t, 10> found{};
  for (std::size_t i = 0; i < 4; ++i) found[i] = static_cast<std::size_t>(mesh_.vertices(cell)[i]);
  for (std::size_t e = 0; e < 6; ++e)
    found[4 + e] = mesh_.points().size() + static_cast<std::size_t>(edges_[cell.at()][e]);
  return found;
}

std::array<std::size_t, 6> QuadraticNodes::nodes(FaceIndex face) const {
  const CellIndex owner = mesh_.owner(face);
  const auto& corners = mesh_.vertices(face);
  const std::array<std::size_t, 10> of_cell = nodes(owner);
  std::array<std::size_t, 6> found{};
  for (std::size_t i = 0; i < 3; ++i) found[i] = static_cast<std::size_t>(corners[i]);
  for (std::size_t k = 0; k < 3; ++k) {
    const Edge edge = {corners[edges_of_face[k][0]], corners[edges_of_face[k][1]]};
    for (std::size_t e = 0; e < 6; ++e)
      if (edge_of(mesh_.vertices(owner), e) == edge) found[3 + k] = of_cell[4 + e];
  }
  return found;
}

// Right-hand sides b_i, the integrals of the quadratic times the barycentric coordinate i per volume or area,
// from the integrals of products of barycentric coordinates: of a vertex's function 0 with its own coordinate
// and -1/60 with others, of an edge's 1/15 with those of its ends and 1/30 with others; on a triangle 1/30,
// -1/60, 2/15 and 1/15. The mass matrices (I + 11^T)/20 and (I + 11^T)/12 are then inverted.
std::array<double, 4> project(const std::array<double, 10>& values) {
  double of_vertices = 0, of_edges = 0;
  for (std::size_t i = 0; i < 4; ++i) of_vertices += values[i];
  for (std::size_t e = 0; e < 6; ++e) of_edges += values[4 + e];
  std::array<double, 4> found{};
  for (std::size_t i = 0; i < 4; ++i) found[i] = of_edges / 30 - (of_vertices - values[i]) / 60;
  for (std::size_t e = 0; e < 6; ++e)
    for (const std::size_t end : edges_of_cell[e]) found[end] += values[4 + e] / 30;
  const double mean = found[0] + found[1] + found[2] + found[3];
  for (double& value : found) value = 20 * value - 4 * mean;
  return found;
}

std::array<double, 3> project(const std::array<double, 6>& values) {
  const double of_vertices = values[0] + values[1] + values[2], of_edges = values[3] + values[4] + values[5];
  std::array<double, 3> found{};
  for (std::size_t i = 0; i < 3; ++i)
    found[i] = of_edges / 15 + values[i] / 30 - (of_vertices - values[i]) / 60;
  for (std::size_t e = 0; e < 3; ++e)
    for (const std::size_t end : edges_of_face[e]) found[end] += values[3 + e] / 15;
  const double mean = found[0] + found[1] + found[2];
  for (double& value : found) value = 12 * value - 3 * mean;
  return found;
}

}  // namespace etendue
