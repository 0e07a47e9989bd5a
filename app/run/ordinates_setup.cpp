// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/ordinates_setup.h"

#include "app/case/build/build_heat.h"
#include "app/readings/probes.h"
#include "app/readings/sensors.h"
#include "app/render/pictures.h"

namespace etendue {
namespace {

const Problem& with_known_views(const Case& input, const Problem& problem) {
  check_views(input.cameras, input.sensors, problem);
  return problem;
}

}  // namespace

OrdinatesSetup::OrdinatesSetup(const Case& input, const Problem& problem)
    : lights(with_known_views(input, problem)),
      directions(run_directions(input, problem, lights)),
      locator(problem.mesh()) {
  check_sensors(input.sensors, locator, problem);
  options = run_options(input, set(), place_probes(input.probes, problem.mesh(), locator));
  heat = build_heat(input, problem.mesh());
  if (heat) {
    temperatures = std::make_unique<TemperatureIteration>(problem, *heat);
    options.following_emission = temperatures.get();
  }
  if (input.exact) options.angular_input = &exact.emplace(input, problem, set()).input;
}

void OrdinatesSetup::set_emission(Problem& problem) const {
  if (temperatures) problem.set_following(temperatures->sources());
}

std::optional<HeatSolution> OrdinatesSetup::heat_solution() const {
  if (!temperatures) return std::nullopt;
  return temperatures->solution();
}

Resolution OrdinatesSetup::resolution(const Problem& problem) const {
  Resolution found = resolution_of(problem, finest(directions), locator);
  if (options.order != SpaceOrder::linear || options.lumping != Lumping::automatic) found.thick_count = 0;
  return found;
}

}  // namespace etendue
