// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/expression/differentiable.h"
#include "base/vec3.h"

namespace etendue {

/// A radiance that is known at every point and in every direction [power/(length^2 sr)]. May be evaluated by
/// several threads at a time.
class ExactRadiance {
 public:
  /// A formula in x, y, z and wx, wy, wz. Throws InputError (without a file; the caller adds it).
  explicit ExactRadiance(const std::string& formula);

  double at(const Vec3& point, const Vec3& direction) const;
  /// The value and its gradient in space.
  Dual with_gradient(const Vec3& point, const Vec3& direction) const;

 private:
  DifferentiableExpression formula_;
};

}  // namespace etendue
