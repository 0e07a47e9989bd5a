// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/vec3.h"

namespace etendue {

/// A straight edge of a contour, with a direction along it.
struct ContourEdge {
  Vec3 from, to;
};

/// The integral of (ds . dt) ln(r / unit) over two edges, r the distance of the points on both [length^2], to
/// an absolute tolerance. Along the second edge it is closed; along the first it is a quadrature between the
/// points where the other edge's line and ends are nearest, so that edges may touch, cross and coincide.
double contour_integral(const ContourEdge& first, const ContourEdge& second, double unit, double tolerance);

}  // namespace etendue
