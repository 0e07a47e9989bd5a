// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "app/write/result/output_folder.h"
#include "app/write/result/run_result.h"

namespace etendue {

/// sensor,band,quantity,uncollided,collided,value,unit,error
std::string sensors_csv(const RunResult& result);

/// A line for a person from each sensor and band.
std::string sensors_text(const RunResult& result);

/// Adds sensors.csv where the case has sensors, and of each grid NAME.grid.csv
/// (column,row,x,y,z,band,uncollided,collided,irradiance) and NAME.grid.exr, the first row on top, with the
/// channels `irradiance.BAND` and `uncollided.BAND`; of intensities NAME.intensity.csv, NAME.intensity.svg
/// and, where it can be given in candela, NAME.ies.
void add_sensor_files(const RunResult& result, OutputFolder& folder);

}  // namespace etendue
