// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/search/cell_locator.h"

#include <algorithm>

#include "mesh/tetrahedra/box_grid.h"

namespace etendue {
namespace {

/// Points this part of the domain's diagonal outside of a cell still count as on it.
constexpr double kTolerance = 1e-9;

std::vector<Box> boxes_of(const TetrahedralMesh& mesh) {
  std::vector<Box> boxes(static_cast<std::size_t>(mesh.cell_count()));
  for (std::size_t c = 0; c < boxes.size(); ++c)
    for (const std::int32_t vertex : mesh.cell_vertices()[c])
      boxes[c].extend(mesh.point(VertexIndex(vertex)));
  return boxes;
}

double tolerance_of(const TetrahedralMesh& mesh) {
  Box domain;
  for (const Vec3& point : mesh.points()) domain.extend(point);
  return kTolerance * domain.diagonal().norm();
}

}  // namespace

struct CellLocator::Grid {
  explicit Grid(const TetrahedralMesh& the_mesh)
      : mesh(the_mesh), tolerance(tolerance_of(the_mesh)), cells(boxes_of(the_mesh), tolerance) {}

  const TetrahedralMesh& mesh;
  double tolerance;  ///< [length]
  BoxGrid cells;

  /// The distance of the point from face i [length] is A_i n_i . (q - x) / A_i with q on the face; it is
  /// positive inside, and over the height 3V / A_i it is the barycentric coordinate of vertex i.
  bool locate(CellIndex cell, const Vec3& point, std::array<double, 4>& barycentric) const {
    for (std::size_t i = 0; i < 4; ++i) {
      const FaceIndex face(mesh.faces(cell)[i]);
      const double sign = mesh.owner(face) == cell ? 1 : -1;
      const Vec3& on_face = mesh.point(VertexIndex(mesh.vertices(face)[0]));
      const double flux = sign * mesh.area_normal(face).dot(on_face - point);
      if (flux < -tolerance * mesh.area(face)) return false;
      barycentric[i] = flux / (3 * mesh.volume(cell));
    }
    return true;
  }
};

CellLocator::CellLocator(const TetrahedralMesh& mesh) : grid_(std::make_unique<Grid>(mesh)) {}
CellLocator::~CellLocator() = default;
CellLocator::CellLocator(CellLocator&&) noexcept = default;
CellLocator& CellLocator::operator=(CellLocator&&) noexcept = default;

std::vector<CellPoint> CellLocator::find(const Vec3& point) const {
  std::vector<CellPoint> found;
  for (const std::int32_t candidate : grid_->cells.candidates(point)) {
    CellPoint at{CellIndex(candidate), {}};
    if (grid_->locate(at.cell, point, at.barycentric)) found.push_back(at);
  }
  return found;
}

}  // namespace etendue
