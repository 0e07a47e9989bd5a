// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"
#include "solver/uncollided/projection/uncollided_field.h"

namespace etendue {

/// Reflection of uncollided light at glossy walls: with beams k of irradiance E_k at a corner of a face it is
/// reflected into the ordinate m with the radiance
///
///     u_m = E D_m,    D_m = sum over k of E_k f_r(w_k -> w_m) / sum over k of E_k,
///
/// D scaled so that the reflected power, sum over m of w |w.n| D, is exactly the part that the lobe reflects
/// of the beams. E is the P1 projection on the face. Where no ordinate lies in the lobe, the one nearest to
/// the mirrored direction takes it.
class GlossyReflection {
 public:
  /// The arguments must outlive it.
  GlossyReflection(const Problem& problem, const UncollidedField& field, const DirectionSet& directions,
                   int threads);

  /// Adds the radiance [3][band] that a face sends into ordinate m.
  void add(OrdinateIndex m, FaceIndex face, std::span<double> values) const;
  /// Bytes that one takes.
  static std::size_t memory(const Problem& problem, const DirectionSet& directions);

 private:
  void tabulate(std::size_t place, std::size_t corner, std::size_t band);

  const Problem& problem_;
  const UncollidedField& field_;
  const DirectionSet& directions_;
  std::size_t bands_, pairs_;
  std::vector<double> table_;  ///< [glossy face][corner][band][pair of ordinates] [1/sr]
};

}  // namespace etendue
