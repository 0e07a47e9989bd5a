// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/eye_check.h"

#include <string>

#include "solver/observe/color/photometry.h"

namespace etendue {

void check_seen_by_eye(const Case& input, Faults& faults) {
  std::string why;
  if (!Photometry(input.bands).known())
    why = "needs bands that the eye sees; use bands.edges, or bands called red, green and blue";
  else if (!si_scale(input.units.length, input.units.power))
    why = "needs units of the SI; use units.length of m, cm, mm or km and units.power of W or mW";
  if (why.empty()) return;
  for (const SensorCase& sensor : input.sensors)
    if (sensor.sensor.kind == SensorKind::glare)
      faults.push_back(fault_at(sensor.origin, "", "glare " + why));
  for (const CameraCase& camera : input.cameras)
    if (camera.false_color && camera.false_color->quantity == FalseColorQuantity::luminance)
      faults.push_back(
          fault_at(camera.origin, "", "false_color: luminance " + why + ", or quantity = \"radiance\""));
}

}  // namespace etendue
