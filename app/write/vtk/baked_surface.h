// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/case/case.h"
#include "solver/observe/bake/wall_atlas.h"
#include "solver/observe/bake/wall_bake.h"
#include "solver/observe/color/band_color.h"

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

/// The same numbers as a texture: an atlas, and the numbers and colours of its texels.
struct BakedTexture {
  const WallSurface& surface;
  const WallAtlas& atlas;
  std::vector<std::string> names;
  std::vector<double> values;       ///< [texel][name]
  std::vector<LinearColor> colors;  ///< [texel], exposed: 1 is white
  std::string comment;
};

/// The texture as a picture: PNG, what shows no wall black.
std::string texture_png(const BakedTexture& baked);
/// Its numbers: OpenEXR, a channel for each name, NaN where there is no wall.
std::string texture_exr(const BakedTexture& baked);
/// The bytes of a glTF 2.0 file (.glb) with the texture in it and coordinates for it, without vertex colours.
std::string textured_glb_bytes(const BakedTexture& baked);

/// baked.vtp: positions, normals and numbers of a baked surface, for VTK. `path` is written, `shown` is named
/// in a FileError.
void write_baked(const BakedSurface& baked, const std::string& unit, const Case& input,
                 const std::filesystem::path& path, const std::filesystem::path& shown);

}  // namespace etendue
