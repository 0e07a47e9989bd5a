// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/polyhedra/cell_shape.h"

#include <algorithm>
#include <array>

#include "base/position.h"

namespace etendue {
namespace {

bool has_point(const std::vector<int>& points, int wanted) { return std::ranges::count(points, wanted) > 0; }

/// The one point of a face beside `from` that is not of the base; -1: there is not one.
int point_above(const std::vector<int>& face, int from, const std::vector<int>& base) {
  const std::size_t i = position(static_cast<int>(std::ranges::find(face, from) - face.begin()));
  const int after = face[(i + 1) % face.size()], before = face[(i + face.size() - 1) % face.size()];
  if (has_point(base, after) == has_point(base, before)) return -1;
  return has_point(base, after) ? before : after;
}

/// How many faces have so many points.
std::size_t faces_with(std::size_t points, const std::vector<std::vector<int>>& faces) {
  return static_cast<std::size_t>(
      std::ranges::count_if(faces, [&](const std::vector<int>& face) { return face.size() == points; }));
}

CellShape pyramid_on(std::size_t base, const std::vector<std::vector<int>>& faces) {
  CellShape shape{CellKind::pyramid, faces[base]};
  std::ranges::reverse(shape.points);
  for (const int point : faces[base == 0 ? 1 : 0])
    if (!has_point(faces[base], point)) shape.points.push_back(point);
  if (shape.points.size() != faces[base].size() + 1) return {};
  return shape;
}

CellShape prism_on(std::size_t base, const std::vector<std::vector<int>>& faces) {
  CellShape shape{CellKind::prism, faces[base]};
  std::ranges::reverse(shape.points);
  for (std::size_t i = 0; i < faces[base].size(); ++i) {
    const int below = shape.points[i];
    int above = -1;
    for (std::size_t f = 0; f < faces.size(); ++f)
      if (f != base && above < 0 && has_point(faces[f], below))
        above = point_above(faces[f], below, faces[base]);
    if (above < 0 || has_point(shape.points, above)) return {};
    shape.points.push_back(above);
  }
  const std::size_t size = faces[base].size();
  const auto has_face = [&](std::vector<int> points) {
    return std::ranges::any_of(
        faces, [&](const std::vector<int>& face) { return std::ranges::is_permutation(face, points); });
  };
  if (!has_face({shape.points.begin() + static_cast<std::ptrdiff_t>(size), shape.points.end()})) return {};
  for (std::size_t i = 0; i < size; ++i)
    if (const std::size_t k = (i + 1) % size;
        !has_face({shape.points[i], shape.points[k], shape.points[size + k], shape.points[size + i]}))
      return {};
  return shape;
}

}  // namespace

CellShape shape_of_cell(const PolyhedralMesh& mesh, std::span<const FaceOfCell> faces_of_cell) {
  std::vector<std::vector<int>> faces;
  std::vector<int> points;
  for (const FaceOfCell& face : faces_of_cell) {
    faces.push_back(outward_points(mesh, face));
    points.insert(points.end(), faces.back().begin(), faces.back().end());
  }
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const std::size_t triangles = faces_with(3, faces), quads = faces_with(4, faces);
  const auto base_of = [&](std::size_t size) {
    return static_cast<std::size_t>(
        std::ranges::find_if(faces, [&](const auto& face) { return face.size() == size; }) - faces.begin());
  };
  const std::array<std::size_t, 3> counts = {triangles, quads, faces.size()};
  if (counts == std::array<std::size_t, 3>{4, 0, 4} && points.size() == 4)
    return pyramid_on(base_of(3), faces);
  if (counts == std::array<std::size_t, 3>{4, 1, 5} && points.size() == 5)
    return pyramid_on(base_of(4), faces);
  if (counts == std::array<std::size_t, 3>{2, 3, 5} && points.size() == 6) return prism_on(base_of(3), faces);
  if (counts == std::array<std::size_t, 3>{0, 6, 6} && points.size() == 8) return prism_on(base_of(4), faces);
  return {};
}

}  // namespace etendue
