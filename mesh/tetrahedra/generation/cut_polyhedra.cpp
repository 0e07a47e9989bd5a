// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/generation/cut_polyhedra.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "base/errors.h"
#include "base/position.h"
#include "mesh/polyhedra/faces_of_cells.h"
#include "mesh/tetrahedra/cell_checks.h"
#include "mesh/tetrahedra/mesh_faults.h"

namespace etendue {
namespace {

using Corners = std::array<int, 3>;

/// A triangle below this part of the area of its face counts as flat: its corners are on a line.
constexpr double kFlatTriangle = 1e-9;

/// A face as triangles, all turned as it is.
class FaceFan {
 public:
  FaceFan(std::span<const int> face, const std::vector<Vec3>& points) : face_(face), points_(points) {}

  void append_to(std::vector<Corners>& triangles) const {
    const std::size_t apex = face_.size() == 3 ? 0 : best_apex();
    for (std::size_t i = 1; i + 1 < face_.size(); ++i) triangles.push_back(triangle(apex, i));
  }

 private:
  Corners triangle(std::size_t apex, std::size_t i) const {
    const auto at = [&](std::size_t k) { return face_[(apex + k) % face_.size()]; };
    return {at(0), at(i), at(i + 1)};
  }

  Vec3 twice_area(const Corners& corners) const {
    const Vec3& a = points_[position(corners[0])];
    return (points_[position(corners[1])] - a).cross(points_[position(corners[2])] - a);
  }

  std::size_t best_apex() const {
    std::vector<std::size_t> order(face_.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return face_[a] < face_[b]; });
    Vec3 whole = Vec3::Zero();
    for (std::size_t i = 1; i + 1 < face_.size(); ++i) whole += twice_area(triangle(order.front(), i));
    const double least = kFlatTriangle * whole.squaredNorm();
    for (const std::size_t apex : order)
      if (all_above(apex, whole, least)) return apex;
    return order.front();
  }

  bool all_above(std::size_t apex, const Vec3& whole, double least) const {
    for (std::size_t i = 1; i + 1 < face_.size(); ++i)
      if (!(twice_area(triangle(apex, i)).dot(whole) > least)) return false;
    return true;
  }

  std::span<const int> face_;
  const std::vector<Vec3>& points_;
};

/// The first edge that two faces of a closed cell do not have in opposite directions.
std::optional<std::pair<int, int>> open_edge(const std::vector<std::pair<int, int>>& sorted_edges) {
  for (std::size_t i = 0; i < sorted_edges.size(); ++i) {
    const auto [from, to] = sorted_edges[i];
    if (i > 0 && sorted_edges[i - 1] == sorted_edges[i]) return sorted_edges[i];
    if (!std::binary_search(sorted_edges.begin(), sorted_edges.end(), std::pair(to, from)))
      return sorted_edges[i];
  }
  return std::nullopt;
}

class PolyhedraCutter {
 public:
  explicit PolyhedraCutter(std::shared_ptr<const PolyhedralMesh> mesh)
      : mesh_(*mesh), faces_of_cells_(*mesh), faults_(raw_) {
    raw_.points = mesh_.points;
    raw_.region_names = mesh_.region_names;
    raw_.wall_names = mesh_.wall_names;
    raw_.file = mesh_.file;
    raw_.parents.mesh = std::move(mesh);
  }

  RawMesh cut() && {
    check_points();
    cut_faces();
    check_size();
    for (std::size_t c = 0; c < mesh_.cell_count(); ++c) cut_cell(c);
    faults_.throw_if_any();
    raw_.cell_numbers.assign(raw_.parents.cells.begin(), raw_.parents.cells.end());
    return std::move(raw_);
  }

 private:
  void check_points() {
    for (std::size_t p = 0; p < mesh_.points.size(); ++p)
      if (!mesh_.points[p].allFinite())
        faults_.add("point " + std::to_string(p) + ": coordinates " + to_text(mesh_.points[p]) +
                    " are not finite");
    faults_.throw_if_any();
  }

  void cut_faces() {
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
      FaceFan(mesh_.face(f), mesh_.points).append_to(triangles_);
      triangle_ends_.push_back(triangles_.size());
      if (mesh_.face_walls[f] < 0) continue;
      for (const Corners& corners : triangles_of(static_cast<int>(f))) {
        raw_.triangles.push_back(corners);
        raw_.triangle_walls.push_back(mesh_.face_walls[f]);
        raw_.parents.faces.push_back(static_cast<std::int32_t>(f));
      }
    }
  }

  /// Numbers of cells and points have 32 bits.
  void check_size() const {
    constexpr auto most = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
    if (mesh_.points.size() + mesh_.cell_count() > most || 2 * triangles_.size() > most / 4)
      throw InputError(Fault{mesh_.file, 0,
                             "too many cells: " + std::to_string(mesh_.cell_count()) + " would become " +
                                 std::to_string(2 * triangles_.size()) + " tetrahedra"});
  }

