// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "app/case/case.h"
#include "app/readings/ordinate_sensor_tally.h"
#include "app/write/result/run_result.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/observe/sensors/sensor_reading.h"

namespace etendue {

/// Throws InputError with each sensor of which nothing lies in the mesh or that names what the mesh does not
/// have.
void check_sensors(const std::vector<SensorCase>& sensors, const CellLocator& locator,
                   const Problem& problem);

/// What sensors look at; `rays` may be empty where all sensors read ordinates.
struct SensorScene {
  const LightSetup& lights;
  const OrdinateSensorTally& ordinates;
  const SolveOptions& options;
  const Solution& solution;
  const std::optional<RayRadiance>& rays;
  const CellLocator& locator;
};

/// What the sensors show; they must have been checked. Where the observer stops it, the sensors that were not
/// read are left out.
std::vector<SensorRow> read_sensors(const std::vector<SensorCase>& sensors, const SensorScene& scene,
                                    const StageObserver& observer = {});

}  // namespace etendue
