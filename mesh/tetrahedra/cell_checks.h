// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/tetrahedra/raw_mesh.h"

namespace etendue {

/// Checks what one cell or point shows by itself: there are cells, their vertices exist and differ, and
/// coordinates are finite. Throws InputError.
void check_cells_and_points(const RawMesh& raw);

/// Six times the signed volume, and how far from zero it must be to have a sign.
struct SignedVolume {
  double six_volumes;
  double rounding;
};

/// (p1-p0) x (p2-p0) . (p3-p0) of points of the mesh.
SignedVolume signed_volume(const RawMesh& raw, const std::array<int, 4>& cell);

/// The vertices of each cell, ordered so that (p1-p0) x (p2-p0) . (p3-p0) > 0. Some files have all cells
/// the other way round; that is a convention. Where only some are, they are inverted, and InputError names
/// them, as it names cells without volume.
std::vector<std::array<std::int32_t, 4>> positively_oriented_cells(const RawMesh& raw);

/// Throws InputError where two points that cells use are the same: a mesh that was not stitched.
void check_points_differ(const RawMesh& raw);

}  // namespace etendue
