// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/cell_checks.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "base/position.h"
#include "mesh/tetrahedra/mesh_faults.h"

namespace etendue {
namespace {

/// Rounding of six times the volume, relative to the cube of the longest edge: a determinant of three
/// rounded differences (Shewchuk 1997, bound A of orient3d, is about 7 units of rounding).
constexpr double kVolumeRounding = 8 * std::numeric_limits<double>::epsilon();

/// Beyond this a volume may overflow.
constexpr double kLargestCoordinate = 1e100;

void check_array_sizes(const RawMesh& raw) {
  assert(raw.cell_regions.size() == raw.cells.size());
  assert(raw.triangle_walls.size() == raw.triangles.size());
  assert(raw.cell_lines.empty() || raw.cell_lines.size() == raw.cells.size());
  assert(raw.cell_numbers.empty() || raw.cell_numbers.size() == raw.cells.size());
  assert(raw.point_numbers.empty() || raw.point_numbers.size() == raw.points.size());
  // Faces are counted in 32 bits, four for each cell before they are matched.
  if (raw.cells.size() > std::numeric_limits<std::int32_t>::max() / 4)
    throw InputError(Fault{raw.file, 0, "too many cells: " + std::to_string(raw.cells.size())});
  if (raw.cells.empty())
    throw InputError(Fault{raw.file, 0, "no tetrahedra (a volume mesh is needed); mesh the volume"});
}

void check_indices(const RawMesh& raw) {
  const auto line = [&](std::size_t c) { return raw.cell_lines.empty() ? 0 : raw.cell_lines[c]; };
  const auto name = [&](std::size_t c) {
    return std::to_string(raw.cell_numbers.empty() ? static_cast<std::int64_t>(c) : raw.cell_numbers[c]);
  };
  const auto outside = [](int index, std::size_t size) { return index < 0 || position(index) >= size; };
  for (std::size_t c = 0; c < raw.cells.size(); ++c) {
    for (const int point : raw.cells[c])
      if (outside(point, raw.points.size()))
        throw InputError(Fault{raw.file, line(c),
                               "cell " + name(c) + ": point " + std::to_string(point) +
                                   " does not exist; there are " + std::to_string(raw.points.size())});
    if (outside(raw.cell_regions[c], raw.region_names.size()))
      throw InputError(Fault{raw.file, line(c), "cell " + name(c) + ": region does not exist"});
  }
  for (std::size_t t = 0; t < raw.triangles.size(); ++t) {
    for (const int point : raw.triangles[t])
      if (outside(point, raw.points.size()))
        throw InputError(Fault{raw.file, 0,
                               "triangle " + std::to_string(t) + ": point " + std::to_string(point) +
                                   " does not exist; there are " + std::to_string(raw.points.size())});
    if (outside(raw.triangle_walls[t], raw.wall_names.size()))
      throw InputError(Fault{raw.file, 0, "triangle " + std::to_string(t) + ": wall does not exist"});
  }
}

void check_coordinates(const RawMesh& raw) {
  MeshFaults faults(raw);
  for (std::size_t p = 0; p < raw.points.size(); ++p)
    if (!(raw.points[p].cwiseAbs().maxCoeff() < kLargestCoordinate) || !raw.points[p].allFinite())
      faults.add("point " + faults.point_name(static_cast<int>(p)) + ": coordinates " +
                 to_text(raw.points[p]) + " are not finite; use numbers below 1e100");
  faults.throw_if_any();
}

}  // namespace

SignedVolume signed_volume(const RawMesh& raw, const std::array<int, 4>& cell) {
  std::array<Vec3, 4> p;
  for (std::size_t i = 0; i < 4; ++i) p[i] = raw.points[position(cell[i])];
  double longest = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) longest = std::max(longest, (p[i] - p[j]).norm());
  const double determinant = (p[1] - p[0]).cross(p[2] - p[0]).dot(p[3] - p[0]);
  return {determinant, kVolumeRounding * longest * longest * longest};
}

void check_cells_and_points(const RawMesh& raw) {
  check_array_sizes(raw);
  check_indices(raw);
  check_coordinates(raw);
}

std::vector<std::array<std::int32_t, 4>> positively_oriented_cells(const RawMesh& raw) {
  std::vector<SignedVolume> volumes;
  volumes.reserve(raw.cells.size());
  for (const auto& cell : raw.cells) volumes.push_back(signed_volume(raw, cell));
  const auto negative =
      std::count_if(volumes.begin(), volumes.end(), [](const auto& v) { return v.six_volumes < 0; });
  // Some writers number the other way round: then all cells are negative. In a mixture some are inverted.
  const double sign = static_cast<std::size_t>(negative) == volumes.size() ? -1 : 1;

  MeshFaults faults(raw);
  for (std::size_t c = 0; c < volumes.size(); ++c)
    if (!(sign * volumes[c].six_volumes > volumes[c].rounding))
      faults.add_cell(static_cast<int>(c),
                      "volume " + to_text(sign * volumes[c].six_volumes / 6) + " is not positive",
                      std::abs(volumes[c].six_volumes) > volumes[c].rounding ? "check node order"
                                                                             : "remove the flat cell");
  faults.throw_if_any();

  std::vector<std::array<std::int32_t, 4>> cells(raw.cells.begin(), raw.cells.end());
  if (sign < 0)
    for (auto& cell : cells) std::swap(cell[2], cell[3]);
  return cells;
}

void check_points_differ(const RawMesh& raw) {
  std::vector<char> used(raw.points.size(), 0);
  for (const auto& cell : raw.cells)
    for (const int point : cell) used[position(point)] = 1;
  std::vector<int> order;
  for (std::size_t p = 0; p < raw.points.size(); ++p)
    if (used[p]) order.push_back(static_cast<int>(p));
  const auto key = [&](int p) {
    const Vec3& x = raw.points[position(p)];
    return std::array<double, 3>{x.x(), x.y(), x.z()};
  };
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return std::make_pair(key(a), a) < std::make_pair(key(b), b); });
  MeshFaults faults(raw);
  for (std::size_t i = 1; i < order.size(); ++i)
    if (key(order[i - 1]) == key(order[i]))
      faults.add("points " + faults.point_name(order[i - 1]) + " and " + faults.point_name(order[i]) +
                 " are both at " + to_text(raw.points[position(order[i])]) +
                 " (the cells around them are not connected); merge coincident points");
  faults.throw_if_any();
}

}  // namespace etendue
