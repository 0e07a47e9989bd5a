// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "solver/transport/order/sweep_slots.h"
#include "solver/transport/state/aligned_array.h"
#include "solver/transport/state/transport_state.h"
#include "solver/transport/walls/wall_exchange.h"

namespace etendue {

/// The walls during one sweep, equation (13) of docs/theory/theory.md: radiance that they send into the
/// inflow slots of each ordinate, and light that arrives at them.
class WallBoundary {
 public:
  /// The walls must outlive it.
  explicit WallBoundary(WallExchange& walls)
      : walls_(walls), inflow_(walls.irradiance_size()), passing_(walls.passing_size()) {}

  /// Sets the radiance that walls emit and reflect alike along all ordinates: L + (rho_d / pi_h) E of (13).
  void form_inflow(const TransportState& last, Emission emission, int threads) {
    walls_.form_inflow(last, emission, threads, inflow_.span());
  }
  /// Makes all walls black and dark but for mirrors within the sweep.
  void clear_inflow() { inflow_.fill_zero(); }

  /// Writes that radiance into all inflow slots.
  template <class Real>
  void fill(const SweepSlotsOf<Real>& slots) const {
    walls_.fill(inflow_.span(), slots);
  }
  /// Adds the light that mirrors and glossy walls reflect along ordinate m: rho_s u_out of (13).
  template <class Real>
  void reflect(OrdinateIndex m, const TransportState& last, const SweepSlotsOf<Real>& slots) const {
    walls_.reflect(m, last, passing_.span(), inflow_.span(), slots);
  }
  /// Adds the light that the walls send along ordinate m to `exitance` [boundary face][face node][stride].
  template <class Real>
  void add_exitance(OrdinateIndex m, const SweepSlotsOf<Real>& slots, std::span<double> exitance) const {
    walls_.add_exitance(m, slots, exitance);
  }
  /// Adds the light that arrives along ordinate m to `irradiance`, E of (13), and keeps it for the mirrors of
  /// this sweep and of the next.
  template <class Real>
  void receive(OrdinateIndex m, const SweepSlotsOf<Real>& slots, AccumulateAt faces,
               std::span<double> irradiance, TransportState& next) {
    walls_.accumulate_irradiance(m, slots, faces, irradiance, next.mirrors(), passing_.span());
  }

 private:
  WallExchange& walls_;
  AlignedArray inflow_;   ///< [boundary face][face node][stride]
  AlignedArray passing_;  ///< radiance that mirrors reflect within the sweep
};

}  // namespace etendue
