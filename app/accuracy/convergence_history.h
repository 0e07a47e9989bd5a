// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace etendue {

/// How numbers changed when cells, or directions, became finer.
struct RefinementChange {
  double coarse = 0, fine = 0;  ///< size before and after, in any one unit
  std::vector<double> changes;  ///< [number]
};

/// Changes of numbers under refinements of one kind, and the errors that follow from them: the grid
/// convergence index (Roache 1994, J. Fluids Eng. 116, 405), 3 times Richardson's estimate at the highest
/// order after one refinement, 1.25 times that at the observed order after more. Half of what
/// the refinement before the last leaves to expect counts too, as a change may be small by chance.
class ConvergenceHistory {
 public:
  /// A change of size by less than a quarter says little: it counts with the next one.
  void add(RefinementChange change);
  bool is_known() const { return !changes_.empty(); }

  /// [number] of values at a size, where errors fall at best with this power of it. At least one change is
  /// known.
  std::vector<double> errors(double size, double highest_order) const;

 private:
  std::vector<RefinementChange> changes_;    ///< from coarse to fine
  std::optional<RefinementChange> pending_;  ///< that counts with the next one
};

/// Order of convergence that two changes of one number show, the later from `second.coarse` on, within
/// limits: (first.coarse^p - first.fine^p) / (second.coarse^p - second.fine^p) = |first change / second
/// change|.
double observed_order(const RefinementChange& first, const RefinementChange& second, std::size_t number,
                      double lowest, double highest);

}  // namespace etendue
