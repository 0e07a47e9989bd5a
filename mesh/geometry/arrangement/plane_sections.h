// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "mesh/geometry/primitives/exact.h"

namespace etendue {

/// What a convex body or polygon has to do with a plane. A touch is a single edge in it; a single point
/// counts as none.
enum class Contact { kNone, kTouch, kFace, kCut };

/// The contact by the corners of the body or polygon.
Contact contact_of(const ExactPlane& plane, std::span<const ExactPoint> corners);

/// Points where a plane meets the rim of a convex polygon.
std::vector<ExactPoint> section_of(const ExactPlane& plane, std::span<const ExactPoint> ring);

}  // namespace etendue
