// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/write/csv/sensor_rows.h"
#include "app/write/result/run_result.h"
#include "solver/observe/sensors/glare.h"

namespace etendue {

/// Glare of an observer.
struct GlareRating {
  std::vector<double> luminance;     ///< [row][column] of the view [cd/m^2]; NaN outside of its circle
  std::vector<GlareSource> sources;  ///< in view, then suns and points
  double eye_illuminance = 0;        ///< on the plane across the view [lx]
  double background_luminance = 0;   ///< illuminance at the eye without the sources, over pi [cd/m^2]
};

/// Rates what an observer sees. Suns are sources of 0.533 degrees, and lamps without an extent have the
/// projected area of 0.005 m^2 of the small sources of CIE 147:2002.
GlareRating rate_glare(const RunResult& result, const SensorRow& row);

/// Rows of sensors.csv: `background_luminance`, `glare_sources` (their number), `ugr` and `dgp`.
std::vector<SensorTableRow> glare_rows(const RunResult& result, const SensorRow& row);

/// source,x,y,z,luminance,solid_angle,position_index: directions to the sources, in cd/m^2 and sr.
std::string glare_csv(const GlareRating& rating);

/// The view in false colors of its luminance, on a logarithmic scale.
std::string glare_png(const GlareRating& rating, int across);

}  // namespace etendue
