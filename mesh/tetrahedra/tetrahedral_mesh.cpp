// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/tetrahedral_mesh.h"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

#include "base/position.h"
#include "mesh/tetrahedra/boundary_checks.h"
#include "mesh/tetrahedra/cell_checks.h"
#include "mesh/tetrahedra/connectivity.h"
#include "mesh/tetrahedra/space_filling_curve.h"
#include "mesh/tetrahedra/wall_names.h"

namespace etendue {
namespace {

/// The centroid, to the same bits for any order of the vertices, so that numbering a mesh again changes
/// nothing.
Vec3 order_free_centroid(const RawMesh& raw, const std::array<int, 4>& cell) {
  Vec3 centroid;
  for (int axis = 0; axis < 3; ++axis) {
    std::array<double, 4> x{};
    for (std::size_t i = 0; i < 4; ++i) x[i] = raw.points[position(cell[i])][axis];
    std::sort(x.begin(), x.end());
    centroid[axis] = (x[0] + x[1] + x[2] + x[3]) / 4;
  }
  return centroid;
}

/// Cells along the curve, vertices as the cells meet them, each cell by the points' own order, so that the
/// order within a cell does not matter; points that no cell uses are left out.
MeshNumbering number_along_curve(const RawMesh& raw) {
  std::vector<Vec3> centroids;
  centroids.reserve(raw.cells.size());
  for (const auto& cell : raw.cells) centroids.push_back(order_free_centroid(raw, cell));
  MeshNumbering numbering{curve_order(centroids), {}};
  std::vector<char> met(raw.points.size(), 0);
  for (const std::int32_t cell : numbering.cells) {
    std::array<int, 4> points = raw.cells[position(cell)];
    std::sort(points.begin(), points.end());
    for (const int point : points)
      if (!std::exchange(met[position(point)], 1)) numbering.vertices.push_back(point);
  }
  return numbering;
}

/// The cells in their new order and in numbers of vertices.
std::vector<std::array<std::int32_t, 4>> renumbered(std::span<const std::array<std::int32_t, 4>> raw_cells,
                                                    const MeshNumbering& numbering, std::size_t points) {
  std::vector<std::int32_t> vertex(points, -1);
  for (std::size_t v = 0; v < numbering.vertices.size(); ++v)
    vertex[position(numbering.vertices[v])] = static_cast<std::int32_t>(v);
  std::vector<std::array<std::int32_t, 4>> cells;
  cells.reserve(numbering.cells.size());
  for (const std::int32_t cell : numbering.cells) {
    cells.push_back(raw_cells[position(cell)]);
    for (std::int32_t& point : cells.back()) point = vertex[position(point)];
  }
  return cells;
}

ParentCells renumbered(const ParentCells& raw, const MeshNumbering& numbering,
                       const std::vector<std::int32_t>& triangles) {
  ParentCells parents{raw.mesh, {}, {}};
  for (const std::int32_t cell : numbering.cells) parents.cells.push_back(raw.cells[position(cell)]);
  for (const std::int32_t triangle : triangles)
    parents.faces.push_back(triangle < 0 ? -1 : raw.faces[position(triangle)]);
  return parents;
}

}  // namespace

TetrahedralMesh::TetrahedralMesh(const RawMesh& raw) {
  check_cells_and_points(raw);
  const auto oriented = positively_oriented_cells(raw);
  check_points_differ(raw);

  const MeshNumbering numbering = number_along_curve(raw);
  for (const std::int32_t point : numbering.vertices) points_.push_back(raw.points[position(point)]);
  SortedCells cells = sort_vertices(renumbered(oriented, numbering, raw.points.size()));
  MeshFaces faces = connect_faces(cells, numbering, raw);
  check_boundary_conforms(points_, faces, numbering, raw);

  const std::vector<std::int32_t> triangles = boundary_triangles(faces, numbering, raw);
  NamedParts walls = name_walls(triangles, faces, numbering, raw);
  if (raw.parents.mesh) parents_ = renumbered(raw.parents, numbering, triangles);
  face_walls_ = std::move(walls.parts);
  wall_names_ = std::move(walls.names);
  std::vector<std::int32_t> regions;
  regions.reserve(numbering.cells.size());
  for (const std::int32_t cell : numbering.cells) regions.push_back(raw.cell_regions[position(cell)]);
  NamedParts named_regions = used_names(std::move(regions), raw.region_names);
  cell_regions_ = std::move(named_regions.parts);
  region_names_ = std::move(named_regions.names);

  volumes_.reserve(cells.vertices.size());
  for (std::size_t c = 0; c < cells.vertices.size(); ++c) {
    const auto& v = cells.vertices[c];
    const Vec3& p = points_[position(v[0])];
    const double six_volumes =
        (points_[position(v[1])] - p).cross(points_[position(v[2])] - p).dot(points_[position(v[3])] - p);
    volumes_.push_back(cells.orientation[c] * six_volumes / 6);
  }
  face_area_normals_.reserve(faces.vertices.size());
  for (std::size_t f = 0; f < faces.vertices.size(); ++f) {
    const auto& v = faces.vertices[f];
    const Vec3& p = points_[position(v[0])];
    face_area_normals_.push_back(0.5 * faces.orientation[f] *
                                 (points_[position(v[1])] - p).cross(points_[position(v[2])] - p));
  }
  cell_vertices_ = std::move(cells.vertices);
  cell_faces_ = std::move(faces.of_cell);
  face_vertices_ = std::move(faces.vertices);
  face_cells_ = std::move(faces.cells);
}

Vec3 TetrahedralMesh::centroid(CellIndex c) const {
  const auto& v = vertices(c);
  return (points_[position(v[0])] + points_[position(v[1])] + points_[position(v[2])] +
          points_[position(v[3])]) /
         4;
}

Vec3 TetrahedralMesh::centroid(FaceIndex f) const {
  const auto& v = vertices(f);
  return (points_[position(v[0])] + points_[position(v[1])] + points_[position(v[2])]) / 3;
}

}  // namespace etendue
