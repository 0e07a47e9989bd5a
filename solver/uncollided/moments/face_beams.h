// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>

#include "solver/uncollided/sources/light_source.h"

namespace etendue {

/// The beams of all sources that arrive at the corners of a boundary face: the fluence of each is its
/// irradiance there. Light that falls between the corners counts at each of them, with its mean over parts of
/// the face; a corner that is dark has the beams of the unshaded sources, or those of the other corners.
std::array<LightBeams, 3> beams_at_corners(const LightPaths& paths, FaceIndex face,
                                           const LightSources& sources);

}  // namespace etendue
