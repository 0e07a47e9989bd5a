// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/parallel/stage_observer.h"
#include "solver/observe/radiance/ray_radiance.h"

namespace etendue {

/// Rays start at this part of the distance from the vertex to the middle of a face: at an edge of the room
/// they would not know on which of its sides they stand.
inline constexpr double off_the_vertex = 0.02;

/// Irradiance of walls beside the light that comes straight from lights, sampled by rays from each vertex
/// of each plane of walls (final gathering), in place of the sum over the directions of the set:
///
///     E = integral of L cos over the half range,   L of RayRadiance,
///
/// so that it is free of the directions' rays to the next order. `rays` is a square number; they stand for
/// equal parts of the cosine-weighted half range; each sends `shadow_rays` to the lights where it ends, as in
/// RayView. Nothing for 0 rays. The same bits for any number of
/// threads. The observer is called now and then with the share that is done; false stops it, and nothing
/// comes back.
WallIrradiance gather(const RayRadiance& scene, int rays, int shadow_rays, int threads,
                      const StageObserver& observer = {});

}  // namespace etendue
