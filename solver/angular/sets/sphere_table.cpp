// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/sets/sphere_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace etendue {
namespace {

using std::numbers::pi;

/// Lagrange's weights of the nodes -1, 0, 1, 2 at t in [0, 1].
std::array<double, 4> cubic(double t) {
  return {-t * (t - 1) * (t - 2) / 6, (t + 1) * (t - 1) * (t - 2) / 2, -(t + 1) * t * (t - 2) / 2,
          (t + 1) * t * (t - 1) / 6};
}

}  // namespace

SphereTable::SphereTable(int rows, const std::function<double(const Vec3&)>& function) : rows_(rows) {
  for (int row = 0; row <= rows; ++row) {
    const double polar = pi * row / rows;
    const bool pole = row == 0 || row == rows;
    for (int column = 0; column < 2 * rows; ++column) {
      if (pole && column > 0) {
        values_.push_back(values_.back());
        continue;
      }
      const double azimuth = pi * column / rows;
      values_.push_back(function({pole ? 0 : std::sin(polar) * std::cos(azimuth),
                                  pole ? 0 : std::sin(polar) * std::sin(azimuth), std::cos(polar)}));
    }
  }
}

double SphereTable::node(int row, int column) const {
  if (row < 0 || row > rows_) {
    row = row < 0 ? -row : 2 * rows_ - row;
    column += rows_;
  }
  const int columns = 2 * rows_;
  return values_[static_cast<std::size_t>(row * columns + (column % columns + columns) % columns)];
}

double SphereTable::at(const Vec3& direction) const {
  const double down = std::acos(std::clamp(direction.z(), -1.0, 1.0)) / pi * rows_;
  const double around = std::atan2(direction.y(), direction.x()) / pi * rows_;
  const int row = std::min(static_cast<int>(down), rows_ - 1);
  const int column = static_cast<int>(std::floor(around));
  const std::array<double, 4> in_rows = cubic(down - row), in_columns = cubic(around - column);
  double sum = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      sum += in_rows[static_cast<std::size_t>(i)] * in_columns[static_cast<std::size_t>(j)] *
             node(row - 1 + i, column - 1 + j);
  return sum;
}

}  // namespace etendue
