// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/write/result/run_result.h"

namespace etendue {

/// A row of sensors.csv.
struct SensorTableRow {
  std::string sensor;
  std::string band;  ///< "photopic" where bands are summed up as the eye does
  std::string quantity;
  double uncollided = 0;
  double collided = 0;
  double error = 0;
  std::string unit;
  std::string photon_unit = {};  ///< of radiant_rows(): with photons per second in place of power

  double value() const { return uncollided + collided; }
};

/// All that the sensors of a run showed: radiometry as it was measured; where units are those of the SI, u/c
/// and, where bands have edges, photons; and where the eye can see the bands (Photometry), photometry in the
/// units that the case asks for.
std::vector<SensorTableRow> sensor_rows(const RunResult& result);

/// Those of one sensor that have radiant power in them, without what is derived from them.
std::vector<SensorTableRow> radiant_rows(const RunResult& result, const SensorRow& row);

}  // namespace etendue
