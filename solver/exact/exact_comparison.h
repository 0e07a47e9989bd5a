// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/angular/sets/direction_set.h"
#include "solver/exact/exact_radiance.h"
#include "solver/problem/problem.h"
#include "solver/solution/solution.h"

namespace etendue {

/// How far the fluence is from the exact one, relative to the same norm of the exact one.
struct FluenceError {
  double l2 = 0;           ///< by a rule of degree 5 in each cell
  double linf = 0;         ///< at the rule's points and the vertices
  double l2_of_means = 0;  ///< of the means of cells
};

/// What a solution should be.
struct ExactComparison {
  std::vector<FluenceError> fluence;          ///< [band]
  std::vector<std::vector<double>> absorbed;  ///< [region][band] exact [power]
  std::vector<double> incoming;               ///< [wall] exact [power]
};

/// Compares with the radiance integrated over the directions of `set`: the set of the solution shows the
/// error of the discretisation in space alone, a fine set that of the directions too.
ExactComparison compare_with_exact(const Problem& problem, const Solution& solution,
                                   const ExactRadiance& radiance, const DirectionSet& set);

/// The sum of w u over the directions of a set.
double exact_fluence(const ExactRadiance& radiance, const DirectionSet& set, const Vec3& point);

}  // namespace etendue
