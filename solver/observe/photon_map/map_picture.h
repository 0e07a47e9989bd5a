// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/observe/camera/picture.h"
#include "solver/observe/photon_map/map_radiance.h"

namespace etendue {

/// A picture as the photon map has it. Of the camera its samples count, not its shafts and gather.
Picture take_picture(const MapRadiance& map, const Camera& camera, int threads,
                     const StageObserver& observer = {});

}  // namespace etendue
