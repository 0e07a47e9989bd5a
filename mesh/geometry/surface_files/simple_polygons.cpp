// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/surface_files/simple_polygons.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

#include "base/position.h"
#include "mesh/geometry/primitives/primitive_checks.h"
#include "mesh/geometry/surface_files/outline.h"

namespace etendue {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using PolygonVertices = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;  // the number of the point
using PolygonFaces =
    CGAL::Triangulation_face_base_with_info_2<std::optional<bool>, Kernel,  // whether it is inside
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using PolygonTriangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<PolygonVertices, PolygonFaces>>;
using PolygonFace = PolygonTriangulation::Face_handle;

bool is_simple(std::vector<int> polygon) {
  std::ranges::sort(polygon);
  return std::ranges::adjacent_find(polygon) == polygon.end();
}

/// The edges without bridges: a bridge is in the outline twice.
std::vector<std::array<int, 2>> outline_edges(const std::vector<int>& polygon) {
  std::map<std::array<int, 2>, int> times;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto [a, b] = std::minmax(polygon[i], polygon[(i + 1) % polygon.size()]);
    ++times[{a, b}];
  }
  std::vector<std::array<int, 2>> edges;
  for (const auto& [edge, count] : times)
    if (count % 2 == 1) edges.push_back(edge);
  return edges;
}

/// Tells inside from outside, from the outermost face inward.
void mark_inside(PolygonTriangulation& triangulation) {
  std::vector<PolygonFace> front{triangulation.infinite_face()};
  front.front()->info() = false;
  while (!front.empty()) {
    const PolygonFace face = front.back();
    front.pop_back();
    for (int side = 0; side < 3; ++side) {
      const PolygonFace next = face->neighbor(side);
      if (next->info()) continue;
      next->info() = *face->info() != face->is_constrained(side);
      front.push_back(next);
    }
  }
}

/// The triangles of a polygon, turned as it is.
std::vector<std::vector<int>> triangles_of(const std::vector<Vec3>& points, const std::vector<int>& polygon) {
  const Vec3 normal = outline_area_normal(points, polygon);
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  PolygonTriangulation triangulation;
  std::map<int, PolygonTriangulation::Vertex_handle> vertices;
  for (const int corner : polygon) {
    const Vec3& p = points[position(corner)];
    const auto vertex = triangulation.insert({p[(axis + 1) % 3], p[(axis + 2) % 3]});
    vertex->info() = corner;
    vertices[corner] = vertex;
  }
  for (const auto& [a, b] : outline_edges(polygon))
    if (vertices[a] != vertices[b]) triangulation.insert_constraint(vertices[a], vertices[b]);
  if (triangulation.dimension() < 2) return {};
  mark_inside(triangulation);
  std::vector<std::vector<int>> triangles;
  for (const PolygonFace face : triangulation.finite_face_handles()) {
    if (!*face->info()) continue;
    std::vector<int> triangle{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
    if (normal[axis] < 0) std::swap(triangle[1], triangle[2]);
    triangles.push_back(std::move(triangle));
  }
  return triangles;
}

}  // namespace

PolygonSoup with_simple_polygons(const PolygonSoup& soup) {
  PolygonSoup result{soup.points, {}, {}, soup.wall_names};
  const auto add = [&](std::vector<int> polygon, int wall) {
    result.polygons.push_back(std::move(polygon));
    result.walls.push_back(wall);
  };
  for (std::size_t i = 0; i < soup.polygons.size(); ++i) {
    const std::vector<int>& polygon = soup.polygons[i];
    if (is_simple(polygon)) {
      add(polygon, soup.walls[i]);
      continue;
    }
    try {
      for (std::vector<int>& triangle : triangles_of(soup.points, polygon))
        add(std::move(triangle), soup.walls[i]);
    } catch (const PolygonTriangulation::Intersection_of_constraints_exception&) {
      throw std::invalid_argument(fmt::format(
          "the polygon of {} corners that begins {} {} crosses itself; cut it into simple polygons",
          polygon.size(), text_of(soup.points[position(polygon[0])]),
          text_of(soup.points[position(polygon[1])])));
    }
  }
  return result;
}

}  // namespace etendue
