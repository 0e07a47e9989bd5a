// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"

namespace etendue {

/// How scattering in one medium and band is discretised, and why.
struct ScatteringTreatment {
  ScatteringBackend backend = ScatteringBackend::moments;  ///< never automatic
  int degree = 0;                                          ///< of the moments; 0: isotropic
  double forward = 0;  ///< part f of the scattered light that the moments count as not scattered (delta-M)
  std::string reason;

  bool is_dense() const { return backend != ScatteringBackend::moments; }
};

/// Bytes of the angular solution in the cells of one medium up to which the automatic choice takes a matrix:
/// a few Krylov vectors of it fit beside each other.
inline constexpr double largest_automatic_dense = 256.0 * 1024 * 1024;

/// [region] bytes of the angular solution in a region, with linear elements.
std::vector<double> angular_bytes(const Problem& problem, const DirectionSet& directions);

/// Bytes of one scattering matrix, which is kept as it is and as the sweep multiplies with it.
double matrix_bytes(const DirectionSet& directions);

/// [region * bands + band].
std::vector<ScatteringTreatment> plan_scattering(const Problem& problem, const DirectionSet& directions);

/// The same media on a set of fewer directions, by moments where `fine` is so: with a lower degree where the
/// set does not resolve that of `fine`, and delta-M in place of what is then left out.
std::vector<ScatteringTreatment> scattering_on_fewer(const Problem& problem, const DirectionSet& directions,
                                                     const std::vector<ScatteringTreatment>& fine);

/// Of all media and bands.
int highest_degree(const std::vector<ScatteringTreatment>& plan);

/// Cells that keep their angular solution: some band in their medium scatters by a matrix.
std::vector<CellIndex> dense_cells(const Problem& problem, const std::vector<ScatteringTreatment>& plan);

}  // namespace etendue
