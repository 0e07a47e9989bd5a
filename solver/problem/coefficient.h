// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "mesh/base/vec3.h"
#include "solver/expression/expression.h"

namespace etendue {

/// A number or a formula in x, y, z.
class Coefficient {
 public:
  Coefficient(double value = 0) : value_(value) {}
  /// The formula's variables must be x, y, z.
  explicit Coefficient(Expression formula) : formula_(std::move(formula)) {}

  bool is_constant() const { return !formula_; }
  double at(const Vec3& point) const;
  /// Mean over a tetrahedron by an 11-point rule of degree 4 (Keast 1986).
  double cell_mean(const std::array<Vec3, 4>& vertices) const;

 private:
  double value_ = 0;
  std::optional<Expression> formula_;
};

}  // namespace etendue
