// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/search/boundary_tree.h"

#include <limits>
#include <vector>

#include "mesh/tetrahedra/bounding_box.h"

namespace etendue {
namespace {

// Of the size of the domain: a ray that meets the edge of two faces must not slip between them.
constexpr double edge_tolerance = 1e-12;

std::vector<FaceTree::Polygon> boundary_faces(const TetrahedralMesh& mesh) {
  std::vector<FaceTree::Polygon> faces;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    faces.push_back(FaceTree::polygon_of(mesh, FaceIndex(f)));
  return faces;
}

}  // namespace

BoundaryTree::BoundaryTree(const TetrahedralMesh& mesh)
    : touching_(edge_tolerance * bounding_box(mesh.points()).diagonal()),
      faces_(boundary_faces(mesh), touching_) {}

std::optional<BoundaryEntry> BoundaryTree::first_entry(const Vec3& origin, const Vec3& direction) const {
  const TreeRay ray = faces_.ray(origin, direction);
  double nearest = std::numeric_limits<double>::infinity();
  std::int32_t found = -1;
  faces_.visit(ray, nearest, [&](const FaceTree::Flat& flat) {
    const double cosine = direction.dot(flat.normal);
    if (cosine >= 0) return;
    const double distance = -flat.height_of(ray.origin) / cosine;
    if (!(distance >= 0 && flat.inside(ray.origin + distance * direction) > -touching_)) return;
    // Of two faces that share the edge the one of the lower number.
    if (distance > nearest || (distance == nearest && flat.face > found)) return;
    nearest = distance;
    found = flat.face;
  });
  if (found < 0) return std::nullopt;
  return BoundaryEntry{FaceIndex(found), origin + nearest * direction};
}

}  // namespace etendue
