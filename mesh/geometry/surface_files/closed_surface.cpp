// SPDX-License-Identifier: AGPL-3.0-or-later
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "base/array_bytes.h"
#include "base/position.h"
#include "mesh/geometry/primitives/primitive_checks.h"
#include "mesh/geometry/surface_files/bounded_child.h"
#include "mesh/geometry/surface_files/polygon_soup.h"
#include "mesh/geometry/surface_files/simple_polygons.h"

namespace etendue {
namespace {

namespace Processing = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = Mesh::Face_index;
using Halfedge = Mesh::Halfedge_index;
using Walls = Mesh::Property_map<Face, int>;
using Place = std::array<double, 3>;

std::string text_of(const Kernel::Point_3& p) { return etendue::text_of(Vec3(p.x(), p.y(), p.z())); }

[[noreturn]] void refuse(const std::string& problem) { throw std::invalid_argument(problem); }

/// Triangles inherit the wall of the polygon that they are cut from.
struct WallKeeper : Processing::Triangulate_faces::Default_visitor<Mesh> {
  explicit WallKeeper(Walls map) : walls(map) {}
  void before_subface_creations(Face face) { wall = walls[face]; }
  void after_subface_created(Face face) { walls[face] = wall; }
  Walls walls;
  int wall = 0;
};

/// Points with equal coordinates become one; polygons that this leaves without three corners go.
PolygonSoup joined(const PolygonSoup& soup) {
  PolygonSoup result;
  std::map<std::array<double, 3>, int> numbers;
  std::vector<int> number(soup.points.size());
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    const Vec3& p = soup.points[i];
    const auto [entry, added] =
        numbers.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(result.points.size()));
    if (added) result.points.push_back(p);
    number[i] = entry->second;
  }
  for (std::size_t i = 0; i < soup.polygons.size(); ++i) {
    std::vector<int> polygon;
    for (const int corner : soup.polygons[i])
      if (polygon.empty() || polygon.back() != number[position(corner)])
        polygon.push_back(number[position(corner)]);
    if (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
    if (polygon.size() < 3) continue;
    result.polygons.push_back(std::move(polygon));
    result.walls.push_back(soup.walls[i]);
  }
  return result;
}

void refuse_crowded_edges(const PolygonSoup& soup) {
  std::map<std::array<int, 2>, int> polygons;
  for (const std::vector<int>& polygon : soup.polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const int a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      ++polygons[{std::min(a, b), std::max(a, b)}];
    }
  for (const auto& [edge, count] : polygons)
    if (count > 2)
      refuse(
          fmt::format("{} polygons meet in the edge from {} to {} (a closed surface has two at each edge); "
                      "remove double or inner faces",
                      count, etendue::text_of(soup.points[position(edge[0])]),
                      etendue::text_of(soup.points[position(edge[1])])));
}

Mesh oriented_mesh(const PolygonSoup& soup) {
  std::vector<Kernel::Point_3> points;
  for (const Vec3& p : soup.points) points.emplace_back(p.x(), p.y(), p.z());
  std::vector<std::vector<std::size_t>> polygons;
  for (const std::vector<int>& polygon : soup.polygons) polygons.emplace_back(polygon.begin(), polygon.end());
  // Points where surfaces only touch are doubled; the search for self-intersections finds them.
  Processing::orient_polygon_soup(points, polygons);
  if (!Processing::is_polygon_soup_a_polygon_mesh(polygons))
    refuse(
        "the polygons cannot be turned to face one way (the surface has one side only, like a Moebius band)");
  Mesh mesh;
  Processing::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  return mesh;
}

void refuse_holes(const Mesh& mesh) {
  std::vector<Halfedge> cycles;
  Processing::extract_boundary_cycles(mesh, std::back_inserter(cycles));
  if (cycles.empty()) return;
  const Halfedge edge = cycles.front();
  const Kernel::Point_3 &from = mesh.point(mesh.source(edge)), &to = mesh.point(mesh.target(edge));
  refuse(fmt::format(
      "the surface is not closed: it has {} hole{} (one with an edge from {} to {}, {:.6g} around); "
      "close it",
      cycles.size(), cycles.size() == 1 ? "" : "s", text_of(from), text_of(to),
      Processing::face_border_length(edge, mesh)));
}

std::string corners_text(const Mesh& mesh, Face face) {
  std::string text;
  for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(face)))
    text += (text.empty() ? "" : " ") + text_of(mesh.point(v));
  return text;
}

