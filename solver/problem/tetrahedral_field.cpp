// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/tetrahedral_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace etendue {
namespace {

/// Points this part of the field's diagonal outside still count as on its surface.
constexpr double kTolerance = 1e-9;

double tolerance_of(const std::vector<Vec3>& points) {
  Box box;
  for (const Vec3& point : points) box.extend(point);
  return box.isEmpty() ? 0 : kTolerance * box.diagonal().norm();
}

std::vector<Box> boxes_of(const std::vector<Vec3>& points, const std::vector<std::array<int, 4>>& cells) {
  std::vector<Box> boxes(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (const int p : cells[c]) boxes[c].extend(points[static_cast<std::size_t>(p)]);
  return boxes;
}

/// Six times the volume, positive where d lies on the side that a, b, c turn counterclockwise to from within.
double six_volumes(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

}  // namespace

TetrahedralField::TetrahedralField(std::vector<Vec3> points, std::vector<std::array<int, 4>> cells,
                                   FieldValues on, std::vector<double> values)
    : points_(std::move(points)),
      cells_(std::move(cells)),
      on_(on),
      values_(std::move(values)),
      tolerance_(tolerance_of(points_)),
      grid_(boxes_of(points_, cells_), tolerance_) {}

std::optional<TetrahedralField::Place> TetrahedralField::find(const Vec3& point) const {
  for (const std::int32_t candidate : grid_.candidates(point)) {
    Place place{static_cast<std::size_t>(candidate), {}};
    std::array<Vec3, 4> corner;
    for (std::size_t i = 0; i < 4; ++i) corner[i] = points_[static_cast<std::size_t>(cells_[place.cell][i])];
    const double whole = six_volumes(corner[0], corner[1], corner[2], corner[3]);
    bool inside = whole != 0;
    for (std::size_t i = 0; i < 4 && inside; ++i) {
      std::array<Vec3, 4> replaced = corner;
      replaced[i] = point;
      place.barycentric[i] = six_volumes(replaced[0], replaced[1], replaced[2], replaced[3]) / whole;
      // Over the height on face i the coordinate is the distance from the face.
      const Vec3 normal =
          (corner[(i + 2) % 4] - corner[(i + 1) % 4]).cross(corner[(i + 3) % 4] - corner[(i + 1) % 4]);
      inside = place.barycentric[i] * std::abs(whole) >= -tolerance_ * normal.norm();
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
  const auto corner = [&](std::size_t i) {
    return points_[static_cast<std::size_t>(cells_[place->cell][i])];
  };
  return std::cbrt(std::numbers::sqrt2 * std::abs(six_volumes(corner(0), corner(1), corner(2), corner(3))));
}

}  // namespace etendue
