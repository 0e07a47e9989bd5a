// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel/rank_group.h"
#include "solver/transport/kernel/sweep_kernel.h"
#include "solver/transport/sweep/batch_workspace.h"
#include "solver/transport/sweep/directional_input.h"
#include "solver/transport/sweep/moment_operators.h"
#include "solver/transport/sweep/ordinate_recorder.h"
#include "solver/transport/sweep/source_products.h"
#include "solver/transport/sweep/stop_signal.h"
#include "solver/transport/sweep/sweep_pass.h"
#include "solver/transport/sweep/wall_boundary.h"

namespace etendue {

/// March of the ordinates of a batch through the cells: solves equation (4) of docs/theory/theory.md along
/// each of them, cell by cell downwind (reference_sweep.h shows how), in groups that go through the mesh tile
/// by tile.
template <class Real>
class DirectionMarch {
 public:
  using Workspace = BatchWorkspace<Real>;

  /// The arguments must outlive it. `records` hold the source of the sweep, [cell + 1][record length].
  DirectionMarch(const Discretization& discretization, const SweepKernelsOf<Real>& kernels,
                 const AlignedArrayOf<Real>& records, MomentOperators<Real>& moments, WallBoundary& walls,
                 StopSignal& stop)
      : d_(discretization),
        kernels_(kernels),
        records_(records),
        moments_(moments),
        walls_(walls),
        stop_(stop),
        input_(discretization),
        products_(discretization),
        recorder_(discretization) {}

  /// From now on sweeps with emission keep the values of every cell non-negative.
  void keep_positive(Fixup fixup);
  /// [ordinate][stride] Values that the fixup changed; empty before keep_positive().
  const std::vector<FixupCensus>& census() const { return census_; }
  void clear_census() { census_.assign(census_.size(), FixupCensus()); }
  /// Brings the census of each rank's ordinates to all.
  void merge_census(RankGroup& ranks);

  /// Sets the sizes of a record before the batches of a sweep, which keeps the radiance of these ordinates.
  void begin_record(SweepRecord& record, std::span<const int> ordinates) {
    recorder_.begin(record, ordinates);
  }
  /// Marches along the ordinates of one batch and leaves their sums in the workspace. Returns early where the
  /// sweep has to stop. Several threads may do this with a workspace each.
  void march(std::int32_t batch, const SweepPass& pass, Workspace& work);

 private:
  /// One ordinate on its march.
  struct Passage {
    OrdinateIndex ordinate;
    const SweepOrder* order;
    Real* rows;  ///< right-hand sides, then radiance, of the angular cells, [1 + row][node][stride]
    typename Workspace::Member* member;
  };

  /// Whether the ordinates of a group pass together, tile by tile.
  bool is_tiled() const { return d_.orders->step_count() > 1; }
  /// Whether ordinates pass one after the other, because they share arrays that visits do not merely add to.
  bool pass_alone(const SweepRecord* record) const {
    return !d_.dense.empty() || (record != nullptr && !record->radiance.empty());
  }
  void form_rows(std::int32_t batch, const SweepPass& pass, Workspace& work);
  void march_group(std::span<const Passage> group, const SweepPass& pass, Workspace& work);
  /// Fills the slots through which light enters.
  void begin_passage(const Passage& passage, const SweepPass& pass, Workspace& work);
  void run_alone(const Passage& passage, const SweepPass& pass, Workspace& work);
  /// Returns false where the sweep has to stop.
  bool run_together(std::span<const Passage> group, const SweepPass& pass, Workspace& work);
  /// Reads the slots by which light leaves.
  void end_passage(const Passage& passage, const SweepPass& pass, Workspace& work);
  SweepTaskOf<Real> task_of(const Passage& passage, const SweepPass& pass, Workspace& work);
  void run_kernel(const SweepTaskOf<Real>& task) const {
    if (d_.cells.is_complex()) return kernels_.sweep_complex(task);
    (task.census != nullptr ? kernels_.sweep_positive : kernels_.sweep)(task);
  }

  const Discretization& d_;
  const SweepKernelsOf<Real>& kernels_;
  const AlignedArrayOf<Real>& records_;
  MomentOperators<Real>& moments_;
  WallBoundary& walls_;
  StopSignal& stop_;
  DirectionalInput input_;
  SourceProducts products_;
  OrdinateRecorder recorder_;
  Fixup fixup_ = Fixup::rescale;
  std::vector<FixupCensus> census_;  ///< [ordinate][stride]; empty: values are not kept positive
};

extern template class DirectionMarch<double>;
extern template class DirectionMarch<float>;

}  // namespace etendue
