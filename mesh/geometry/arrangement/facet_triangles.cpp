// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/arrangement/facet_triangles.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <map>
#include <set>

namespace etendue {
namespace {

using Vertices = CGAL::Triangulation_vertex_base_with_info_2<int, Exact>;
using Structure =
    CGAL::Triangulation_data_structure_2<Vertices, CGAL::Constrained_triangulation_face_base_2<Exact>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Exact, Structure>;
using FaceHandle = Triangulation::Face_handle;
using VertexHandle = Triangulation::Vertex_handle;

/// The triangle on the left of an edge.
FaceHandle left_of(const Triangulation& triangulation, VertexHandle from, VertexHandle to) {
  FaceHandle face;
  int opposite = 0;
  triangulation.is_edge(from, to, face, opposite);
  return face->vertex(Triangulation::ccw(opposite)) == from ? face : face->neighbor(opposite);
}

}  // namespace

std::vector<std::array<int, 3>> facet_triangles(const std::vector<std::array<int, 2>>& edges,
                                                const std::vector<int>& lone, int axis,
                                                const std::function<const ExactPoint&(int)>& point) {
  Triangulation triangulation;
  std::map<int, VertexHandle> vertices;
  const auto vertex = [&](int corner) {
    const auto known = vertices.find(corner);
    if (known != vertices.end()) return known->second;
    const ExactPoint& p = point(corner);
    const VertexHandle added = triangulation.insert({p[(axis + 1) % 3], p[(axis + 2) % 3]});
    added->info() = corner;
    return vertices[corner] = added;
  };
  for (const int corner : lone) vertex(corner);
  for (const auto& [from, to] : edges) triangulation.insert_constraint(vertex(from), vertex(to));

  std::vector<FaceHandle> inside;
  std::set<FaceHandle> known;
  const auto reach = [&](FaceHandle face) {
    if (known.insert(face).second) inside.push_back(face);
  };
  for (const auto& [from, to] : edges) reach(left_of(triangulation, vertex(from), vertex(to)));
  std::vector<std::array<int, 3>> triangles;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const FaceHandle face = inside[i];
    triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    for (int side = 0; side < 3; ++side)
      if (!face->is_constrained(side)) reach(face->neighbor(side));
  }
  return triangles;
}

}  // namespace etendue
