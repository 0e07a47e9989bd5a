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
};

/// Fills a surface with tetrahedra by TetGen (Si 2015). Throws InputError where TetGen cannot mesh the
/// surface, saying what to do. What TetGen prints goes to the log.
RawMesh tetrahedralize(const SurfaceComplex& surface, const TetrahedraOptions& options, const Log& log = {});

}  // namespace etendue
