// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/materials/kernels/directional_scattering.h"

namespace etendue {

/// What a formula scatters out of a direction.
struct OutgoingMoments {
  double scattered = 0;  ///< the integral of k(before -> v) over v [1/length]
  double transfer = 0;   ///< that of k(before -> v) (1 - before.v): the momentum that the direction loses
  /// By how much of itself either may be off: the last change of a rule that is doubled, or the sum of the
  /// changes of all patches of an adaptive one. 1: nothing is known, or a value is not finite.
  double uncertainty = 0;
};

/// Rules around the direction are doubled until they agree: to rounding for smooth kernels, peaks of Henyey
/// and Greenstein up to g = 0.9 among them. Kinks, steps and peaks elsewhere are left to the adaptive rule.
OutgoingMoments outgoing_moments(const KernelFormula& kernel, const Vec3& before);

/// The scattering coefficient in the mean over directions [1/length]: over `polar` inclinations, each with
/// twice as many azimuths.
double mean_scattering(const KernelFormula& kernel, int polar = 8);

/// A copy at another place, which another thread may evaluate.
KernelFormula kernel_at(const KernelFormula& kernel, const Vec3& place);

}  // namespace etendue
