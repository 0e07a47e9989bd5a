// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "base/parallel/stage_observer.h"
#include "solver/time/beam_bundles.h"
#include "solver/time/delay_factors.h"
#include "solver/time/path_times.h"
#include "solver/uncollided/projection/uncollided_field.h"

namespace etendue {

/// Uncollided light of some sources by the time that it has been under way. Integrals of steady light with
/// the functions of a cell or face, b_i, are those of an UncollidedField; of light of which a time t leaves
/// f(t) they are
///
///     b_i r_i,    r_i = sum over beams of w_ij f(t_j) / sum over beams of w_ij,
///
/// w_ij being the integrals of the beams j at the points of a rule of degree 5: fourteen in a cell, more of
/// them near lamps and in narrow beams, seven in a face. So light without delay is the steady one, exactly.
/// Of what scatters by direction r_i times the steady part of each direction and what the beams of the rule
/// say beside it. Beams of one source whose times differ by less than a part of those from end to end of the
/// cell are one, with their mean time and the spread of times in the part of the cell that a point has.
class DelayedField {
 public:
  /// `steady` is the field of these sources, given by their numbers; `times` must outlive it. An observer
  /// that stops it leaves it incomplete.
  DelayedField(const PathTimes& times, std::shared_ptr<const UncollidedField> steady,
               std::vector<std::size_t> sources, int threads, const StageObserver& observer = {});

  /// Adds to a field of all factors' bands, whose collisions have the directions of this one.
  void add_to(const DelayFactors& factors, int threads, UncollidedField& field) const;
  bool is_complete() const { return complete_; }

 private:
  template <std::size_t nodes>
  class Sums;

  /// Cells that have light but no beam have the times of beams that pass between the points of the rule, or
  /// those of the cells beside; faces those of their cells.
  void fill_gaps();
  void fill_from_beams(CellIndex cell);
  /// [bundle][factor].
  static std::vector<double> factors_of(const BundledBeams& place, const DelayFactors& factors);
  void add_cell(CellIndex cell, const DelayFactors& factors, UncollidedField& field) const;
  void add_face(FaceIndex face, const DelayFactors& factors, UncollidedField& field) const;

  const PathTimes& times_;
  std::shared_ptr<const UncollidedField> steady_;
  std::vector<std::size_t> sources_;
  std::size_t bands_;
  bool complete_ = false;
  std::vector<BundledBeams> cells_;
  std::vector<BundledBeams> faces_;
};

}  // namespace etendue
