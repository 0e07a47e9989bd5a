// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// Name of the wall of a boundary triangle, from its centroid and outward normal.
using WallNaming = std::function<std::string(const Vec3& centroid, const Vec3& outwards)>;

/// Blocks between rising coordinates, each in six tetrahedra around its diagonal (Kuhn 1960), so that
/// neighbours conform; `place` moves the points when all is joined. One region, "domain".
inline TetrahedralMesh block_mesh(
    const std::array<std::vector<double>, 3>& lines, const WallNaming& wall_name,
    const std::function<Vec3(const Vec3&)>& place = [](const Vec3& point) { return point; }) {
  RawMesh raw;
  raw.region_names = {"domain"};
  const auto size = [&](std::size_t axis) { return static_cast<int>(lines[axis].size()); };
  const auto vertex = [&](const std::array<int, 3>& at) {
    return (at[2] * size(1) + at[1]) * size(0) + at[0];
  };
  for (const double z : lines[2])
    for (const double y : lines[1])
      for (const double x : lines[0]) raw.points.push_back(place({x, y, z}));
  const auto add_wall = [&](const std::array<std::array<int, 3>, 3>& corners, const Vec3& inside) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int end : {0, size(axis) - 1}) {
        if (!std::all_of(corners.begin(), corners.end(), [&](const auto& c) { return c[axis] == end; }))
          continue;
        std::array<int, 3> triangle{};
        Vec3 centroid = Vec3::Zero();
        for (std::size_t i = 0; i < 3; ++i) {
          triangle[i] = vertex(corners[i]);
          centroid += raw.points[static_cast<std::size_t>(triangle[i])] / 3;
        }
        const auto& p = raw.points;
        const auto at = [&](std::size_t i) { return p[static_cast<std::size_t>(triangle[i])]; };
        Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
        if (normal.dot(inside - centroid) > 0) normal = -normal;
        const std::string name = wall_name(centroid, normal);
        auto found = std::find(raw.wall_names.begin(), raw.wall_names.end(), name);
        if (found == raw.wall_names.end()) found = raw.wall_names.insert(found, name);
        raw.triangles.push_back(triangle);
        raw.triangle_walls.push_back(static_cast<int>(found - raw.wall_names.begin()));
      }
  };
  std::array<int, 3> first{};
  for (first[2] = 0; first[2] + 1 < size(2); ++first[2])
    for (first[1] = 0; first[1] + 1 < size(1); ++first[1])
      for (first[0] = 0; first[0] + 1 < size(0); ++first[0]) {
        std::array<std::size_t, 3> axes = {0, 1, 2};
        do {
          std::array<std::array<int, 3>, 4> corners;
          corners[0] = first;
          for (std::size_t i = 0; i < 3; ++i) {
            corners[i + 1] = corners[i];
            ++corners[i + 1][axes[i]];
          }
          std::array<int, 4> cell{};
          Vec3 middle = Vec3::Zero();
          for (std::size_t i = 0; i < 4; ++i) {
            cell[i] = vertex(corners[i]);
            middle += raw.points[static_cast<std::size_t>(cell[i])] / 4;
          }
          const bool even = (axes[1] + 3 - axes[0]) % 3 == 1;
          if (!even) std::swap(cell[2], cell[3]);
          raw.cells.push_back(cell);
          raw.cell_regions.push_back(0);
          for (std::size_t skip = 0; skip < 4; ++skip) {
            std::array<std::array<int, 3>, 3> face;
            for (std::size_t i = 0, k = 0; i < 4; ++i)
              if (i != skip) face[k++] = corners[i];
            add_wall(face, middle);
          }
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
  return TetrahedralMesh(raw);
}

}  // namespace etendue
