// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solver/transport/kernel/sweep_kernel.h"
#include "solver/transport/sweep/discretization.h"
#include "solver/transport/sweep/sweep_record.h"

namespace etendue {

/// Record of what depends on single ordinates: irradiance meters and radiance that is kept.
class OrdinateRecorder {
 public:
  /// `discretization` must outlive it.
  explicit OrdinateRecorder(const Discretization& discretization) : d_(discretization) {}

  /// Sets the sizes of a record, and all its values to zero; it keeps the radiance of these ordinates.
  void begin(SweepRecord& record, std::span<const int> ordinates);
  /// Returns the place of the radiance along ordinate m; null where it is not kept.
  OrdinateRadiance* kept(OrdinateIndex m, SweepRecord* record) const;
  /// Adds the irradiance of all meters along ordinate m to `meters` [meter][stride]. `rows` are those of the
  /// angular cells, the scratch row first.
  template <class Real>
  void add_meters(OrdinateIndex m, const Real* rows, std::span<double> meters) const;
  /// Returns the same task with a row for every cell, in `all_rows` [1 + cell][node][stride], so that the
  /// kernel leaves the radiance of all cells there.
  template <class Real>
  SweepTaskOf<Real> with_all_rows(SweepTaskOf<Real> task, std::span<Real> all_rows) const;
  /// Copies the radiance from there to `kept`, and to the rows of the angular cells.
  template <class Real>
  void keep(std::span<const Real> all_rows, OrdinateRadiance& kept, Real* rows) const;

 private:
  const Discretization& d_;
  std::vector<std::int32_t> all_cells_index_;  ///< [cell + 1] cell + 1, for SweepTaskOf::angular_index
};

}  // namespace etendue
