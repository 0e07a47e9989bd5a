// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "solver/transport/sweep/active_band_sweep.h"
#include "solver/transport/sweep/batch_workspace.h"
#include "solver/transport/sweep/direction_march.h"
#include "solver/transport/sweep/discretization.h"
#include "solver/transport/sweep/moment_operators.h"
#include "solver/transport/sweep/stop_signal.h"
#include "solver/transport/sweep/sweep_cost.h"
#include "solver/transport/sweep/sweep_pass.h"
#include "solver/transport/sweep/wall_boundary.h"

namespace etendue {

/// One sweep through all cells along all directions: the affine map F(x) = T x + b of docs/theory/theory.md,
/// section 7, whose fixed point is the discrete solution. Source and reflected light come from the last
/// state; the radiance itself is never stored.
///
/// A sweep forms the source, equation (11), lets threads march along batches of ordinates
/// (direction_march.h), and adds their sums in a fixed order (batch_reduction.h): the same bits for any
/// number of threads, and of ranks that share the batches (SolveOptions::ranks). States are in double
/// precision whatever the numbers, double or float, that the sweep itself computes with.
template <class Real>
class TransportSweepOf {
 public:
  /// `extinction` is [cell][band]; it may exceed absorption + scattering. The arguments must outlive it.
  /// `known_orders` as in Discretization. Throws InputError where a mirror has no partner ordinates,
  /// SweepStopped where the options' `stops` asks for it.
  TransportSweepOf(const Problem& problem, const DirectionSet& directions, std::span<const double> extinction,
                   const SolveOptions& options, std::shared_ptr<const SweepOrders> known_orders = nullptr);
  /// The same sweep in another precision, with the same orders. The other one's arguments must outlive it.
  template <class Other>
  explicit TransportSweepOf(const TransportSweepOf<Other>& other);
  /// The sweep of a subset of the bands, of which `problem` and `extinction` are, with the same orders.
  TransportSweepOf(const Discretization& wide, const Problem& problem, std::span<const double> extinction,
                   std::span<const int> bands);
  /// The linear sweep of the same problem on other directions (Discretization).
  TransportSweepOf(const Discretization& fine, const DirectionSet& directions);

  StateLayout layout() const { return discretization_.layout(); }
  /// next = F(last). `record`, where it is not null, is filled too (its sizes are set here). All sweeps throw
  /// SweepStopped where the options' `stops` asks for it.
  void apply(const TransportState& last, TransportState& next, SweepRecord* record = nullptr);
  /// The radiance along some ordinates that apply(last) finds, [as listed] with values [cell][node][stride].
  /// The sweep before must have been apply() to a state that is the same to the iteration's tolerance:
  /// mirrors that reflect within a sweep keep what arrived then.
  std::vector<OrdinateRadiance> radiance_along(const TransportState& last, std::span<const int> ordinates);
  /// next = T last, the linear part of F.
  void apply_linear(const TransportState& last, TransportState& next);
  /// The same in the bands that are `active`, [band]; the others have to be zero in `last`. Once the active
  /// bands fit into fewer lanes, these bands alone are swept.
  void apply_linear(const TransportState& last, TransportState& next, std::span<const char> active);
  /// next = the state of a unit isotropic source in all cells with extinction alone, and walls that reflect
  /// nothing but as mirrors within the sweep. Its fluence over 4 pi is the mean distance from which light
  /// comes, 1/sigma_t far inside a medium.
  void apply_to_unit_source(TransportState& next);
  /// From now on apply() keeps the values of every cell non-negative, so it is no longer affine;
  /// apply_linear() stays as it was. Only for linear elements.
  void keep_positive(Fixup fixup) { march_.keep_positive(fixup); }
  /// [ordinate][stride] Values that the fixup changed in the last apply(); empty before keep_positive().
  const std::vector<FixupCensus>& fixup_census() const { return march_.census(); }
  /// Whether one sweep gives the solution.
  bool is_direct() const { return discretization_.is_direct(); }

  const Discretization& discretization() const { return discretization_; }
  const Problem& problem() const { return discretization_.problem; }
  const TetrahedralMesh& mesh() const { return problem().mesh(); }
  const DirectionSet& directions() const { return discretization_.directions; }
  const CellCoefficients& cells() const { return discretization_.cells; }
  const WallExchange& walls() const { return discretization_.walls; }
  const char* instruction_set() const { return kernels_.instruction_set; }
  int threads() const { return threads_; }
  std::int64_t band_sweep_count() const { return cost_.band_sweeps; }
  double processor_seconds() const { return cost_.processor_seconds; }
  double order_seconds() const { return discretization_.order_seconds; }  ///< wall clock
  /// Lanes of the sweep that did the last apply_linear().
  int lanes() const { return active_bands_.lanes(); }

 private:
  /// Constructs the discretization from the arguments.
  template <class... Arguments>
  explicit TransportSweepOf(std::in_place_t, const Arguments&... arguments);

  /// Forms the source from the last state and sweeps.
  void sweep_state(const SweepPass& pass);
  void form_source(const SweepPass& pass);
  void form_unit_source();
  /// Copies the records to the threads, which set the mass of dense cells in them for each ordinate.
  void share_records();
  /// Sweeps with the source that is formed; the record keeps the radiance of these ordinates.
  void sweep(const SweepPass& pass, std::span<const int> ordinates = {});
  void march_batches(const SweepPass& pass);

  Discretization discretization_;
  int threads_;
  SweepKernelsOf<Real> kernels_;
  AlignedArrayOf<Real> records_;  ///< [cell + 1][record length], the source of the last sweep in them
  MomentOperators<Real> moments_;
  WallBoundary walls_;
  StopSignal stop_;
  DirectionMarch<Real> march_;
  std::vector<std::unique_ptr<BatchWorkspace<Real>>> workspaces_;  ///< [thread]
  ActiveBandSweep<Real> active_bands_;
  SweepCost cost_;
};

extern template class TransportSweepOf<double>;
extern template class TransportSweepOf<float>;

using TransportSweep = TransportSweepOf<double>;
using SingleTransportSweep = TransportSweepOf<float>;

}  // namespace etendue
