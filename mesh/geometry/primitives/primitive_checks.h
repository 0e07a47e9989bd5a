// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "base/errors.h"
#include "mesh/geometry/primitives/geometry.h"

namespace etendue {

/// Throws InputError with every primitive and patch that has no volume, no area, no finite coordinates or
/// no name, each with its origin.
void check_primitives(const Geometry& geometry);

/// What is shared by all primitives.
const PrimitiveBase& base_of(const Primitive& primitive);

/// `[x, y, z]` with as many digits as needed to read the same point again.
std::string text_of(const Vec3& point);

/// A patch that names nothing: no boundary facet lies in it.
Fault patch_covers_nothing(const Patch& patch);

}  // namespace etendue
