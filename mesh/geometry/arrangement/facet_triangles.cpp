// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/arrangement/facet_triangles.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <map>
#include <set>

namespace etendue {
namespace {

using FacetVertices = CGAL::Triangulation_vertex_base_with_info_2<int, Exact>;
using FacetStructure =
    CGAL::Triangulation_data_structure_2<FacetVertices, CGAL::Constrained_triangulation_face_base_2<Exact>>;
using FacetTriangulation = CGAL::Constrained_Delaunay_triangulation_2<Exact, FacetStructure>;
using FacetFace = FacetTriangulation::Face_handle;
using FacetVertex = FacetTriangulation::Vertex_handle;

/// The triangle on the left of an edge.
FacetFace left_of(const FacetTriangulation& triangulation, FacetVertex from, FacetVertex to) {
  FacetFace face;
  int opposite = 0;
  triangulation.is_edge(from, to, face, opposite);
  return face->vertex(FacetTriangulation::ccw(opposite)) == from ? face : face->neighbor(opposite);
}

}  // namespace

std::vector<std::array<int, 3>> facet_triangles(const std::vector<std::array<int, 2>>& edges,
                                                const std::vector<int>& lone, int axis,
                                                const std::function<const ExactPoint&(int)>& point) {
  FacetTriangulation triangulation;
  std::map<int, FacetVertex> vertices;
  const auto vertex = [&](int corner) {
    const auto known = vertices.find(corner);
    if (known != vertices.end()) return known->second;
    const ExactPoint& p = point(corner);
    const FacetVertex added = triangulation.insert({p[(axis + 1) % 3], p[(axis + 2) % 3]});
    added->info() = corner;
    return vertices[corner] = added;
  };
  for (const int corner : lone) vertex(corner);
  for (const auto& [from, to] : edges) triangulation.insert_constraint(vertex(from), vertex(to));

  std::vector<FacetFace> inside;
  std::set<FacetFace> known;
  const auto reach = [&](FacetFace face) {
    if (known.insert(face).second) inside.push_back(face);
  };
  for (const auto& [from, to] : edges) reach(left_of(triangulation, vertex(from), vertex(to)));
  std::vector<std::array<int, 3>> triangles;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const FacetFace face = inside[i];
    triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    for (int side = 0; side < 3; ++side)
      if (!face->is_constrained(side)) reach(face->neighbor(side));
  }
  return triangles;
}

}  // namespace etendue
