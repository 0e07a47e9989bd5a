// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/photons/solve/solve_photons.h"

namespace etendue {

/// Number of a wall.
inline std::size_t wall_of(const TetrahedralMesh& mesh, const char* name) {
  return static_cast<std::size_t>(std::ranges::find(mesh.wall_names(), name) - mesh.wall_names().begin());
}

inline PhotonSolution solved(const Problem& problem, double photons, const BatchReader& reader = {},
                             int threads = 2) {
  const CellLocator locator(problem.mesh());
  PhotonOptions options;
  options.photons = photons;
  options.threads = threads;
  return solve_photons(problem, locator, options, {}, reader);
}

/// Mean square of what the means of cells are off one radiance everywhere, in their errors.
inline double mean_square_off(const PhotonSolution& found, double radiance) {
  double square = 0;
  const auto& means = found.sums.cell_means;
  for (std::size_t c = 0; c < means.size(); ++c)
    square += std::pow((means.mean(c) - 4 * std::numbers::pi * radiance) / means.error(c), 2);
  return square / static_cast<double>(means.size());
}

/// What a run of it is refused with; empty: it is not.
inline std::string refusal_of(const Problem& problem) {
  try {
    solved(problem, 100);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace etendue
