// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "app/case/case.h"
#include "app/write/results.h"
#include "mesh/tetrahedra/cell_locator.h"
#include "solver/sensors/sensor_reading.h"

namespace etendue {

/// Throws InputError with each sensor of which nothing lies in the mesh.
void check_sensors(const std::vector<SensorCase>& sensors, const TetrahedralMesh& mesh,
                   const CellLocator& locator);

/// What the sensors show; they must have been checked. `scene` may be empty where there are none.
std::vector<SensorRow> read_sensors(const std::vector<SensorCase>& sensors, const LightSetup& lights,
                                    const std::optional<RayRadiance>& scene, const CellLocator& locator,
                                    int threads);

}  // namespace etendue
