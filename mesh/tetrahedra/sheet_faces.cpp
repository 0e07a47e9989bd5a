// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/sheet_faces.h"

#include <algorithm>
#include <utility>

#include "base/position.h"

namespace etendue {
namespace {}  // namespace

int turn_of(const std::array<std::int32_t, 3>& v) {
  const int inversions = (v[0] > v[1]) + (v[0] > v[2]) + (v[1] > v[2]);
  return inversions % 2 == 0 ? 1 : -1;
}

std::vector<std::int32_t> vertex_of_point(const MeshNumbering& numbering, const RawMesh& raw) {
  std::vector<std::int32_t> vertex(raw.points.size(), -1);
  for (std::size_t v = 0; v < numbering.vertices.size(); ++v)
    vertex[position(numbering.vertices[v])] = static_cast<std::int32_t>(v);
  return vertex;
}

std::vector<std::array<std::int32_t, 3>> sheet_faces(const MeshNumbering& numbering, const RawMesh& raw) {
  const std::vector<std::int32_t> vertex = vertex_of_point(numbering, raw);
  std::vector<std::pair<std::array<std::int32_t, 3>, int>> sides;  // rising vertices, turn
  sides.reserve(raw.triangles.size());
  for (const auto& [a, b, c] : raw.triangles) {
    std::array<std::int32_t, 3> v{vertex[position(a)], vertex[position(b)], vertex[position(c)]};
    const int turn = turn_of(v);
    std::sort(v.begin(), v.end());
    sides.emplace_back(v, turn);
  }
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  std::vector<std::array<std::int32_t, 3>> sheets;
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i].first == sides[i - 1].first) sheets.push_back(sides[i].first);
  return sheets;
}

std::vector<std::int32_t> vertices_of_sheets(const TetrahedralMesh& mesh) {
  const auto faces = mesh.face_vertices().first(static_cast<std::size_t>(mesh.boundary_face_count()));
  std::vector<std::array<std::int32_t, 3>> sorted(faces.begin(), faces.end());
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::int32_t> vertices;
  for (std::size_t f = 1; f < sorted.size(); ++f)
    if (sorted[f] == sorted[f - 1]) vertices.insert(vertices.end(), sorted[f].begin(), sorted[f].end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

std::vector<std::int32_t> faces_behind(const TetrahedralMesh& mesh) {
  std::vector<std::pair<std::array<std::int32_t, 3>, std::int32_t>> sorted;  // vertices, face
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    sorted.emplace_back(mesh.vertices(FaceIndex(f)), f);
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::int32_t> behind(sorted.size(), -1);
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i].first == sorted[i - 1].first) {
      behind[position(sorted[i].second)] = sorted[i - 1].second;
      behind[position(sorted[i - 1].second)] = sorted[i].second;
    }
  return behind;
}

}  // namespace etendue
