// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Dense>

#include "base/vec3.h"

namespace etendue {

/// Where the values of a field are known.
enum class FieldValues { on_points, on_cells };

/// A regular grid of points, which need not be aligned with the axes.
struct ImageGrid {
  Vec3 origin = Vec3::Zero();                           ///< of the first point [length]
  Eigen::Matrix3d steps = Eigen::Matrix3d::Identity();  ///< columns: from a point to the next [length]
  std::array<int, 3> points = {2, 2, 2};                ///< along each step; at least 2
};

/// One number for each point, or for each cell, of a regular grid or of tetrahedra.
struct FieldData {
  std::optional<ImageGrid> image;         ///< the first index is the fastest
  std::vector<Vec3> points;               ///< [length]; empty: an image
  std::vector<std::array<int, 4>> cells;  ///< tetrahedra by their points
  FieldValues on = FieldValues::on_cells;
  std::vector<double> values;
};

}  // namespace etendue
