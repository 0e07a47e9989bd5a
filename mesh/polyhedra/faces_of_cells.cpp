// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/polyhedra/faces_of_cells.h"

#include <algorithm>

#include "base/position.h"

namespace etendue {

FacesOfCells::FacesOfCells(const PolyhedralMesh& mesh) : begins_(mesh.cell_count() + 1, 0) {
  const auto for_each_side = [&](const auto& use) {
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      use(mesh.owners[f], FaceOfCell{static_cast<int>(f), true});
      if (mesh.neighbors[f] >= 0) use(mesh.neighbors[f], FaceOfCell{static_cast<int>(f), false});
    }
  };
  for_each_side([&](int cell, const FaceOfCell&) { ++begins_[position(cell) + 1]; });
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) begins_[c + 1] += begins_[c];
  faces_.resize(begins_.back());
  std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
  for_each_side([&](int cell, const FaceOfCell& face) { faces_[next[position(cell)]++] = face; });
}

std::vector<int> outward_points(const PolyhedralMesh& mesh, const FaceOfCell& face) {
  const std::span<const int> points = mesh.face(position(face.face));
  std::vector<int> outward(points.begin(), points.end());
  if (!face.is_owner) std::reverse(outward.begin(), outward.end());
  return outward;
}

}  // namespace etendue
