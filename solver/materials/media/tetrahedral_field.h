// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Dense>

#include "base/field_data.h"
#include "base/vec3.h"
#include "mesh/tetrahedra/box_grid.h"

namespace etendue {

/// A field on tetrahedra: linear in each where the values are those of the points, else constant. Faces are
/// shared by both sides; the tetrahedron of the lowest number has them.
class TetrahedralField {
 public:
  /// Every cell has four of the points, and `values` is as long as the points or the cells are.
  TetrahedralField(std::vector<Vec3> points, std::vector<std::array<int, 4>> cells, FieldValues on,
                   std::vector<double> values);

  /// Empty outside of all tetrahedra, to within 1e-9 of the field's size.
  std::optional<double> at(const Vec3& point) const;
  /// Length of the edge of a regular tetrahedron as large as that around the point [length]; infinite
  /// outside.
  double cell_length(const Vec3& point) const;

 private:
  struct Place {
    std::size_t cell;
    std::array<double, 4> barycentric;
  };
  std::optional<Place> find(const Vec3& point) const;

  /// Barycentric coordinates of a cell as linear functions: that of the last corner is 1 at `corner`, and
  /// those of the others grow with the rows of `gradients` [1/length].
  struct Coordinates {
    Vec3 corner;
    Eigen::Matrix3d gradients;
  };

  std::vector<std::array<int, 4>> cells_;
  std::vector<Coordinates> coordinates_;  ///< [cell]
  FieldValues on_;
  std::vector<double> values_;
  double tolerance_;  ///< [length]
  BoxGrid grid_;
};

}  // namespace etendue
