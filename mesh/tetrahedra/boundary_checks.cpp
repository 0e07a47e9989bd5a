// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/boundary_checks.h"

#include <algorithm>
#include <vector>

#include "base/position.h"
#include "mesh/tetrahedra/bounding_box.h"
#include "mesh/tetrahedra/box_grid.h"
#include "mesh/tetrahedra/mesh_faults.h"

namespace etendue {
namespace {

/// Points nearer than this part of the domain's diagonal count as the same place.
constexpr double kTouching = 1e-9;

/// A boundary triangle with the normals of its plane and of its edges within the plane.
struct Triangle {
  std::array<Vec3, 3> corners;

  bool touches(const Vec3& p, double tolerance) const {
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    if (std::abs(normal.dot(p - corners[0])) > tolerance) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 edge = corners[(i + 1) % 3] - corners[i];
      if (normal.cross(edge).dot(p - corners[i]) < -tolerance * edge.norm()) return false;
    }
    return true;
  }
};

class BoundaryCheck {
 public:
  BoundaryCheck(std::span<const Vec3> points, const MeshFaces& faces, const MeshNumbering& numbering,
                const RawMesh& raw)
      : points_(points),
        faces_(faces),
        numbering_(numbering),
        tolerance_(kTouching * bounding_box(points).diagonal()),
        grid_(boxes(), tolerance_),
        faults_(raw) {}

  void run() {
    for (const std::int32_t vertex : boundary_vertices()) check_vertex(vertex);
    faults_.throw_if_any();
    for (std::int32_t face = 0; face < faces_.boundary_count; ++face) check_face(face);
    faults_.throw_if_any();
  }

 private:
  Triangle triangle(std::int32_t face) const {
    const auto& v = faces_.vertices[position(face)];
    return {{points_[position(v[0])], points_[position(v[1])], points_[position(v[2])]}};
  }

  std::vector<Box> boxes() const {
    std::vector<Box> boxes(position(faces_.boundary_count));
    for (std::int32_t face = 0; face < faces_.boundary_count; ++face)
      for (const Vec3& corner : triangle(face).corners) boxes[position(face)].extend(corner);
    return boxes;
  }

  std::vector<std::int32_t> boundary_vertices() const {
    std::vector<std::int32_t> vertices;
    for (std::int32_t face = 0; face < faces_.boundary_count; ++face)
      vertices.insert(vertices.end(), faces_.vertices[position(face)].begin(),
                      faces_.vertices[position(face)].end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }

  std::array<std::int32_t, 3> raw_points(std::int32_t face) const {
    const auto& v = faces_.vertices[position(face)];
    return {numbering_.vertices[position(v[0])], numbering_.vertices[position(v[1])],
            numbering_.vertices[position(v[2])]};
  }
  int raw_owner(std::int32_t face) const {
    return numbering_.cells[position(faces_.cells[position(face)][0])];
  }

  void check_vertex(std::int32_t vertex) {
    const Vec3& p = points_[position(vertex)];
    for (const std::int32_t face : grid_.candidates(p)) {
      const auto& v = faces_.vertices[position(face)];
      if (std::find(v.begin(), v.end(), vertex) != v.end() || !triangle(face).touches(p, tolerance_))
        continue;
      faults_.add_face(raw_points(face), {raw_owner(face)},
                       "vertex " + faults_.point_name(numbering_.vertices[position(vertex)]) + " at " +
                           to_text(p) +
                           " lies on it without being one of its corners (the mesh does not conform)",
                       "cells must share whole faces");
      return;
    }
  }

  void check_face(std::int32_t face) {
    const auto [a, b, c] = triangle(face).corners;
    const Vec3 middle = (a + b + c) / 3;
    for (const std::int32_t other : grid_.candidates(middle)) {
      if (other == face || !triangle(other).touches(middle, tolerance_)) continue;
      if (faces_.vertices[position(other)] == faces_.vertices[position(face)])
        continue;  // the two sides of a sheet
      faults_.add_face(raw_points(face), {raw_owner(face), raw_owner(other)},
                       "the boundary faces of two cells cover each other (the mesh does not conform)",
                       "cells must share whole faces");
      return;
    }
  }

  std::span<const Vec3> points_;
  const MeshFaces& faces_;
  const MeshNumbering& numbering_;
  double tolerance_;
  BoxGrid grid_;
  MeshFaults faults_;
};

}  // namespace

void check_boundary_conforms(std::span<const Vec3> points, const MeshFaces& faces,
                             const MeshNumbering& numbering, const RawMesh& raw) {
  BoundaryCheck(points, faces, numbering, raw).run();
}

}  // namespace etendue