  std::span<const Corners> triangles_of(int face) const {
    const std::size_t begin = face == 0 ? 0 : triangle_ends_[position(face) - 1];
    return std::span(triangles_).subspan(begin, triangle_ends_[position(face)] - begin);
  }

  /// The triangles around a cell, counterclockwise as seen from outside; the first of each face is counted.
  std::vector<Corners> surface_of(std::size_t cell) const {
    std::vector<Corners> surface;
    for (const FaceOfCell& face : faces_of_cells_.of(cell))
      for (Corners corners : triangles_of(face.face)) {
        if (!face.is_owner) std::swap(corners[1], corners[2]);
        surface.push_back(corners);
      }
    return surface;
  }

  std::vector<std::pair<int, int>> edges_of(std::size_t cell) const {
    std::vector<std::pair<int, int>> edges;
    for (const FaceOfCell& face : faces_of_cells_.of(cell)) {
      const std::vector<int> points = outward_points(mesh_, face);
      for (std::size_t i = 0; i < points.size(); ++i)
        edges.emplace_back(points[i], points[(i + 1) % points.size()]);
    }
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  Vec3 mean_of_points(const std::vector<std::pair<int, int>>& sorted_edges) const {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (std::size_t i = 0; i < sorted_edges.size(); ++i) {
      if (i > 0 && sorted_edges[i - 1].first == sorted_edges[i].first) continue;
      sum += mesh_.points[position(sorted_edges[i].first)];
      ++count;
    }
    return sum / count;
  }

  /// Centroid of the volume within a surface; `inside`, near it, where there is no volume.
  Vec3 centroid(const std::vector<Corners>& surface, const Vec3& inside) const {
    double six_volumes = 0;
    Vec3 moment = Vec3::Zero();
    for (const auto& [a, b, c] : surface) {
      const Vec3 to_a = mesh_.points[position(a)] - inside, to_b = mesh_.points[position(b)] - inside,
                 to_c = mesh_.points[position(c)] - inside;
      const double part = to_a.cross(to_b).dot(to_c);
      six_volumes += part;
      moment += part / 4 * (to_a + to_b + to_c);
    }
    return six_volumes > 0 ? Vec3(inside + moment / six_volumes) : inside;
  }

  void cut_cell(std::size_t cell) {
    const auto edges = edges_of(cell);
    if (edges.empty()) return faults_.add("cell " + std::to_string(cell) + ": has no face");
    const Vec3 middle = mean_of_points(edges);
    const std::string name = "cell " + std::to_string(cell) + " at " + to_text(middle);
    if (const auto open = open_edge(edges))
      return faults_.add(name + ": its faces do not enclose it (edge from point " +
                         std::to_string(open->first) + " to " + std::to_string(open->second) +
                         "); each edge needs two faces, turned outward");
    const std::vector<Corners> surface = surface_of(cell);
    if (surface.size() == 4)
      add_part(cell, opposite(surface), surface.front(), name);
    else
      add_parts(cell, surface, centroid(surface, middle), name);
  }

  /// The corner of a tetrahedron that its first triangle does not have.
  static int opposite(const std::vector<Corners>& surface) {
    for (const int point : surface[1])
      if (std::ranges::count(surface[0], point) == 0) return point;
    return surface[1][0];
  }

  void add_parts(std::size_t cell, const std::vector<Corners>& surface, const Vec3& center,
                 const std::string& name) {
    const auto apex = static_cast<int>(raw_.points.size());
    raw_.points.push_back(center);
    for (const Corners& corners : surface)
      if (!add_part(cell, apex, corners, name)) return;
  }

  /// Returns whether the part has a volume.
  bool add_part(std::size_t cell, int apex, const Corners& corners, const std::string& name) {
    const std::array<int, 4> part = {apex, corners[0], corners[1], corners[2]};
    const SignedVolume volume = signed_volume(raw_, part);
    if (!(volume.six_volumes > volume.rounding)) {
      faults_.add(name + ": the tetrahedron from its center to points " + std::to_string(corners[0]) + " " +
                  std::to_string(corners[1]) + " " + std::to_string(corners[2]) + " has the volume " +
                  to_text(volume.six_volumes / 6) +
                  ", which must be positive (the cell is warped, flat or not star-shaped); move its points "
                  "or split it");
      return false;
    }
    raw_.cells.push_back(part);
    raw_.cell_regions.push_back(mesh_.cell_regions[cell]);
    raw_.parents.cells.push_back(static_cast<std::int32_t>(cell));
    return true;
  }

  const PolyhedralMesh& mesh_;
  FacesOfCells faces_of_cells_;
  RawMesh raw_;
  MeshFaults faults_;
  std::vector<Corners> triangles_;          ///< of all faces, one face after the other
  std::vector<std::size_t> triangle_ends_;  ///< [face]
};

}  // namespace

RawMesh cut_polyhedra(std::shared_ptr<const PolyhedralMesh> mesh) {
  return PolyhedraCutter(std::move(mesh)).cut();
}

}  // namespace etendue
