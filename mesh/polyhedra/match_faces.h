// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "base/errors.h"
#include "mesh/polyhedra/polyhedral_mesh.h"

namespace etendue {

/// Polygons, each of one cell or wall.
struct Polygons {
  std::vector<int> points;  ///< of all polygons, one polygon after the other, along their edges
  std::vector<int> ends;    ///< [polygon] where its points end
  std::vector<int> owners;  ///< [polygon] its cell or wall

  /// Throws InputError where points have no numbers any more.
  void add(int owner, std::span<const int> polygon) {
    points.insert(points.end(), polygon.begin(), polygon.end());
    if (points.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      throw InputError("the cells of the mesh have too many faces");
    ends.push_back(static_cast<int>(points.size()));
    owners.push_back(owner);
  }
};

/// Adds the faces to a mesh that has points and cells: polygons of the same points are one face, whose normal
/// points out of the cell that comes first. A face has the wall whose polygon has its points. Throws
/// InputError where more than two cells have a face, or where a wall's polygon is no face.
void match_faces(const Polygons& of_cells, const Polygons& of_walls, PolyhedralMesh& mesh);

}  // namespace etendue
