// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <stdexcept>
#include <string_view>

#include "solver/transport/state/transport_state.h"
#include "solver/transport/sweep/transport_sweep.h"

namespace etendue {

/// A number of the iteration is infinite or not a number, so no solution can follow from it.
class NotFiniteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws NotFiniteError where the fluence or the irradiance of the state that a sweep gave is not finite.
/// The message names the sweep, the band and the first such cell or wall face.
void check_finite(const TransportSweep& sweep, int sweep_number, const TransportState& state);

/// Throws NotFiniteError where a size [band] is not finite. `quantity` names it, e.g. "residual".
void check_finite(const TransportSweep& sweep, int sweep_number, std::string_view quantity,
                  std::span<const double> sizes);

}  // namespace etendue
