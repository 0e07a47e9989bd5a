// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solver/problem/problem.h"
#include "solver/radiosity/patches/wall_patches.h"
#include "solver/radiosity/solve/radiosity_equation.h"

namespace etendue {

/// Light on the triangles of patches, the same all over each patch.
struct PatchLight {
  std::vector<TriangleCorners> triangles;  ///< counterclockwise seen from the domain
  std::vector<std::int32_t> walls;         ///< [triangle]
  std::vector<std::int32_t> patches;       ///< [triangle]
  std::vector<double> irradiance;          ///< [triangle][band] [power/length^2]
  /// [triangle][band] pi L + rho H + tau H(behind) + what is redirected [power/length^2]
  std::vector<double> exitance;
};

PatchLight light_on_patches(const Problem& problem, const WallPatches& patches, const RadiosityState& state);

/// Returns whether some patch is a part of a face, so that means over faces say less.
bool are_finer_than_faces(const WallPatches& patches);

}  // namespace etendue
