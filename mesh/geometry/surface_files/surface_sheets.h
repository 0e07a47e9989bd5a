// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "mesh/geometry/primitives/surface_complex.h"
#include "mesh/geometry/surface_files/polygon_soup.h"

namespace etendue {

/// Adds the triangles of open surfaces to a surface whose walls have their names already. The front, from
/// which corners are seen counterclockwise, keeps its wall; the back becomes the wall NAME.back. Throws
/// std::invalid_argument with coordinates where a triangle lies outside of what is filled.
void add_sheets(const OpenSurface& open, SurfaceComplex& surface,
                const std::function<bool(const Vec3&)>& is_filled);

}  // namespace etendue
