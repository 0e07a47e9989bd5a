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

#include "mesh/geometry/primitives/primitive_checks.h"

namespace etendue {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;  // the number of the point
using Faces = CGAL::Triangulation_face_base_with_info_2<std::optional<bool>, Kernel,  // whether it is inside
                                                        CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertices, Faces>>;
using FaceHandle = Triangulation::Face_handle;

std::size_t n(int i) { return static_cast<std::size_t>(i); }

bool is_simple(std::vector<int> polygon) {
  std::ranges::sort(polygon);
  return std::ranges::adjacent_find(polygon) == polygon.end();
}

/// Twice the area times the normal (Newell's sum over the edges).
Vec3 area_normal(const std::vector<Vec3>& points, const std::vector<int>& polygon) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += (points[n(polygon[i])] - points[n(polygon[0])])
               .cross(points[n(polygon[i + 1])] - points[n(polygon[0])]);
  return sum;
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
void mark_inside(Triangulation& triangulation) {
  std::vector<FaceHandle> front{triangulation.infinite_face()};
  front.front()->info() = false;
  while (!front.empty()) {
    const FaceHandle face = front.back();
    front.pop_back();
    for (int side = 0; side < 3; ++side) {
      const FaceHandle next = face->neighbor(side);
      if (next->info()) continue;
      next->info() = *face->info() != face->is_constrained(side);
      front.push_back(next);
    }
  }
}

/// The triangles of a polygon, turned as it is.
std::vector<std::vector<int>> triangles_of(const std::vector<Vec3>& points, const std::vector<int>& polygon) {
  const Vec3 normal = area_normal(points, polygon);
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  Triangulation triangulation;
  std::map<int, Triangulation::Vertex_handle> vertices;
  for (const int corner : polygon) {
    const Vec3& p = points[n(corner)];
    const auto vertex = triangulation.insert({p[(axis + 1) % 3], p[(axis + 2) % 3]});
    vertex->info() = corner;
    vertices[corner] = vertex;
  }
  for (const auto& [a, b] : outline_edges(polygon))
    if (vertices[a] != vertices[b]) triangulation.insert_constraint(vertices[a], vertices[b]);
  if (triangulation.dimension() < 2) return {};
  mark_inside(triangulation);
  std::vector<std::vector<int>> triangles;
  for (const FaceHandle face : triangulation.finite_face_handles()) {
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
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
      throw std::invalid_argument(fmt::format(
          "the polygon of {} corners that begins {} {} crosses itself; cut it into simple polygons",
          polygon.size(), text_of(soup.points[n(polygon[0])]), text_of(soup.points[n(polygon[1])])));
    }
  }
  return result;
}

}  // namespace etendue
