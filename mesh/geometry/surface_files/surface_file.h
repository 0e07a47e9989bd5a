// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "base/errors.h"
#include "base/log.h"
#include "base/up_axis.h"
#include "base/vec3.h"
#include "mesh/geometry/primitives/surface_complex.h"

namespace etendue {

struct SurfaceFileOptions {
  double scale = 1;  ///< multiplies the coordinates
  std::map<std::string, Vec3>
      regions;            ///< name and a point inside, after scaling; empty: one region "domain"
  Origin origin;          ///< of the key that names the file
  UpAxis up = UpAxis::z;  ///< in the file; the surface has z up, and so have `regions`
};

/// A closed surface: TetGen .poly or .smesh, or STL, OBJ, PLY, OFF. Holes and self-intersections throw
/// InputError with their coordinates. Walls are named by the STL solid, the OBJ group, material or object,
/// the TetGen marker, else "boundary". Open surfaces inside the closed one become sheets with the walls NAME
/// in front, where their corners are seen counterclockwise, and NAME.back behind. Throws FileError where the
/// file cannot be read.
SurfaceComplex read_surface(const std::filesystem::path& path, const SurfaceFileOptions& options,
                            const Log& log = {});

}  // namespace etendue
