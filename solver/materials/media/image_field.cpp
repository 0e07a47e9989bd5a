// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/media/image_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace etendue {
namespace {

/// Points this part of the field's size outside still count as on its surface.
constexpr double part_of_size_outside = 1e-9;

}  // namespace

ImageField::ImageField(ImageGrid grid, FieldValues on, std::vector<double> values)
    : grid_(std::move(grid)), on_(on), values_(std::move(values)), inverse_(grid_.steps.inverse()) {}

std::optional<double> ImageField::at(const Vec3& point) const {
  const Vec3 place = inverse_ * (point - grid_.origin);
  std::array<int, 3> voxel{};
  std::array<double, 3> part{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int voxels = grid_.points[axis] - 1;
    const double along = place[static_cast<Eigen::Index>(axis)];
    if (!(along >= -part_of_size_outside * voxels && along <= (1 + part_of_size_outside) * voxels))
      return std::nullopt;
    voxel[axis] = std::clamp(static_cast<int>(along), 0, voxels - 1);
    part[axis] = std::clamp(along - voxel[axis], 0.0, 1.0);
  }
  const int less = on_ == FieldValues::on_cells ? 1 : 0;
  const auto value = [&](int i, int j, int k) {
    const auto row =
        static_cast<std::size_t>(voxel[2] + k) * static_cast<std::size_t>(grid_.points[1] - less) +
        static_cast<std::size_t>(voxel[1] + j);
    return values_[row * static_cast<std::size_t>(grid_.points[0] - less) +
                   static_cast<std::size_t>(voxel[0] + i)];
  };
  if (on_ == FieldValues::on_cells) return value(0, 0, 0);
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
    const double weight =
        (i ? part[0] : 1 - part[0]) * (j ? part[1] : 1 - part[1]) * (k ? part[2] : 1 - part[2]);
    if (weight > 0) sum += weight * value(i, j, k);
  }
  return sum;
}

}  // namespace etendue
