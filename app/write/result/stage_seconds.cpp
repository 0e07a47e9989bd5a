// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/stage_seconds.h"

namespace etendue {

std::vector<std::pair<std::string, double>> stage_seconds(const RunResult& result, double writing) {
  const RunSeconds& run = result.seconds;
  const SolveSeconds& solve = result.solution.seconds;
  std::vector<std::pair<std::string, double>> stages = {
      {"read", run.read}, {"mesh", run.mesh}, {"setup", run.setup}};
  const auto add = [&](const char* name, double seconds) { stages.emplace_back(name, seconds); };
  if (result.radiosity) {
    add("factors", result.radiosity->factor_seconds);
    add("solution", result.radiosity->solve_seconds);
    add("fields", result.radiosity->field_seconds);
  } else if (result.errors) {
    add("histories", solve.sweep);
  } else {
    stages.back().second += solve.setup;
    add("lights", solve.lights);
    add("orders", solve.orders);
    add("sweep", solve.sweep);
    add("low_order_setup", solve.low_order_setup);
    add("low_order", solve.low_order - solve.low_order_setup);
  }
  add("rays", run.rays);
  add("probes", run.probes);
  add("sensors", run.sensors);
  add("measures", run.measures);
  if (result.time) add("light_in_time", result.time->seconds);
  add("write", writing);
  add("total", run.total + writing);
  return stages;
}

}  // namespace etendue
