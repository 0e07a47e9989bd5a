// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>

#include "base/expression/expression.h"
#include "base/vec3.h"
#include "solver/materials/media/coefficient.h"

namespace etendue {

/// A property of a medium or wall: a number, or a formula in x, y, z and the temperature T [K].
class ThermalProperty {
 public:
  ThermalProperty(double value = 0) : of_place_(value) {}
  ThermalProperty(Coefficient value) : of_place_(std::move(value)) {}
  /// The formula's variables must be x, y, z, T.
  explicit ThermalProperty(Expression formula) : formula_(std::move(formula)) {}

  bool depends_on_temperature() const { return formula_.has_value(); }
  double at(const Vec3& point, double kelvin) const;
  /// In a tetrahedron with these temperatures at its vertices: the mean over the place, or where it depends
  /// on the temperature the value at the centroid, which differs by the square of the cell's size. Also the
  /// smallest value that was found, and where.
  CellSample sample(const std::array<Vec3, 4>& vertices, const std::array<double, 4>& kelvin) const;

 private:
  Coefficient of_place_;
  std::optional<Expression> formula_;
};

}  // namespace etendue
