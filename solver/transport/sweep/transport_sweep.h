// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <span>
#include <vector>

#include "solver/solution/angular_input.h"
#include "solver/solution/solution.h"
#include "solver/transport/cells/cell_coefficients.h"
#include "solver/transport/kernel/sweep_kernel.h"
#include "solver/transport/order/ordinate_schedule.h"
#include "solver/transport/order/sweep_orders.h"
#include "solver/transport/order/sweep_stopped.h"
#include "solver/transport/scattering/dense_scattering.h"
#include "solver/transport/scattering/scattering_moments.h"
#include "solver/transport/state/transport_state.h"
#include "solver/transport/walls/wall_exchange.h"

namespace etendue {

/// What a sweep writes down beside the next state when it is asked to.
struct SweepRecord {
  AlignedArray net_flux;  ///< [cell][3][node][stride] [power/length^2]
  AlignedArray exitance;  ///< [boundary face][face node][stride] [power/length^2]
  std::vector<OrdinateRadiance>
      radiance;                ///< values [cell][node][stride]; ordinates are chosen by the caller
  std::vector<double> meters;  ///< [meter][stride]
  /// [cell][band] absorbed [power/length^3] where absorption depends on the direction; empty where it nowhere
  /// does.
  std::vector<double> absorbed;
};

/// One sweep through all cells along all directions: the affine map whose fixed point is the discrete
/// solution. Source and reflected light come from the last state; the radiance itself is never stored.
/// Threads take batches of directions of fixed size, whose sums are added in their order: the same bits for
/// any number of threads. States are in double precision whatever the numbers, double or float, that the
/// sweep itself computes with.
template <class Real>
class TransportSweepOf {
 public:
  /// `extinction` is [cell][band]; it may exceed absorption + scattering. The arguments must outlive it.
  TransportSweepOf(const Problem& problem, const DirectionSet& directions, std::span<const double> extinction,
                   const SolveOptions& options);
  /// The same sweep in another precision, with the same orders. The other one's arguments must outlive it.
  template <class Other>
  explicit TransportSweepOf(const TransportSweepOf<Other>& other);
  ~TransportSweepOf();

  StateLayout layout() const;
  /// next = F(last). `record`, where it is not null, is filled too (its sizes are set here).
  void apply(const TransportState& last, TransportState& next, SweepRecord* record = nullptr);
  /// next = T last, the linear part of F.
  void apply_linear(const TransportState& last, TransportState& next);
  /// The same in the bands that are `active`, [band]; the others have to be zero in `last`. Once the active
  /// bands fit into fewer lanes, a sweep of these bands alone does it.
  void apply_linear(const TransportState& last, TransportState& next, std::span<const char> active);
  /// next = what a unit isotropic source in all cells gives through extinction alone, with walls that send
  /// back nothing but what mirrors reflect within the sweep. Its fluence over 4 pi is the mean distance that
  /// light comes from, 1/sigma_t far inside a medium.
  void apply_to_unit_source(TransportState& next);
  /// From now on apply() keeps the values of every cell non-negative, so it is no longer affine;
  /// apply_linear() stays as it was. Only for linear elements.
  void keep_positive(Fixup fixup);
  /// [ordinate][stride] What the fixup met in the last apply(); empty before keep_positive().
  const std::vector<FixupCensus>& fixup_census() const { return census_; }
  /// Whether one sweep gives the solution: nothing scatters, and nothing that arrives at walls or lagged
  /// faces is for the next sweep.
  bool is_direct() const;

