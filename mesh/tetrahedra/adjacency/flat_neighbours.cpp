// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/adjacency/flat_neighbours.h"

#include <algorithm>

namespace etendue {
namespace {

/// Faces lie in one plane where the cosine between them is within this of 1, and a third one stands on it
/// where its angle with the plane has more than the same sine.
constexpr double flat = 1e-9;

/// The edge of a boundary face opposite one of its vertices.
struct FaceEdge {
  std::array<std::int32_t, 2> ends;
  std::int32_t face;
  std::size_t opposite;
};

std::vector<FaceEdge> sorted_edges(const TetrahedralMesh& mesh) {
  std::vector<FaceEdge> edges;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const auto& v = mesh.vertices(FaceIndex(f));
    for (std::size_t i = 0; i < 3; ++i) edges.push_back({{v[i == 0 ? 1 : 0], v[i == 2 ? 1 : 2]}, f, i});
  }
  std::ranges::stable_sort(edges, {}, &FaceEdge::ends);
  return edges;
}

Vec3 unit_normal(const TetrahedralMesh& mesh, const FaceEdge& edge) {
  return mesh.area_normal(FaceIndex(edge.face)).normalized();
}

/// From the edge to the vertex opposite.
Vec3 away_from(const TetrahedralMesh& mesh, const FaceEdge& edge) {
  const Vec3& tip = mesh.point(VertexIndex(mesh.vertices(FaceIndex(edge.face))[edge.opposite]));
  const Vec3 &a = mesh.point(VertexIndex(edge.ends[0])), &b = mesh.point(VertexIndex(edge.ends[1]));
  const Vec3 along = (b - a).normalized(), offset = tip - a;
  return (offset - offset.dot(along) * along).normalized();
}

}  // namespace

std::vector<std::array<std::int32_t, 3>> flat_neighbours(const TetrahedralMesh& mesh) {
  std::vector<std::array<std::int32_t, 3>> beyond(static_cast<std::size_t>(mesh.boundary_face_count()),
                                                  {-1, -1, -1});
  const std::vector<FaceEdge> edges = sorted_edges(mesh);
  const auto join = [&](std::span<const FaceEdge> around) {
    for (const FaceEdge& a : around)
      for (const FaceEdge& b : around) {
        const Vec3 outward = unit_normal(mesh, a);
        if (a.face == b.face || outward.dot(unit_normal(mesh, b)) <= 1 - flat) continue;
        const bool parted = std::ranges::any_of(
            around, [&](const FaceEdge& c) { return outward.dot(away_from(mesh, c)) < -flat; });
        if (!parted) beyond[static_cast<std::size_t>(a.face)][a.opposite] = b.face;
      }
  };
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    while (last < edges.size() && edges[last].ends == edges[first].ends) ++last;
    join(std::span(edges).subspan(first, last - first));
  }
  return beyond;
}

}  // namespace etendue
