// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/geometry/primitives/surface_complex.h"
#include "mesh/tetrahedra/generation/tetgen_call.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"

namespace etendue {

/// Number of cells that the bounds on volumes ask for; 0 without bounds. The volumes of regions are those of
/// a coarse mesh where many cells are asked for, else the bounding box stands for them.
double asked_cells(const SurfaceComplex& surface, const TetrahedraOptions& options);

/// Throws TooManyCells with the figure where so many cells exceed the memory of the machine or the largest
/// number that the options allow.
void check_cell_count(double cells, const TetrahedraOptions& options);

/// Number of points that TetGen may add to a surface: enough for the cells that are asked for and for many
/// more around details.
int most_added_points(const SurfaceComplex& surface, const TetrahedraOptions& options, double asked_cells);

/// Throws TooManyCells with the place of the finest detail of a mesh to whose surface TetGen might add so
/// many points.
[[noreturn]] void refuse_details(const TetGenMesh& mesh, const SurfaceComplex& surface,
                                 const TetrahedraOptions& options, int most_added);

/// The same where the mesh has more cells than the options allow.
void check_details(const TetGenMesh& mesh, const SurfaceComplex& surface, const TetrahedraOptions& options,
                   int most_added);

}  // namespace etendue
