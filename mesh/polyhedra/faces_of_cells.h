// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "mesh/polyhedra/polyhedral_mesh.h"

namespace etendue {

/// A face as one of its cells has it.
struct FaceOfCell {
  int face = 0;
  bool is_owner = true;  ///< else the points of the face run clockwise as seen from outside the cell
};

/// The faces of each cell, in the order of the mesh.
class FacesOfCells {
 public:
  explicit FacesOfCells(const PolyhedralMesh& mesh);
  std::span<const FaceOfCell> of(std::size_t cell) const {
    return std::span(faces_).subspan(begins_[cell], begins_[cell + 1] - begins_[cell]);
  }

 private:
  std::vector<std::size_t> begins_;  ///< [cell + 1]
  std::vector<FaceOfCell> faces_;
};

/// The points of a face, counterclockwise as seen from outside the cell.
std::vector<int> outward_points(const PolyhedralMesh& mesh, const FaceOfCell& face);

}  // namespace etendue
