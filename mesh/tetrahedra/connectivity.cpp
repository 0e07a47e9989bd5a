// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/connectivity.h"

#include <algorithm>
#include <utility>

#include "base/position.h"
#include "mesh/tetrahedra/mesh_faults.h"
#include "mesh/tetrahedra/sheet_faces.h"

namespace etendue {
namespace {

/// One cell's view of one of its faces; `slot` is 4 cell + local face.
struct FaceSide {
  std::array<std::int32_t, 3> vertices;
  std::int32_t slot;
  auto operator<=>(const FaceSide&) const = default;
};

std::array<std::int32_t, 3> opposite_face(const std::array<std::int32_t, 4>& v, std::int32_t local) {
  switch (local) {
    case 0:
      return {v[1], v[2], v[3]};
    case 1:
      return {v[0], v[2], v[3]};
    case 2:
      return {v[0], v[1], v[3]};
    default:
      return {v[0], v[1], v[2]};
  }
}

/// +1 where the rising order of a face's vertices turns around its outward normal. In a positively oriented
/// cell the outward faces are (1 2 3), (0 3 2), (0 1 3) and (0 2 1).
std::int8_t outward(const SortedCells& cells, std::int32_t slot) {
  const std::int8_t cell = cells.orientation[position(slot / 4)];
  return static_cast<std::int8_t>(slot % 2 == 0 ? cell : -cell);
}

std::vector<FaceSide> sorted_sides(const SortedCells& cells) {
  std::vector<FaceSide> sides;
  sides.reserve(4 * cells.vertices.size());
  for (std::size_t c = 0; c < cells.vertices.size(); ++c)
    for (std::int32_t local = 0; local < 4; ++local)
      sides.push_back({opposite_face(cells.vertices[c], local), static_cast<std::int32_t>(4 * c) + local});
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// Adds what is wrong with the cells [first, last) that share one face.
void check_sharing(std::span<const FaceSide> sharing, const SortedCells& cells,
                   const MeshNumbering& numbering, MeshFaults& faults) {
  const bool overlap =
      sharing.size() == 2 && outward(cells, sharing[0].slot) == outward(cells, sharing[1].slot);
  if (sharing.size() <= 2 && !overlap) return;
  std::array<std::int32_t, 3> points{};
  for (std::size_t i = 0; i < 3; ++i) points[i] = numbering.vertices[position(sharing[0].vertices[i])];
  std::vector<int> names;
  for (const FaceSide& side : sharing) names.push_back(numbering.cells[position(side.slot / 4)]);
  if (overlap)
    faults.add_face(points, names, "both cells lie on the same side of it (they overlap)",
                    "remove one or check node order");
  else
    faults.add_face(points, names, "shared by " + std::to_string(sharing.size()) + " cells",
                    "a face has at most two; remove duplicate cells");
}

/// [slot] the slot on the other side of the face, or -1.
std::vector<std::int32_t> match_sides(const SortedCells& cells, const MeshNumbering& numbering,
                                      const RawMesh& raw) {
  const std::vector<FaceSide> sides = sorted_sides(cells);
  const std::vector<std::array<std::int32_t, 3>> sheets = sheet_faces(numbering, raw);
  std::vector<std::int32_t> other(sides.size(), -1);
  MeshFaults faults(raw);
  for (auto first = sides.begin(); first != sides.end();) {
    const auto last =
        std::find_if(first, sides.end(), [&](const FaceSide& s) { return s.vertices != first->vertices; });
    check_sharing({first, last}, cells, numbering, faults);
    if (last - first == 2 && !std::binary_search(sheets.begin(), sheets.end(), first->vertices)) {
      other[position(first[0].slot)] = first[1].slot;
      other[position(first[1].slot)] = first[0].slot;
    }
    first = last;
  }
  faults.throw_if_any();
  return other;
}

void add_face(MeshFaces& faces, const SortedCells& cells, std::int32_t slot, std::int32_t other_slot) {
  const auto face = static_cast<std::int32_t>(faces.vertices.size());
  const std::int32_t owner = slot / 4;
  faces.vertices.push_back(opposite_face(cells.vertices[position(owner)], slot % 4));
  faces.cells.push_back({owner, other_slot < 0 ? -1 : other_slot / 4});
  faces.orientation.push_back(outward(cells, slot));
  faces.of_cell[position(owner)][position(slot % 4)] = face;
  if (other_slot >= 0) faces.of_cell[position(other_slot / 4)][position(other_slot % 4)] = face;
}

}  // namespace

SortedCells sort_vertices(std::span<const std::array<std::int32_t, 4>> oriented_cells) {
  SortedCells sorted{{oriented_cells.begin(), oriented_cells.end()}, {}};
  sorted.orientation.reserve(oriented_cells.size());
  for (auto& v : sorted.vertices) {
    // Each exchange of two vertices turns the cell inside out; this network sorts four.
    std::int8_t orientation = 1;
    for (const auto& [i, j] : {std::pair{0u, 1u}, {2u, 3u}, {0u, 2u}, {1u, 3u}, {1u, 2u}})
      if (v[i] > v[j]) {
        std::swap(v[i], v[j]);
        orientation = static_cast<std::int8_t>(-orientation);
      }
    sorted.orientation.push_back(orientation);
  }
  return sorted;
}

MeshFaces connect_faces(const SortedCells& cells, const MeshNumbering& numbering, const RawMesh& raw) {
  const std::vector<std::int32_t> other = match_sides(cells, numbering, raw);
  MeshFaces faces;
  faces.of_cell.resize(cells.vertices.size());
  const auto slots = static_cast<std::int32_t>(other.size());
  for (std::int32_t slot = 0; slot < slots; ++slot)
    if (other[position(slot)] < 0) add_face(faces, cells, slot, -1);
  faces.boundary_count = static_cast<std::int32_t>(faces.vertices.size());
  for (std::int32_t slot = 0; slot < slots; ++slot)
    if (other[position(slot)] > slot) add_face(faces, cells, slot, other[position(slot)]);
  return faces;
}

}  // namespace etendue
