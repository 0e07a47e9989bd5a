// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/setup/run_directions.h"

#include <fmt/format.h>

#include "app/case/build/build.h"
#include "app/setup/method_checks.h"
#include "solver/angular/refraction/refraction_weights.h"

namespace etendue {

RunDirections run_directions(const Case& input, const Problem& problem, const LightSetup& lights) {
  require_lights_of_first_collided(input, lights);
  return {build_rotated_directions(input, problem), build_first_collided_directions(input, problem)};
}

const DirectionSet& finest(const RunDirections& directions) {
  return directions.first_collided.empty() ? directions.sets.front() : directions.first_collided.front();
}

std::string directions_line(const RunDirections& directions, const Case& input) {
  const DirectionSet& set = directions.sets.front();
  const std::size_t rotations = directions.sets.size();
  std::string line = fmt::format("directions: {} ({} {}){}", set.count(), set.name(), set.order(),
                                 rotations > 1 ? fmt::format(", {} rotations", rotations) : "");
  if (directions.first_collided.empty()) return line;
  const DirectionSet& first = directions.first_collided.front();
  line += fmt::format(", once {} ({} {}) for light that has collided once", first.count(), first.name(),
                      first.order());
  const std::string& reason = input.first_collided->reason;
  return reason.empty() ? line : line + " (" + reason + ")";
}

std::string refraction_caution(const RunDirections& directions, const Problem& problem) {
  std::string text;
  for (const SmoothPlane& plane : smooth_planes(problem.mesh(), problem.walls()))
    if (!parts_at_critical_angle(directions.sets.front(), plane))
      text += fmt::format(
          "caution: too few directions within the critical angle of walls of refractive_index = {:.4g} with "
          "normal ({:.4g}, {:.4g}, {:.4g}): thin layers may absorb tens of percent too much; use a finer "
          "set\n",
          plane.refractive_index, plane.normal.x(), plane.normal.y(), plane.normal.z());
  return text;
}

}  // namespace etendue
