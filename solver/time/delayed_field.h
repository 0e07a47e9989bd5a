// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/parallel/stage_observer.h"
#include "solver/time/delay_factors.h"
#include "solver/time/path_times.h"
#include "solver/uncollided/projection/uncollided_field.h"

namespace etendue {

/// Uncollided light by the time that it has been under way. Integrals of steady light with the functions of
/// a cell or face, b_i, are those of an UncollidedField; of light of which a time t leaves f(t) they are
///
///     b_i r_i,    r_i = sum over beams of w_ij f(t_j) / sum over beams of w_ij,
///
/// w_ij being the integrals of the beams j at the points of a rule: fourteen in a cell, seven in a face
/// (degree 5). So light without delay is the steady one, exactly. Of what scatters by direction r_i times the
/// steady part of each direction and what the beams of the rule say beside it. Beams of one source whose
/// times differ by less than an eighth of those from end to end of the cell are one, with their mean time.
class DelayedField {
 public:
  /// The field, of these lights, must outlive it. An observer that stops it leaves it incomplete.
  DelayedField(const PathTimes& times, const UncollidedField& steady, int threads,
               const StageObserver& observer = {});

  /// A field of all factors' bands with zeros, without net flux; its collisions and glossy walls have the
  /// directions of the steady one.
  UncollidedField shaped(const DelayFactors& factors) const;
  /// Sets the values of a field that has been shaped for as many factors.
  void set(const DelayFactors& factors, int threads, UncollidedField& field) const;
  std::size_t bytes() const;

 private:
  /// Beams of one source that arrive together.
  struct Bundle {
    std::int32_t source;
    std::int32_t
        incident;  ///< number of the direction of CollisionField from which it scatters; -1: all of it
    double time;
  };
  /// In a cell or face.
  struct Place {
    std::vector<Bundle> bundles;  ///< by rising incident number
    std::vector<double> weights;  ///< [bundle][node][band]
  };
  class Collector;
  template <std::size_t nodes>
  class Sums;

  /// Cells that have light but no beam have the times of those beside, faces those of their cells.
  void fill_gaps();
  /// [bundle][factor].
  static std::vector<double> factors_of(const Place& place, const DelayFactors& factors);
  void set_cell(CellIndex cell, const DelayFactors& factors, UncollidedField& field) const;
  void set_face(FaceIndex face, const DelayFactors& factors, UncollidedField& field) const;

  const PathTimes& times_;
  const UncollidedField& steady_;
  std::size_t bands_;
  std::vector<Place> cells_;
  std::vector<Place> faces_;
};

}  // namespace etendue
