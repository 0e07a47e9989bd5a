// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Dense>

#include "base/field_data.h"
#include "base/vec3.h"

namespace etendue {

/// A field on a regular grid: trilinear where the values are those of the points, else constant in each
/// voxel. The first index is the fastest.
class ImageField {
 public:
  ImageField(ImageGrid grid, FieldValues on, std::vector<double> values);

  /// Empty outside, to within 1e-9 of the field's size.
  std::optional<double> at(const Vec3& point) const;
  /// The shortest step [length].
  double cell_length() const { return grid_.steps.colwise().norm().minCoeff(); }

 private:
  ImageGrid grid_;
  FieldValues on_;
  std::vector<double> values_;
  Eigen::Matrix3d inverse_;
};

}  // namespace etendue
