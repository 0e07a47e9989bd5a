// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solver/angular/sets/direction_set.h"
#include "solver/materials/kernels/leaf_canopy.h"
#include "solver/problem/problem.h"

namespace etendue {

/// Leaves and flakes as a ray sees them that light goes along in the direction w: with a density d of them in
/// a cell, an extinction d g(w), and of the radiance u_n of ordinates a source
///
///     S(w) = d s(w) (sum over n of w_n k(w_n -> w) u_n) / (sum over n of w_n k(w_n -> w)),
///
/// where s(w) is the integral of k(w' -> w) over w', which for these kernels is what w loses by scattering. A
/// constant radiance scatters into a constant one.
class DirectionalMatter {
 public:
  /// The arguments must outlive it.
  DirectionalMatter(const Problem& problem, const DirectionSet& directions);

  /// What depends on the direction alone, for a density of 1.
  struct View {
    double extinction = 0;        ///< g
    double scattered = 0;         ///< s
    std::vector<double> weights;  ///< [ordinate] w_n k / sum of them
  };
  std::vector<View> views(const Vec3& travel) const;

  /// Which of the views a region and band have; -1 where they have no leaves or flakes.
  int of(int region, std::size_t band) const {
    return number_[static_cast<std::size_t>(region) * bands_ + band];
  }
  double density(CellIndex cell, std::size_t band) const;  ///< [1/length]

 private:
  struct Kind {
    DirectionalScattering scattering;
    LeafNormals normals;  ///< of leaves
    double mean_extinction;
  };

  const Problem& problem_;
  const DirectionSet& directions_;
  std::size_t bands_;
  std::vector<int> number_;  ///< [region][band]
  std::vector<Kind> kinds_;
};

/// Returns whether a ray sees what a medium has instead of a phase function: leaves and flakes, not kernels.
bool is_seen_by_rays(const DirectionalScattering& scattering);

}  // namespace etendue
