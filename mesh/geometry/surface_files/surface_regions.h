// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/geometry/primitives/enclosed_parts.h"
#include "mesh/geometry/primitives/surface_complex.h"
#include "mesh/geometry/surface_files/surface_file.h"

namespace etendue {

/// The parts that facets shut in, and which region fills each.
struct FilledParts {
  std::vector<EnclosedPart> parts;
  std::vector<int> depth;   ///< [part] how many parts are around it, itself included
  std::vector<int> region;  ///< [part] index into region names; -1: void
};

/// Gives parts the regions of `options` by their points. Throws InputError for a point that lies in no part
/// or in the part of another region.
FilledParts fill_parts(const std::vector<Vec3>& points, const std::vector<SidedFacet>& facets,
                       const SurfaceFileOptions& options, std::vector<std::string>& region_names);

/// Adds a seed for each filled part and a hole point for each void one.
void add_part_points(const FilledParts& filled, SurfaceComplex& surface);

}  // namespace etendue
