// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "base/errors.h"
#include "base/log.h"
#include "mesh/geometry/primitives/surface_complex.h"
#include "mesh/tetrahedra/raw_mesh.h"

namespace etendue {

struct TetrahedraOptions {
  /// [region] largest cell [length^3]; 0: no bound; empty: no bounds. TetGen's closing optimisation may
  /// exceed it by some percent.
  std::vector<double> max_volume;
  double quality = 1.4;  ///< largest ratio of circumradius to shortest edge
  Origin origin;         ///< of the mesh in the case, for messages
  /// About the largest number of cells; 0: a million more than the bounds ask for, and more for a surface
  /// of very many points.
  int max_cells = 0;
};

/// More cells than the memory or the options allow: no other surface of the same geometry needs fewer.
struct TooManyCells : InputError {
  using InputError::InputError;
};

/// Fills a surface with tetrahedra by TetGen (Si 2015). Throws InputError where TetGen cannot mesh the
/// surface, saying what to do; where the bounds ask for more cells than the memory of the machine holds; and,
/// with the place, where details of the surface ask for more cells than the options allow. What TetGen prints
/// goes to the log.
RawMesh tetrahedralize(const SurfaceComplex& surface, const TetrahedraOptions& options, const Log& log = {});

}  // namespace etendue