void refuse_flat_triangles(const Mesh& mesh) {
  for (const Face face : mesh.faces())
    if (Processing::is_degenerate_triangle_face(face, mesh))
      refuse(fmt::format("the triangle {} has no area; remove it and join its neighbours",
                         corners_text(mesh, face)));
}

void refuse_self_intersections(const Mesh& mesh) {
  constexpr std::size_t kShown = 3;
  std::vector<std::pair<Face, Face>> pairs;
  Processing::self_intersections(mesh, std::back_inserter(pairs));
  if (pairs.empty()) return;
  std::string text = fmt::format("the surface cuts or touches itself in {} pair{} of triangles", pairs.size(),
                                 pairs.size() == 1 ? "" : "s");
  for (std::size_t i = 0; i < std::min(kShown, pairs.size()); ++i)
    text += fmt::format("{} {} with {}", i == 0 ? ":" : ";", corners_text(mesh, pairs[i].first),
                        corners_text(mesh, pairs[i].second));
  if (pairs.size() > kShown) text += "; ...";
  refuse(text + "; part or unite what overlaps");
}

enum class Border { refused, allowed };

/// Runs in the child process: CGAL need not end on polygons that it was not made for.
void triangulate_to_file(const PolygonSoup& soup, Border border, std::FILE* file) {
  const PolygonSoup clean = with_simple_polygons(joined(soup));
  if (clean.polygons.empty()) refuse("has no polygons");
  refuse_crowded_edges(clean);
  Mesh mesh = oriented_mesh(clean);
  if (border == Border::refused) refuse_holes(mesh);
  Walls walls = mesh.add_property_map<Face, int>("f:wall", 0).first;
  for (const Face face : mesh.faces()) walls[face] = clean.walls[face];
  Processing::triangulate_faces(mesh, CGAL::parameters::visitor(WallKeeper(walls)));
  refuse_flat_triangles(mesh);
  refuse_self_intersections(mesh);

  std::vector<Place> points;
  for (const Mesh::Vertex_index v : mesh.vertices()) {
    const Kernel::Point_3& p = mesh.point(v);
    points.push_back({p.x(), p.y(), p.z()});
  }
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> wall_of;
  for (const Face face : mesh.faces()) {
    std::array<int, 3> corners{};
    std::size_t i = 0;
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(face)))
      corners[i++] = static_cast<int>(v);
    triangles.push_back(corners);
    wall_of.push_back(walls[face]);
  }
  write_array(file, points);
  write_array(file, triangles);
  write_array(file, wall_of);
}

ClosedSurface triangulated(const PolygonSoup& soup, Border border) {
  const std::string result =
      bytes_of_child("CGAL", limits_for_polygons(soup.polygons.size()),
                     [&](std::FILE* file) { triangulate_to_file(soup, border, file); });
  std::string_view bytes = result;
  ClosedSurface surface;
  for (const Place& p : take_array<Place>(bytes)) surface.points.emplace_back(p[0], p[1], p[2]);
  surface.triangles = take_array<std::array<int, 3>>(bytes);
  surface.walls = take_array<int>(bytes);
  return surface;
}

}  // namespace

ClosedSurface close_surface(const PolygonSoup& soup) { return triangulated(soup, Border::refused); }

OpenSurface open_surface(const PolygonSoup& soup) { return triangulated(soup, Border::allowed); }

}  // namespace etendue
