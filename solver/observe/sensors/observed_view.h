// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/parallel/stage_observer.h"
#include "solver/observe/radiance/ray_radiance.h"
#include "solver/observe/sensors/measurement.h"
#include "solver/observe/sensors/sensor.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue {

/// Rays that observe_view() takes: one in each pixel of the circle.
std::size_t rays_of_view(const Sensor& sensor);

/// What an observer at a place sees of the half space ahead, sensor.count[0] pixels across; counts its rays
/// and may be stopped, and is then not whole. The same bits for any number of threads.
ObservedView observe_view(const LightSetup& lights, const RayRadiance& scene, const PointInCell& place,
                          const Sensor& sensor, int threads, StageCounter& counter);

}  // namespace etendue
