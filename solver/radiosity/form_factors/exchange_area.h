// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/radiosity/form_factors/flat_patch.h"

namespace etendue {

/// A_a F_ab = A_b F_ba [length^2]: the area of one flat patch times its form factor to the other, with
/// nothing between them. Each sees the part of the other that is before it, and by its front; in that case
///
///     A_a F_ab = 1/(2 pi) sum over edges of a and of b of the integral of ln r ds.dt   (Sparrow 1963)
///
/// Patches far from each other have their points summed instead. The error is below about 1e-9 of the smaller
/// area, of far patches below 1e-6 of the value.
double exchange_area(const FlatPatch& a, const FlatPatch& b);

/// The same by the contour integral at any distance.
double exchange_area_by_contours(const FlatPatch& a, const FlatPatch& b);

}  // namespace etendue
