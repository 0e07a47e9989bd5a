// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/closed_form/beam_columns.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/clipped_polygon.h"
#include "solver/uncollided/closed_form/triangle.h"

namespace etendue {
namespace {

/// Cosine with the direction below which a face lies along it.
constexpr double along_the_beam = 1e-10;

void append_common(const Triangle& entry, const Triangle& exit, const Vec3& exit_normal,
                   const Vec3& direction, std::vector<Column>& columns) {
  std::vector<Vec3> common(entry.begin(), entry.end());
  for (std::size_t i = 0; i < 3 && !common.empty(); ++i) {
    const Vec3& a = exit[i];
    Vec3 inwards = (exit[(i + 1) % 3] - a).cross(direction);
    if (inwards.dot(exit[(i + 2) % 3] - a) < 0) inwards = -inwards;
    common = clipped(common, inwards, a);
  }
  const auto path_length = [&](const Vec3& from) {
    return std::max(0.0, exit_normal.dot(exit[0] - from) / exit_normal.dot(direction));
  };
  for (std::size_t i = 2; i < common.size(); ++i) {
    const Triangle part{common[0], common[i - 1], common[i]};
    columns.push_back({part, {path_length(part[0]), path_length(part[1]), path_length(part[2])}});
  }
}

}  // namespace

double Column::cross_section(const Vec3& direction) const {
  return std::abs((entry[1] - entry[0]).cross(entry[2] - entry[0]).dot(direction)) / 2;
}

Column Column::over(const std::array<Vec3, 3>& part) const {
  const Vec3 first = entry[1] - entry[0], second = entry[2] - entry[0], across = first.cross(second);
  const double whole = across.squaredNorm();
  Column column{part, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 from = part[i] - entry[0];
    const double b = from.cross(second).dot(across) / whole, c = first.cross(from).dot(across) / whole;
    column.length[i] = std::max(0.0, (1 - b - c) * length[0] + b * length[1] + c * length[2]);
  }
  return column;
}

std::array<Column, 4> Column::quarters() const {
  Column middle;
  for (std::size_t i = 0; i < 3; ++i) {
    middle.entry[i] = (entry[(i + 1) % 3] + entry[(i + 2) % 3]) / 2;
    middle.length[i] = (length[(i + 1) % 3] + length[(i + 2) % 3]) / 2;
  }
  std::array<Column, 4> parts{middle, middle, middle, middle};
  for (std::size_t i = 0; i < 3; ++i) {
    parts[i].entry[i] = entry[i];
    parts[i].length[i] = length[i];
  }
  return parts;
}

std::vector<Column> columns_of(const std::array<Vec3, 4>& vertices, const Vec3& direction) {
  std::vector<Triangle> entries, exits;
  std::vector<Vec3> exit_normals;
  for (std::size_t k = 0; k < 4; ++k) {
    const Triangle face{vertices[(k + 1) % 4], vertices[(k + 2) % 4], vertices[(k + 3) % 4]};
    Vec3 normal = (face[1] - face[0]).cross(face[2] - face[0]).normalized();
    if (normal.dot(vertices[k] - face[0]) > 0) normal = -normal;
    const double cosine = normal.dot(direction);
    if (std::abs(cosine) <= along_the_beam) continue;
    if (cosine < 0) {
      entries.push_back(face);
    } else {
      exits.push_back(face);
      exit_normals.push_back(normal);
    }
  }
  std::vector<Column> columns;
  for (const Triangle& entry : entries)
    for (std::size_t i = 0; i < exits.size(); ++i)
      append_common(entry, exits[i], exit_normals[i], direction, columns);
  return columns;
}

}  // namespace etendue