  const TetrahedralMesh& mesh() const { return problem_.mesh(); }
  AngularSpace space() const { return problem_.space(); }
  const CellCoefficients& cells() const { return cells_; }
  const WallExchange& walls() const { return walls_; }
  const Problem& problem() const { return problem_; }
  const DirectionSet& directions() const { return directions_; }
  const ScatteringMoments& scattering() const { return scattering_; }
  const DenseScattering& dense_scattering() const { return dense_; }
  const std::vector<ScatteringTreatment>& scattering_plan() const { return plan_; }
  const std::vector<DenseGroup>& scattering_matrices() const { return dense_groups_; }
  const SweepOrders& orders() const { return *orders_; }
  const char* instruction_set() const { return kernels_.instruction_set; }
  int threads() const { return threads_; }
  /// Bands of all sweeps.
  std::int64_t band_sweep_count() const { return band_sweep_count_; }
  /// Over all sweeps and threads, waiting left out.
  double processor_seconds() const { return processor_seconds_; }
  /// Of bands in the sweep that did the last apply_linear(): fewer than the bands may take once some are
  /// done.
  int lanes() const;
  double order_seconds() const { return order_seconds_; }  ///< wall clock

 private:
  template <class>
  friend class TransportSweepOf;

  struct Workspace;
  struct Passage;
  struct ActiveBandSweep;

  /// How the media scatter.
  struct Scattering {
    std::vector<ScatteringTreatment> plan;
    std::vector<DenseGroup> groups;
  };
  static Scattering scattering_of(const Problem& problem, const DirectionSet& directions);

  /// Makes its own orders where there are none.
  TransportSweepOf(const Problem& problem, const DirectionSet& directions, std::span<const double> extinction,
                   const SolveOptions& options, Scattering scattering,
                   std::shared_ptr<const SweepOrders> orders);
  /// Of some bands of another sweep, with whose orders it goes.
  TransportSweepOf(const TransportSweepOf& wide, const Problem& problem, std::span<const double> extinction,
                   std::span<const int> bands);
  /// Whether moments are added up where the next state has them.
  static constexpr bool adds_in_place = scalar_of<Real> == Scalar::double_precision;

  void make_workspaces();
  /// Returns the sweep of the active bands; null where it would not need fewer lanes.
  ActiveBandSweep* active_band_sweep(std::span<const char> active);

  void sweep_all(const TransportState& last, TransportState& next, SweepRecord* record);
  void sweep_source(const TransportState& last, TransportState& next, SweepRecord* record);
  void form_source(const TransportState& last);
  void form_unit_source();
  /// Copies the records to the threads, which set the mass of dense cells in them for each ordinate.
  void share_records();
  void sweep_batch(std::int32_t batch, const TransportState& last, TransportState& next, SweepRecord* record,
                   Workspace& work);
  void form_angular_source(std::int32_t batch, Workspace& work);
  /// Whether this sweep is to end; any thread may ask.
  bool is_stopped();
  void sweep_group(std::span<const Passage> group, const TransportState& last, TransportState& next,
                   SweepRecord* record, Workspace& work);
  void begin_passage(const Passage& passage, const TransportState& last, SweepRecord* record,
                     Workspace& work);
  SweepTaskOf<Real> make_task(const Passage& passage, SweepRecord* record, Workspace& work);
  void run_kernel(const SweepTaskOf<Real>& task) const;
  void run_alone(const Passage& passage, SweepRecord* record, Workspace& work);
  /// False where the sweep is to end.
  bool run_together(std::span<const Passage> group, SweepRecord* record, Workspace& work);
  void end_passage(const Passage& passage, TransportState& next, SweepRecord* record, Workspace& work);
  void sweep_and_keep(SweepTaskOf<Real> task, OrdinateRadiance& kept, std::span<Real> whole_rows) const;
  void set_lagged(OrdinateIndex m, const SweepOrder& order, const TransportState& last,
                  const SweepSlotsOf<Real>& slots) const;
  void keep_lagged(OrdinateIndex m, const SweepOrder& order, TransportState& next,
                   const SweepSlotsOf<Real>& slots) const;
  void add_isotropic_source(std::int32_t first, std::int32_t last);
  void add_angular_source(OrdinateIndex m, Real* angular) const;
  void add_input(OrdinateIndex m, CellIndex cell, std::vector<double>& values, Real* right) const;
  void add_angular_inflow(OrdinateIndex m, const SweepSlotsOf<Real>& slots, std::span<double> exitance) const;
  void read_meters(OrdinateIndex m, const Real* angular, std::span<double> meters) const;
  void merge(std::int32_t first_batch, int batches, TransportState& next, SweepRecord* record);
  void merge_cells(std::int32_t first, std::int32_t last, int batches, TransportState& next,
                   SweepRecord* record);
  void merge_moments(std::size_t first, std::size_t last, std::int32_t batch, Workspace& work,
                     TransportState& next);
  std::vector<CellIndex> observed_cells() const;
  /// Whether the ordinates of a group pass together, tile by tile.
  bool is_tiled() const { return orders_->step_count() > 1; }
  /// Whether ordinates pass one after the other, because they share more than what visits add to.
  bool pass_alone(const SweepRecord* record) const;
  std::size_t angular_length() const;  ///< numbers of the rows of one ordinate
  Real* angular_at(std::int32_t place, Workspace& work) const;
  int first_orbit(std::int32_t batch) const {
    return batch * schedule_.batch() / scattering_.orbits().size();
  }
  std::size_t factors_begin(std::int32_t batch) const {
    return static_cast<std::size_t>(first_orbit(batch)) *
           static_cast<std::size_t>(scattering_.moment_count());
  }
  /// [orbit of a batch][direction]
  std::vector<Real*> angular_rows(std::int32_t batch, Workspace& work) const;
  /// What the products of both ways between moments and the rows of a batch have in common.
  MomentTaskOf<Real> moment_task(const std::vector<Real*>& rows) const;
  bool shines_by_direction() const;
  std::size_t fluence_size() const;

