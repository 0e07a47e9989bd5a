// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/media/tetrahedral_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace etendue {
namespace {

/// Points this part of the field's diagonal outside still count as on its surface.
constexpr double part_of_diagonal_outside = 1e-9;

double tolerance_of(const std::vector<Vec3>& points) {
  Box box;
  for (const Vec3& point : points) box.extend(point);
  return box.isEmpty() ? 0 : part_of_diagonal_outside * box.diagonal().norm();
}

std::vector<Box> boxes_of(const std::vector<Vec3>& points, const std::vector<std::array<int, 4>>& cells) {
  std::vector<Box> boxes(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (const int p : cells[c]) boxes[c].extend(points[static_cast<std::size_t>(p)]);
  return boxes;
}

}  // namespace

TetrahedralField::TetrahedralField(std::vector<Vec3> points, std::vector<std::array<int, 4>> cells,
                                   FieldValues on, std::vector<double> values)
    : cells_(std::move(cells)),
      on_(on),
      values_(std::move(values)),
      tolerance_(tolerance_of(points)),
      grid_(boxes_of(points, cells_), tolerance_) {
  coordinates_.reserve(cells_.size());
  for (const std::array<int, 4>& cell : cells_) {
    const auto corner = [&](std::size_t i) { return points[static_cast<std::size_t>(cell[i])]; };
    Eigen::Matrix3d edges;
    for (std::size_t i = 0; i < 3; ++i) edges.col(static_cast<Eigen::Index>(i)) = corner(i) - corner(3);
    // Of a cell without volume not finite: then it holds no point.
    coordinates_.push_back({corner(3), edges.inverse()});
  }
}

std::optional<TetrahedralField::Place> TetrahedralField::find(const Vec3& point) const {
  for (const std::int32_t candidate : grid_.candidates(point)) {
    Place place{static_cast<std::size_t>(candidate), {}};
    const Coordinates& coordinates = coordinates_[place.cell];
    const Vec3 first = coordinates.gradients * (point - coordinates.corner);
    place.barycentric = {first[0], first[1], first[2], 1 - first.sum()};
    bool inside = true;
    for (std::size_t i = 0; i < 4 && inside; ++i) {
      if (place.barycentric[i] >= 0) continue;
      // Over its gradient the coordinate is the distance from the face where it is 0.
      const Eigen::RowVector3d gradient =
          i < 3 ? Eigen::RowVector3d(coordinates.gradients.row(static_cast<Eigen::Index>(i)))
                : Eigen::RowVector3d(-coordinates.gradients.colwise().sum());
      inside = place.barycentric[i] >= -tolerance_ * gradient.norm();
    }
    if (inside) return place;
  }
  return std::nullopt;
}

std::optional<double> TetrahedralField::at(const Vec3& point) const {
  const std::optional<Place> place = find(point);
  if (!place) return std::nullopt;
  if (on_ == FieldValues::on_cells) return values_[place->cell];
  double value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value += place->barycentric[i] * values_[static_cast<std::size_t>(cells_[place->cell][i])];
  return value;
}

double TetrahedralField::cell_length(const Vec3& point) const {
  const std::optional<Place> place = find(point);
  if (!place) return std::numeric_limits<double>::infinity();
  // The determinant of the edges is six times the volume.
  return std::cbrt(std::numbers::sqrt2 / std::abs(coordinates_[place->cell].gradients.determinant()));
}

}  // namespace etendue
