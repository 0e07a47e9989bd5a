// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/transport/kernel/sweep_kernel.h"
#include "solver/transport/order/ordinate_schedule.h"
#include "solver/transport/scattering/scattering_moments.h"
#include "solver/transport/state/aligned_array.h"

namespace etendue {

/// Maps between moments and the radiance along the ordinates of a batch, equation (11) of
/// docs/theory/theory.md, in the angular cells.
///
/// An ordinate has rows [1 + row][node][stride], of which the first is a scratch row; the rows of all
/// ordinates of a batch lie in one array of batch_length() numbers.
template <class Real>
class MomentOperators {
 public:
  /// The arguments must outlive it.
  MomentOperators(const ScatteringMoments& moments, const OrdinateSchedule& schedule,
                  const SweepKernelsOf<Real>& kernels);

  /// Numbers of the rows of all ordinates of a batch; 0 where no cell is angular.
  std::size_t batch_length() const { return static_cast<std::size_t>(schedule_.batch()) * ordinate_length(); }
  /// The rows of the ordinate at a place of the schedule, the scratch row first; null where no cell is
  /// angular.
  Real* rows_at(std::int32_t place, AlignedArrayOf<Real>& batch_rows) const;
  /// Moments of the right-hand sides, [row][moment][node][stride].
  Real* source() { return source_.data(); }

  /// Writes the right-hand sides of all ordinates of a batch from the moments of the source: s_m of (11).
  void moments_to_directions(std::int32_t batch, AlignedArrayOf<Real>& batch_rows);
  /// Adds the moments of the radiance along the ordinates of a batch, phi_k of (11), in rows first … last
  /// - 1, to the sums of its section (BatchSections).
  void directions_to_moments(std::size_t first, std::size_t last, std::int32_t batch,
                             AlignedArrayOf<Real>& batch_rows);
  /// Sets moments in these rows to the sums, or adds them there, and the sums to zero.
  void move_sums(std::size_t first, std::size_t last, std::span<double> moments, bool adds);

 private:
  std::size_t ordinate_length() const;
  int first_orbit(std::int32_t batch) const { return batch * schedule_.batch() / moments_.orbits().size(); }
  std::size_t factors_begin(std::int32_t batch) const {
    return static_cast<std::size_t>(first_orbit(batch)) * static_cast<std::size_t>(moments_.moment_count());
  }
  /// [orbit of a batch][direction]
  std::vector<Real*> rows_of_orbits(std::int32_t batch, AlignedArrayOf<Real>& batch_rows) const;
  /// The common part of the products in both directions.
  MomentTaskOf<Real> task_of(const std::vector<Real*>& rows) const;

  const ScatteringMoments& moments_;
  const OrdinateSchedule& schedule_;
  const SweepKernelsOf<Real>& kernels_;
  std::vector<Real> evaluation_;   ///< Y_k, as MomentOrbits::evaluation() has them
  std::vector<Real> integration_;  ///< w Y_k, likewise
  AlignedArrayOf<Real> source_;    ///< [row][moment][node][stride]
  AlignedArrayOf<Real> sums_;      ///< likewise, of a section
};

extern template class MomentOperators<double>;
extern template class MomentOperators<float>;

}  // namespace etendue
