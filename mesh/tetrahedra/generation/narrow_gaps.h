// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "base/errors.h"
#include "mesh/geometry/primitives/surface_complex.h"

namespace etendue {

/// A point of a surface that is near to a facet that it is no corner of.
struct NarrowGap {
  double width;
  Vec3 point;
};

/// The narrowest one that is narrower than this part of the diagonal. What is nearer than rounding touches.
std::optional<NarrowGap> narrowest_gap(const SurfaceComplex& surface, double part);

/// Throws InputError with the place where a gap is so narrow that TetGen takes the two sides for touching: it
/// then fails, does not end, or joins what is apart. Only for surfaces whose facets list all corners on them:
/// those of .poly files need not, and their corners may lie beside a facet by the digits that were written.
void check_gaps(const SurfaceComplex& surface, const Origin& origin);

}  // namespace etendue
