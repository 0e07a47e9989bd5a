// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/index.h"
#include "base/vec3.h"
#include "mesh/tetrahedra/raw_mesh.h"

namespace etendue {

/// A conforming tetrahedral mesh: geometry and topology, checked once and then immutable. It knows nothing
/// about light. Lengths are in the unit of the case.
///
/// Cells and vertices are numbered along a space-filling curve. The vertices of each cell are sorted by
/// their number, and so are those of each face: the three vertices that a face has in common with the
/// cells on its two sides are in the same order everywhere. Face f of a cell lies opposite its vertex f.
/// Boundary faces come first: face < boundary_face_count() exactly when it lies on a wall.
class TetrahedralMesh {
 public:
  /// Checks, connects and renumbers. Throws InputError, naming the cell or face and its coordinates, where a
  /// cell has no positive volume or is inverted against its neighbours, where faces do not conform, or
  /// where a boundary face has no wall name although others have one. Without any named triangle the whole
  /// boundary is the wall "boundary".
  explicit TetrahedralMesh(const RawMesh& raw);

  int cell_count() const { return static_cast<int>(cell_vertices_.size()); }
  int face_count() const { return static_cast<int>(face_vertices_.size()); }
  int vertex_count() const { return static_cast<int>(points_.size()); }
  int boundary_face_count() const { return static_cast<int>(face_walls_.size()); }

  const Vec3& point(VertexIndex v) const { return points_[v.at()]; }
  const std::array<std::int32_t, 4>& vertices(CellIndex c) const { return cell_vertices_[c.at()]; }
  const std::array<std::int32_t, 3>& vertices(FaceIndex f) const { return face_vertices_[f.at()]; }
  const std::array<std::int32_t, 4>& faces(CellIndex c) const { return cell_faces_[c.at()]; }
  double volume(CellIndex c) const { return volumes_[c.at()]; }                 ///< [length^3]
  double area(FaceIndex f) const { return face_area_normals_[f.at()].norm(); }  ///< [length^2]
  const Vec3& area_normal(FaceIndex f) const {
    return face_area_normals_[f.at()];
  }  ///< [length^2] out of the owner
  Vec3 centroid(CellIndex c) const;
  Vec3 centroid(FaceIndex f) const;
  /// The cell that the normal points out of.
  CellIndex owner(FaceIndex f) const { return CellIndex(face_cells_[f.at()][0]); }
  /// The cell that the normal points into; only for interior faces.
  CellIndex neighbour(FaceIndex f) const { return CellIndex(face_cells_[f.at()][1]); }
  int region(CellIndex c) const { return cell_regions_[c.at()]; }
  /// Only for boundary faces.
  int wall(FaceIndex f) const { return face_walls_[f.at()]; }

  // Whole arrays, for loops over all of them.
  std::span<const Vec3> points() const { return points_; }
  std::span<const std::array<std::int32_t, 4>> cell_vertices() const { return cell_vertices_; }
  std::span<const std::array<std::int32_t, 4>> cell_faces() const { return cell_faces_; }
  std::span<const std::array<std::int32_t, 3>> face_vertices() const { return face_vertices_; }
  /// [face] {owner, neighbour}; the neighbour of a boundary face is -1.
  std::span<const std::array<std::int32_t, 2>> face_cells() const { return face_cells_; }
  std::span<const Vec3> face_area_normals() const { return face_area_normals_; }
  std::span<const double> volumes() const { return volumes_; }
  std::span<const std::int32_t> cell_regions() const { return cell_regions_; }
  std::span<const std::int32_t> face_walls() const { return face_walls_; }

  /// Where the cells are parts of others': the parent of each cell, and of each boundary face.
  const ParentCells& parents() const { return parents_; }

  const std::vector<std::string>& region_names() const { return region_names_; }
  const std::vector<std::string>& wall_names() const { return wall_names_; }

 private:
  std::vector<Vec3> points_;
  std::vector<std::array<std::int32_t, 4>> cell_vertices_;
  std::vector<std::array<std::int32_t, 4>> cell_faces_;
  std::vector<std::array<std::int32_t, 3>> face_vertices_;
  std::vector<std::array<std::int32_t, 2>> face_cells_;
  std::vector<Vec3> face_area_normals_;
  std::vector<double> volumes_;
  std::vector<std::int32_t> cell_regions_;
  std::vector<std::int32_t> face_walls_;  ///< [boundary face]
  ParentCells parents_;
  std::vector<std::string> region_names_;
  std::vector<std::string> wall_names_;
};

}  // namespace etendue
