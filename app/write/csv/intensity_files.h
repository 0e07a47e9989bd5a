// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "app/write/result/run_result.h"

namespace etendue {

// The goniometric diagram of a sensor of kind intensity, as files hold it.

/// polar,azimuth,band,uncollided,collided,intensity; angles in degrees
std::string intensity_csv(const RunResult& result, const SensorRow& row);

/// A polar plot of the sum over the bands: the planes of azimuth 0 and 90 degrees.
std::string intensity_svg(const RunResult& result, const SensorRow& row);

/// An IES file (LM-63-2002, type C, absolute photometry) of the luminous intensity [cd]; empty where the eye
/// does not see the bands or units are not those of the SI.
std::string intensity_ies(const RunResult& result, const SensorRow& row);

}  // namespace etendue
