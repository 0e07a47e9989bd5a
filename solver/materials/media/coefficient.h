// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "base/expression/expression.h"
#include "base/quadrature/cell_rule.h"
#include "base/vec3.h"

namespace etendue {

/// What a coefficient is in one cell.
struct CellSample {
  double mean = 0;
  double smallest = 0;        ///< at the points of the rule; not finite where a value is not
  Vec3 where = Vec3::Zero();  ///< the point of the smallest value
  /// At the vertices less `mean`, of the linear function of the same mean that is closest to it (least
  /// squares by the rule); made smaller where that function would be negative.
  std::array<double, 4> slope = {};
};

/// A number or a formula in x, y, z.
class Coefficient {
 public:
  Coefficient(double value = 0) : value_(value) {}
  /// The formula's variables must be x, y, z.
  explicit Coefficient(Expression formula) : formula_(std::move(formula)) {}

  bool is_constant() const { return !formula_; }
  double at(const Vec3& point) const;
  /// The number or formula.
  std::string text() const;
  /// Points and weights of a tetrahedron for integrals of the coefficient: a 14-point rule of degree 5
  /// (Walkington 2000), in parts of the tetrahedron where a field from a file has smaller cells or jumps.
  std::span<const CellRulePoint> rule(const std::array<Vec3, 4>& vertices) const;
  /// Mean over a tetrahedron and smallest value by that rule, which has positive weights and points inside:
  /// the mean of a coefficient that is nowhere negative is not negative either.
  CellSample sample(const std::array<Vec3, 4>& vertices) const;
  double cell_mean(const std::array<Vec3, 4>& vertices) const { return sample(vertices).mean; }

 private:
  double value_ = 0;
  std::optional<Expression> formula_;
};

}  // namespace etendue
