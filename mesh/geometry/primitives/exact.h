// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

// The only header that includes CGAL: exact coordinates travel between the sources of this room, and
// nowhere else.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "base/vec3.h"

namespace etendue {

/// Rational coordinates behind interval filters: no construction rounds (The CGAL Project, 2D and 3D Kernel).
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactNumber = Exact::FT;
using ExactPoint = Exact::Point_3;
using ExactPlane = Exact::Plane_3;

inline ExactPoint exact(const Vec3& point) { return {point.x(), point.y(), point.z()}; }

/// The double next to an exact number. Asking for the exact value first narrows the filter's interval.
inline double rounded(const ExactNumber& number) { return CGAL::to_double(CGAL::exact(number)); }

inline Vec3 rounded(const ExactPoint& point) {
  return {rounded(point.x()), rounded(point.y()), rounded(point.z())};
}

}  // namespace etendue
