// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "solver/angular/sets/direction_set.h"

namespace etendue {

/// Corrects values p_m [1/sr] of a distribution of directions at the ordinates of a set, so that the set
/// integrates it to 1 and to its mean direction. A set samples a narrow peak at a few ordinates, and the sum
/// and the mean of the samples are not those of the peak. The corrected values are
///
///     p_m exp(h_m (a + b.w_m)),   h_m = p_m / max p,
///
/// positive, and nearly as they were wherever p is small beside its peak: what scatters sideways and back is
/// right already. a and b minimize the convex function
///
///     sum over m of w_m max p exp(h_m (a + b.w_m)) - (a + b.mean),
///
/// by Newton's method with step control. Where no such values exist, because the peak is narrower than the
/// set resolves, the values are scaled to the integral 1 alone. Some p_m must be positive.
void conserve_moments(const DirectionSet& directions, const Vec3& mean, std::span<double> p);

}  // namespace etendue
