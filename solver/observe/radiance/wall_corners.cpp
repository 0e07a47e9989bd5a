// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/radiance/wall_corners.h"

#include <algorithm>

#include "base/field_view.h"
#include "mesh/tetrahedra/adjacency/flat_neighbours.h"
#include "mesh/tetrahedra/corners.h"

namespace etendue {
namespace {

/// [vertex] the corners of boundary faces that meet there.
std::vector<std::vector<WallCorner>> corners_at_vertices(const TetrahedralMesh& mesh) {
  std::vector<std::vector<WallCorner>> corners(static_cast<std::size_t>(mesh.vertex_count()));
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      corners[static_cast<std::size_t>(mesh.vertices(FaceIndex(f))[i])].push_back({FaceIndex(f), i});
  return corners;
}

std::vector<std::vector<WallCorner>> joined_corners(const TetrahedralMesh& mesh, WallBorders borders) {
  const std::vector<std::array<std::int32_t, 3>> beyond = flat_neighbours(mesh);
  const auto is_beside = [&](const WallCorner& a, const WallCorner& b) {
    const auto& next = beyond[a.face.at()];
    return std::ranges::find(next, b.face.value()) != next.end() &&
           (borders == WallBorders::continuous || mesh.wall(a.face) == mesh.wall(b.face));
  };
  std::vector<std::vector<WallCorner>> planes;
  for (std::vector<WallCorner>& left : corners_at_vertices(mesh))
    while (!left.empty()) {
      std::vector<WallCorner> plane = {left.front()};
      left.erase(left.begin());
      for (std::size_t i = 0; i < plane.size(); ++i) {
        const auto rest = std::stable_partition(
            left.begin(), left.end(), [&](const WallCorner& corner) { return !is_beside(plane[i], corner); });
        plane.insert(plane.end(), rest, left.end());
        left.erase(rest, left.end());
      }
      planes.push_back(std::move(plane));
    }
  return planes;
}

}  // namespace

std::vector<std::vector<WallCorner>> corners_by_plane(const TetrahedralMesh& mesh) {
  return joined_corners(mesh, WallBorders::continuous);
}

std::vector<double> joined_on_planes(const TetrahedralMesh& mesh, std::span<const double> values,
                                     std::size_t face_nodes, std::size_t bands, WallBorders borders) {
  std::vector<double> joined(static_cast<std::size_t>(mesh.boundary_face_count()) * 3 * bands, 0);
  for (const std::vector<WallCorner>& plane : joined_corners(mesh, borders))
    for (std::size_t b = 0; b < bands; ++b) {
      double area = 0, sum = 0;
      for (const WallCorner& corner : plane) {
        const std::size_t node = corner.face.at() * face_nodes + (face_nodes == 3 ? corner.node : 0);
        area += mesh.area(corner.face);
        sum += mesh.area(corner.face) * values[node * bands + b];
      }
      for (const WallCorner& corner : plane)
        FaceField(joined, bands)(corner.face, corner.node, b) = sum / area;
    }
  return joined;
}

// Parts of the area that the point cuts off with the edges.
std::array<double, 3> barycentric(const TetrahedralMesh& mesh, FaceIndex face, const Vec3& point) {
  std::array<Vec3, 3> to = corners_of(mesh, face);
  for (Vec3& corner : to) corner -= point;
  const Vec3 whole = (to[1] - to[0]).cross(to[2] - to[0]);
  std::array<double, 3> part;
  for (std::size_t i = 0; i < 3; ++i)
    part[i] = to[(i + 1) % 3].cross(to[(i + 2) % 3]).dot(whole) / whole.squaredNorm();
  return part;
}

}  // namespace etendue
