// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/problem/directional_scattering.h"

namespace etendue {

/// The integral of k(before -> v) (1 - before.v)^power over v [1/length]: for power 0 the scattering
/// coefficient of a direction, for 1 the momentum that it loses. By a rule that is fine around the direction
/// itself: to rounding for smooth kernels, peaks of Henyey and Greenstein up to g = 0.9 among them.
double outgoing_moment(const KernelFormula& kernel, const Vec3& before, int power);

/// The scattering coefficient in the mean over directions [1/length].
double mean_scattering(const KernelFormula& kernel);

}  // namespace etendue
