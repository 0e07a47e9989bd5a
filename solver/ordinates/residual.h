// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/ordinates/transport_state.h"
#include "solver/ordinates/transport_sweep.h"

namespace etendue {

/// Relative size of the residual F(x) - x in each band: |r| / |phi| in the volume-weighted L2 norm of the
/// fluence, and where walls reflect also that of their irradiance, area-weighted; the larger of the two.
/// `next` is F(last). Sums are over cells and faces in their order.
std::vector<double> relative_residual(const TetrahedralMesh& mesh, const TransportSweep& sweep,
                                      const TransportState& last, const TransportState& next);

}  // namespace etendue
