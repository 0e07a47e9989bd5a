// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/transport/state/transport_state.h"
#include "solver/transport/sweep/transport_sweep.h"

namespace etendue {

/// Volume-weighted L2 norms of a fluence, and area-weighted ones of the irradiance on walls that reflect.
struct FieldNorms {
  std::vector<double> volume;  ///< [band]
  std::vector<double> walls;   ///< [band]
};

/// Norms of state + change. Sums are over cells and faces in their order.
FieldNorms field_norms(const TetrahedralMesh& mesh, const TransportSweep& sweep, const TransportState& state,
                       const TransportState& change);

/// |change| / |field| in each band, of the fluence or of the walls' irradiance, whichever is larger.
std::vector<double> relative_size(const TetrahedralMesh& mesh, const TransportSweep& sweep,
                                  const TransportState& change, const FieldNorms& field);

/// |change| / |state + change|: with the residual r = F(x) - x the relative size of the residual.
std::vector<double> relative_change(const TetrahedralMesh& mesh, const TransportSweep& sweep,
                                    const TransportState& state, const TransportState& change);

/// The same of the residual next - last, next = F(last): |next - last| / |next|.
std::vector<double> relative_residual(const TetrahedralMesh& mesh, const TransportSweep& sweep,
                                      const TransportState& last, const TransportState& next);

}  // namespace etendue
