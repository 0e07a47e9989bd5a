// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/polyhedra/match_faces.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "base/errors.h"
#include "base/position.h"

namespace etendue {
namespace {

std::span<const int> polygon(const Polygons& polygons, const std::vector<int>& points, std::size_t p) {
  const std::size_t begin = p == 0 ? 0 : position(polygons.ends[p - 1]);
  return std::span(points).subspan(begin, position(polygons.ends[p]) - begin);
}

/// The points of each polygon, rising.
std::vector<int> rising_points(const Polygons& polygons) {
  std::vector<int> points = polygons.points;
  std::size_t begin = 0;
  for (const int end : polygons.ends) {
    std::sort(points.begin() + static_cast<std::ptrdiff_t>(begin), points.begin() + end);
    begin = position(end);
  }
  return points;
}

class FaceMatching {
 public:
  FaceMatching(const Polygons& of_cells, PolyhedralMesh& mesh)
      : of_cells_(of_cells), mesh_(mesh), rising_(rising_points(of_cells)), order_(of_cells.ends.size()) {
    for (std::size_t p = 0; p < order_.size(); ++p) order_[p] = p;
    std::ranges::sort(order_, [&](std::size_t a, std::size_t b) {
      const auto sign = compare(key(a), key(b));
      return sign != 0 ? sign < 0 : a < b;
    });
  }

  void match() {
    std::vector<int> twins(order_.size(), -1);
    std::vector<char> is_second(order_.size(), 0);
    for (std::size_t i = 1; i < order_.size(); ++i) {
      if (compare(key(order_[i - 1]), key(order_[i])) != 0) continue;
      if (is_second[order_[i - 1]] != 0)
        fail(order_[i], "belongs to cells " + std::to_string(of_cells_.owners[order_[i - 2]]) + ", " +
                            std::to_string(of_cells_.owners[order_[i - 1]]) + " and " +
                            std::to_string(of_cells_.owners[order_[i]]) + "; cells overlap");
      twins[order_[i - 1]] = static_cast<int>(order_[i]);
      is_second[order_[i]] = 1;
    }
    face_of_polygon_.assign(order_.size(), -1);
    for (std::size_t p = 0; p < order_.size(); ++p)
      if (is_second[p] == 0) add_face(p, twins[p]);
  }

  void name(const Polygons& of_walls) {
    const std::vector<int> rising = rising_points(of_walls);
    for (std::size_t w = 0; w < of_walls.ends.size(); ++w) {
      const std::span<const int> wanted = polygon(of_walls, rising, w);
      const auto found = std::ranges::lower_bound(
          order_, wanted, [](auto a, auto b) { return compare(a, b) < 0; },
          [&](std::size_t p) { return key(p); });
      if (found == order_.end() || compare(key(*found), wanted) != 0)
        throw InputError(Fault{mesh_.file, 0,
                               "polygon" + names(wanted) + " of wall \"" +
                                   mesh_.wall_names[position(of_walls.owners[w])] +
                                   "\" is no face of a cell; walls must be faces of the mesh"});
      int& wall = mesh_.face_walls[position(face_of_polygon_[*found])];
      if (wall >= 0 && wall != of_walls.owners[w])
        throw InputError(Fault{
            mesh_.file, 0,
            "polygon" + names(wanted) + " belongs to both walls \"" + mesh_.wall_names[position(wall)] +
                "\" and \"" + mesh_.wall_names[position(of_walls.owners[w])] + "\"; a face has one wall"});
      wall = of_walls.owners[w];
    }
  }

 private:
  static int compare(std::span<const int> a, std::span<const int> b) {
    if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
    const auto [at_a, at_b] = std::ranges::mismatch(a, b);
    if (at_a == a.end()) return 0;
    return *at_a < *at_b ? -1 : 1;
  }

  static std::string names(std::span<const int> points) {
    std::string text = " of points";
    for (const int point : points) text += " " + std::to_string(point);
    return text;
  }

  std::span<const int> key(std::size_t p) const { return polygon(of_cells_, rising_, p); }

  [[noreturn]] void fail(std::size_t p, const std::string& problem) const {
    throw InputError(Fault{mesh_.file, 0, "face" + names(key(p)) + ": " + problem});
  }

  void add_face(std::size_t p, int twin) {
    face_of_polygon_[p] = static_cast<int>(mesh_.face_ends.size());
    const std::span<const int> points = polygon(of_cells_, of_cells_.points, p);
    mesh_.face_points.insert(mesh_.face_points.end(), points.begin(), points.end());
    mesh_.face_ends.push_back(static_cast<int>(mesh_.face_points.size()));
    mesh_.owners.push_back(of_cells_.owners[p]);
    mesh_.neighbors.push_back(twin < 0 ? -1 : of_cells_.owners[position(twin)]);
    mesh_.face_walls.push_back(-1);
  }

  const Polygons& of_cells_;
  PolyhedralMesh& mesh_;
  std::vector<int> rising_;
  std::vector<std::size_t> order_;    ///< polygons of cells by their rising points
  std::vector<int> face_of_polygon_;  ///< -1: of the second cell of a face
};

/// Turns faces whose normals point into their owners.
void turn_outward(PolyhedralMesh& mesh) {
  std::vector<Vec3> sums(mesh.cell_count(), Vec3::Zero());
  std::vector<int> counts(mesh.cell_count(), 0);
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    for (const int cell : {mesh.owners[f], mesh.neighbors[f]}) {
      if (cell < 0) continue;
      for (const int point : mesh.face(f)) sums[position(cell)] += mesh.points[position(point)];
      counts[position(cell)] += static_cast<int>(mesh.face(f).size());
    }
  std::size_t begin = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const std::span<const int> face = mesh.face(f);
    const std::size_t owner = position(mesh.owners[f]);
    const Vec3 inside = sums[owner] / counts[owner];
    double six_volumes = 0;
    const Vec3 first = mesh.points[position(face.front())] - inside;
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      six_volumes += first.cross(mesh.points[position(face[i])] - inside)
                         .dot(mesh.points[position(face[i + 1])] - inside);
    const std::size_t end = position(mesh.face_ends[f]);
    if (six_volumes < 0)
      std::reverse(mesh.face_points.begin() + static_cast<std::ptrdiff_t>(begin),
                   mesh.face_points.begin() + static_cast<std::ptrdiff_t>(end));
    begin = end;
  }
}

}  // namespace

void match_faces(const Polygons& of_cells, const Polygons& of_walls, PolyhedralMesh& mesh) {
  FaceMatching matching(of_cells, mesh);
  matching.match();
  matching.name(of_walls);
  turn_outward(mesh);
}

}  // namespace etendue
