// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/vec3.h"

namespace etendue {

/// A value and its gradient in space, carried through a formula together (forward automatic differentiation:
/// Griewank and Walther 2008, chapter 3): derivatives are exact to rounding.
struct Dual {
  double value = 0;
  Vec3 gradient = Vec3::Zero();
};

/// f(a) by the chain rule from f and f' at a's value. What does not vary has no gradient, even where f' is
/// infinite, as that of sqrt at 0.
inline Dual chained(const Dual& a, double value, double slope) {
  if (a.gradient.isZero(0)) return {value, Vec3::Zero()};
  return {value, slope * a.gradient};
}

}  // namespace etendue
