// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// Cells with polygons as faces, as the mesh of another program has them: not yet checked.
struct PolyhedralMesh {
  std::vector<Vec3> points;
  std::vector<int> face_points;   ///< of all faces, one face after the other
  std::vector<int> face_ends;     ///< [face] where its points end in face_points
  std::vector<int> owners;        ///< [face] the cell that its normal, by the right-hand rule, points out of
  std::vector<int> neighbors;     ///< [face] the cell on the other side; -1 on the boundary
  std::vector<int> face_walls;    ///< [face] index into wall_names; -1: none
  std::vector<int> cell_regions;  ///< [cell] index into region_names
  std::vector<std::string> wall_names;
  std::vector<std::string> region_names;
  std::vector<std::string> patch_types;  ///< [wall] type of the patch by OpenFOAM; empty: not from there
  std::string file;                      ///< for messages

  std::size_t cell_count() const { return cell_regions.size(); }
  std::size_t face_count() const { return face_ends.size(); }
  std::span<const int> face(std::size_t f) const {
    const std::size_t begin = f == 0 ? 0 : static_cast<std::size_t>(face_ends[f - 1]);
    return std::span(face_points).subspan(begin, static_cast<std::size_t>(face_ends[f]) - begin);
  }
};

}  // namespace etendue
