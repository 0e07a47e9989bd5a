// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/parallel/stage_observer.h"
#include "solver/observe/sensors/region_account.h"
#include "solver/solution/solution.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue {

/// The account of the light of lights that has not scattered or been reflected diffusely yet, the other part
/// of region_account(). Nothing is scattered into it; what is scattered out, is scattered into the other. In
/// cells it is the fluence that the solution has, of which a cone holds the share of the beams there; through
/// faces it flows as the beams say. Both are sums over points, more of them where the cone's edge goes
/// through (integrate_over_simplex). So it closes as far as these sums are good, which is what its residual
/// tells. A light inside of the domain is counted in the region of its middle. A counter may stop it; then
/// the numbers are not complete.
RegionAccount uncollided_account(const LightSetup& lights, const Solution& solution,
                                 const AccountScope& scope, int threads, StageCounter* counter = nullptr);

/// Cells and faces that the counter counts.
std::size_t account_parts(const TetrahedralMesh& mesh, const AccountScope& scope);

}  // namespace etendue
