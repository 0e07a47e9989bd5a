// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "solver/picture/band_color.h"
#include "solver/sensors/wall_bake.h"

namespace etendue {

/// Numbers at the vertices of walls, and the colours that they are shown in.
struct BakedSurface {
  const WallSurface& surface;
  std::vector<std::string> names;   ///< of the numbers, e.g. "irradiance_red"
  std::vector<double> values;       ///< [vertex][name]
  std::vector<LinearColor> colors;  ///< [vertex], exposed: 1 is white
  std::string comment;              ///< what the numbers are
};

/// The bytes of a PLY file (binary, little-endian): positions, normals, colours of sRGB in 8 bits, and the
/// numbers as 32-bit floating point.
std::string ply_bytes(const BakedSurface& baked);

/// The bytes of a glTF 2.0 file (.glb): positions, normals, and linear vertex colours from 0 to 1, to be
/// shown as they are (KHR_materials_unlit). The case's z axis points up.
std::string glb_bytes(const BakedSurface& baked);

}  // namespace etendue
