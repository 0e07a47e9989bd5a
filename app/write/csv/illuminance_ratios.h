// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "app/write/csv/sensor_rows.h"

namespace etendue {

/// Uniformity of a grid in each band, and as the eye sees it: `uniformity_u0`, least over mean, and
/// `uniformity_ud`, least over most (EN 12464-1; EN 12665). Its parts are those of the least irradiance. None
/// where the mean is not positive. `rows` are those of one grid.
std::vector<SensorTableRow> uniformity_rows(const std::vector<SensorTableRow>& rows);

/// Daylight factor [%] for each irradiance or illuminance in `rows`: 100 times its ratio to what the
/// unobstructed sky brings to a horizontal plane (CIE S 017:2020, 17-29-121), which `sky` has for the same
/// bands in the same units. None where the sky is dark.
std::vector<SensorTableRow> daylight_factor_rows(const std::vector<SensorTableRow>& rows,
                                                 const std::vector<SensorTableRow>& sky);

}  // namespace etendue