  const Problem& problem_;
  const DirectionSet& directions_;
  std::span<const double> extinction_;
  SolveOptions options_;
  int threads_;
  std::vector<ScatteringTreatment> plan_;
  std::vector<DenseGroup> dense_groups_;
  CellCoefficients cells_;
  OrdinateSchedule schedule_;
  ScatteringMoments scattering_;
  DenseScattering dense_;
  double order_seconds_ = 0;
  std::shared_ptr<const SweepOrders> orders_;
  WallExchange walls_;
  SweepKernelsOf<Real> kernels_;
  AlignedArrayOf<Real> records_;        ///< [cell + 1][record length], the source of the last sweep in them
  AlignedArray inflow_;                 ///< [boundary face][face node][stride] of the last sweep
  AlignedArray passing_;                ///< what mirrors hand on within a sweep
  AlignedArrayOf<Real> moment_source_;  ///< [row][moment][node][stride]
  AlignedArrayOf<Real> moment_sums_;    ///< likewise, of the next state; empty where it has them itself
  std::vector<Real> evaluation_;        ///< of scattering_
  std::vector<Real> integration_;
  std::vector<std::int32_t> all_cells_index_;  ///< [cell + 1] cell + 1, to keep an ordinate's whole radiance
  std::vector<std::unique_ptr<Workspace>> workspaces_;
  Fixup fixup_ = Fixup::rescale;
  std::vector<FixupCensus> census_;         ///< [ordinate][stride]; empty: values are not kept positive
  Emission emission_ = Emission::included;  ///< of the sweep that is under way
  std::unique_ptr<ActiveBandSweep> active_band_sweep_;  ///< of the last active bands; null: all bands
  bool can_sweep_active_bands_ = true;                  ///< false where a subset has other rows in its state
  std::int64_t band_sweep_count_ = 0;
  double processor_seconds_ = 0;
  std::atomic<bool> stopped_ = false;
};

extern template class TransportSweepOf<double>;
extern template class TransportSweepOf<float>;

using TransportSweep = TransportSweepOf<double>;
using SingleTransportSweep = TransportSweepOf<float>;

}  // namespace etendue
