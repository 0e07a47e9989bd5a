// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// Parallel light falls through a tetrahedron in columns: the light that enters by one face and leaves by
/// another, so that the path length is linear between the three corners of a column.
struct Column {
  std::array<Vec3, 3> entry;     ///< corners, on the face by which light comes in
  std::array<double, 3> length;  ///< of the path from each to the face by which it goes out

  /// As light of a unit direction sees it.
  double cross_section(const Vec3& direction) const;
  /// What of it begins in a part of its entry.
  Column over(const std::array<Vec3, 3>& part) const;
  /// Four parts of equal cross section.
  std::array<Column, 4> quarters() const;
};

/// The columns of a tetrahedron along a unit direction. Faces along it, to 1e-10 of the size, take no light.
std::vector<Column> columns_of(const std::array<Vec3, 4>& vertices, const Vec3& direction);

}  // namespace etendue
