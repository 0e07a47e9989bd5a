// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/sweep/moment_operators.h"

#include <algorithm>

namespace etendue {
namespace {

/// Numbers rounded up to whole cache lines.
template <class Real>
std::size_t whole_lines(std::size_t length) {
  constexpr std::size_t line = 64 / sizeof(Real);
  return (length + line - 1) / line * line;
}

}  // namespace

template <class Real>
MomentOperators<Real>::MomentOperators(const ScatteringMoments& moments, const OrdinateSchedule& schedule,
                                       const SweepKernelsOf<Real>& kernels)
    : moments_(moments),
      schedule_(schedule),
      kernels_(kernels),
      evaluation_(moments.orbits().evaluation().begin(), moments.orbits().evaluation().end()),
      integration_(moments.orbits().integration().begin(), moments.orbits().integration().end()),
      source_(moments.moments_size()),
      sums_(moments.moments_size()) {}

// The scratch row ends with a cache line, so that wide lanes do not straddle two of them in the rows behind
// it.
template <class Real>
std::size_t MomentOperators<Real>::ordinate_length() const {
  if (moments_.row_count() == 0) return 0;
  return whole_lines<Real>(moments_.row_length()) +
         whole_lines<Real>(moments_.row_count() * moments_.row_length());
}

template <class Real>
Real* MomentOperators<Real>::rows_at(std::int32_t place, AlignedArrayOf<Real>& batch_rows) const {
  if (batch_rows.size() == 0) return nullptr;
  return batch_rows.data() + static_cast<std::size_t>(place % schedule_.batch()) * ordinate_length() +
         whole_lines<Real>(moments_.row_length()) - moments_.row_length();
}

template <class Real>
std::vector<Real*> MomentOperators<Real>::rows_of_orbits(std::int32_t batch,
                                                         AlignedArrayOf<Real>& batch_rows) const {
  std::vector<Real*> rows;
  const MomentOrbits& orbits = moments_.orbits();
  const int end = std::min(orbits.count(), first_orbit(batch + 1));
  for (int orbit = first_orbit(batch); orbit < end; ++orbit)
    for (const OrdinateIndex m : orbits.ordinates(orbit))
      rows.push_back(rows_at(schedule_.place_of(m), batch_rows) + moments_.row_length());
  return rows;
}

template <class Real>
MomentTaskOf<Real> MomentOperators<Real>::task_of(const std::vector<Real*>& rows) const {
  MomentTaskOf<Real> task;
  task.row_length = moments_.row_length();
  task.moments = moments_.moment_count();
  task.orbit_size = moments_.orbits().size();
  task.class_begin = moments_.orbits().class_begin().data();
  task.order = moments_.orbits().order().data();
  task.orbits = static_cast<int>(rows.size()) / task.orbit_size;
  task.direction_rows = rows.data();
  return task;
}

template <class Real>
void MomentOperators<Real>::moments_to_directions(std::int32_t batch, AlignedArrayOf<Real>& batch_rows) {
  const std::vector<Real*> rows = rows_of_orbits(batch, batch_rows);
  MomentTaskOf<Real> task = task_of(rows);
  task.matrix = evaluation_.data() + factors_begin(batch);
  task.moment_rows = source_.data();
  task.last_row = moments_.row_count();
  kernels_.moments_to_directions(task);
}

template <class Real>
void MomentOperators<Real>::directions_to_moments(std::size_t first, std::size_t last, std::int32_t batch,
                                                  AlignedArrayOf<Real>& batch_rows) {
  const std::vector<Real*> rows = rows_of_orbits(batch, batch_rows);
  MomentTaskOf<Real> task = task_of(rows);
  task.matrix = integration_.data() + factors_begin(batch);
  task.moment_rows = sums_.data();
  task.first_row = first;
  task.last_row = last;
  kernels_.directions_to_moments(task);
}

template <class Real>
void MomentOperators<Real>::move_sums(std::size_t first, std::size_t last, std::span<double> moments,
                                      bool adds) {
  const std::size_t length = moments_.row_length() * static_cast<std::size_t>(moments_.moment_count());
  for (std::size_t i = first * length; i < last * length; ++i) {
    moments[i] = adds ? moments[i] + sums_[i] : double{sums_[i]};
    sums_[i] = 0;
  }
}

template class MomentOperators<double>;
template class MomentOperators<float>;

}  // namespace etendue
