// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/wall_names.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/position.h"
#include "mesh/tetrahedra/mesh_faults.h"
#include "mesh/tetrahedra/sheet_faces.h"

namespace etendue {
namespace {

constexpr std::int32_t kUnnamed = -1;

/// Finds faces by their vertices.
class FaceLookup {
 public:
  explicit FaceLookup(const MeshFaces& faces) : orientation_(faces.orientation) {
    for (std::size_t f = 0; f < faces.vertices.size(); ++f)
      faces_.emplace_back(faces.vertices[f], static_cast<std::int32_t>(f));
    std::sort(faces_.begin(), faces_.end());
  }

  /// -1 where there is none. Of the two faces of a sheet the one whose normal the triangle has.
  std::int32_t find(std::array<std::int32_t, 3> vertices) const {
    const int turn = turn_of(vertices);
    std::sort(vertices.begin(), vertices.end());
    const auto found = std::lower_bound(faces_.begin(), faces_.end(), std::make_pair(vertices, kUnnamed));
    if (found == faces_.end() || found->first != vertices) return -1;
    const auto twin = found + 1;
    const bool is_sheet = twin != faces_.end() && twin->first == vertices;
    return is_sheet && orientation_[position(found->second)] != turn ? twin->second : found->second;
  }

 private:
  const std::vector<std::int8_t>& orientation_;
  std::vector<std::pair<std::array<std::int32_t, 3>, std::int32_t>> faces_;
};

void check_all_named(const std::vector<std::int32_t>& triangles, const MeshFaces& faces,
                     const MeshNumbering& numbering, const RawMesh& raw) {
  MeshFaults faults(raw);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    if (triangles[f] != kUnnamed) continue;
    std::array<std::int32_t, 3> points = faces.vertices[f];
    for (auto& point : points) point = numbering.vertices[position(point)];
    faults.add_face(points, {numbering.cells[position(faces.cells[f][0])]},
                    "boundary face has no wall name although others have one",
                    "name every boundary face, or none");
  }
  faults.throw_if_any();
}

}  // namespace

std::vector<std::int32_t> boundary_triangles(const MeshFaces& faces, const MeshNumbering& numbering,
                                             const RawMesh& raw) {
  std::vector<std::int32_t> triangles(position(faces.boundary_count), kUnnamed);
  const FaceLookup lookup(faces);
  const std::vector<std::int32_t> vertex = vertex_of_point(numbering, raw);
  MeshFaults faults(raw);
  for (std::size_t t = 0; t < raw.triangles.size(); ++t) {
    const auto& [a, b, c] = raw.triangles[t];
    const std::int32_t face = lookup.find({vertex[position(a)], vertex[position(b)], vertex[position(c)]});
    const std::string& name = raw.wall_names[position(raw.triangle_walls[t])];
    if (face < 0) {
      faults.add_face(raw.triangles[t], {}, "triangle of wall \"" + name + "\" is no face of a tetrahedron",
                      "walls must be faces of the mesh");
    } else if (face < faces.boundary_count) {
      std::int32_t& triangle = triangles[position(face)];
      const std::string& other =
          triangle == kUnnamed ? name : raw.wall_names[position(raw.triangle_walls[position(triangle)])];
      if (other != name)
        faults.add_face(raw.triangles[t], {numbering.cells[position(faces.cells[position(face)][0])]},
                        "belongs to both walls \"" + other + "\" and \"" + name + "\"",
                        "a face has one wall");
      triangle = static_cast<std::int32_t>(t);
    }
  }
  faults.throw_if_any();
  return triangles;
}

NamedParts used_names(std::vector<std::int32_t> parts, const std::vector<std::string>& names) {
  std::vector<char> used(names.size(), 0);
  for (const std::int32_t part : parts) used[position(part)] = 1;
  NamedParts named{std::move(parts), {}};
  std::map<std::string, std::int32_t> number;
  std::vector<std::int32_t> renumbered(names.size(), 0);
  for (std::size_t n = 0; n < names.size(); ++n) {
    if (!used[n]) continue;
    const auto [entry, is_new] = number.emplace(names[n], static_cast<std::int32_t>(number.size()));
    if (is_new) named.names.push_back(names[n]);
    renumbered[n] = entry->second;
  }
  for (std::int32_t& part : named.parts) part = renumbered[position(part)];
  return named;
}

NamedParts name_walls(const std::vector<std::int32_t>& triangles, const MeshFaces& faces,
                      const MeshNumbering& numbering, const RawMesh& raw) {
  if (std::ranges::all_of(triangles, [](std::int32_t triangle) { return triangle == kUnnamed; }))
    return {std::vector<std::int32_t>(triangles.size(), 0), {"boundary"}};
  check_all_named(triangles, faces, numbering, raw);
  std::vector<std::int32_t> walls;
  walls.reserve(triangles.size());
  for (const std::int32_t triangle : triangles) walls.push_back(raw.triangle_walls[position(triangle)]);
  return used_names(std::move(walls), raw.wall_names);
}

}  // namespace etendue
