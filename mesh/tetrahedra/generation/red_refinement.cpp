// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/generation/red_refinement.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

namespace etendue {
namespace {

/// The middles of edges, each made once.
class Middles {
 public:
  explicit Middles(std::vector<Vec3>& points) : points_(points) {}

  int between(int a, int b) {
    const auto [low, high] = std::minmax(a, b);
    const std::uint64_t edge = (static_cast<std::uint64_t>(low) << 32) | static_cast<std::uint32_t>(high);
    const auto [place, is_new] = of_edge_.try_emplace(edge, static_cast<int>(points_.size()));
    if (is_new) {
      const Vec3 middle =
          0.5 * (points_[static_cast<std::size_t>(low)] + points_[static_cast<std::size_t>(high)]);
      points_.push_back(middle);
    }
    return place->second;
  }

 private:
  std::vector<Vec3>& points_;
  std::unordered_map<std::uint64_t, int> of_edge_;
};

using Cell = std::array<int, 4>;

/// The eight parts of a cell, oriented as it is.
std::array<Cell, 8> parts_of(const Cell& v, Middles& middles, const std::vector<Vec3>& points) {
  const auto middle = [&](std::size_t i, std::size_t j) { return middles.between(v[i], v[j]); };
  // Middles of opposite edges: the diagonals of the octahedron.
  const std::array<std::array<int, 2>, 3> diagonals = {
      {{middle(0, 1), middle(2, 3)}, {middle(0, 2), middle(1, 3)}, {middle(0, 3), middle(1, 2)}}};
  std::array<double, 3> lengths{};
  for (std::size_t k = 0; k < 3; ++k)
    lengths[k] = (points[static_cast<std::size_t>(diagonals[k][0])] -
                  points[static_cast<std::size_t>(diagonals[k][1])])
                     .squaredNorm();
  const auto shortest =
      static_cast<std::size_t>(std::min_element(lengths.begin(), lengths.end()) - lengths.begin());
  const auto& [a, b] = diagonals[shortest];
  // The other four go round it, neighbours being ends of different diagonals.
  const auto& one = diagonals[(shortest + 1) % 3];
  const auto& other = diagonals[(shortest + 2) % 3];
  const std::array<int, 4> ring = {one[0], other[0], one[1], other[1]};
  return {{{v[0], middle(0, 1), middle(0, 2), middle(0, 3)},
           {middle(0, 1), v[1], middle(1, 2), middle(1, 3)},
           {middle(0, 2), middle(1, 2), v[2], middle(2, 3)},
           {middle(0, 3), middle(1, 3), middle(2, 3), v[3]},
           {a, b, ring[0], ring[1]},
           {a, b, ring[1], ring[2]},
           {a, b, ring[2], ring[3]},
           {a, b, ring[3], ring[0]}}};
}

}  // namespace

RawMesh red_refinement(const RawMesh& mesh) {
  RawMesh fine;
  fine.points = mesh.points;
  fine.region_names = mesh.region_names;
  fine.wall_names = mesh.wall_names;
  fine.file = mesh.file;
  fine.parents.mesh = mesh.parents.mesh;
  Middles middles(fine.points);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const Cell& part : parts_of(mesh.cells[c], middles, fine.points)) {
      fine.cells.push_back(part);
      fine.cell_regions.push_back(mesh.cell_regions[c]);
      if (mesh.parents.mesh) fine.parents.cells.push_back(mesh.parents.cells[c]);
    }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const int ab = middles.between(a, b), bc = middles.between(b, c), ca = middles.between(c, a);
    for (const std::array<int, 3>& part :
         {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{ab, bc, ca}}) {
      fine.triangles.push_back(part);
      fine.triangle_walls.push_back(mesh.triangle_walls[t]);
      if (mesh.parents.mesh) fine.parents.faces.push_back(mesh.parents.faces[t]);
    }
  }
  return fine;
}

}  // namespace etendue
