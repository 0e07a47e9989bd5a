// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/compare/kept_run.h"

#include <algorithm>

#include "app/case/temperatures.h"
#include "app/write/csv/sensor_rows.h"
#include "app/write/result/stage_seconds.h"

namespace etendue {
namespace {

/// What is made of the radiometry of a sensor: what the eye sees, and ratios.
bool is_derived(const SensorTableRow& row) {
  return row.quantity.starts_with("uniformity_") || row.quantity.starts_with("daylight_factor") ||
         (row.band == "photopic" && row.quantity != "glare_sources");
}

/// What users ask for: powers of regions and walls, probes and sensors with all that is made of them.
std::vector<AnswerNumber> asked_numbers(const RunResult& run) {
  std::vector<AnswerNumber> numbers;
  for (AnswerNumber& number : steady_numbers(run)) {
    const bool of_region = number.where.starts_with("region ") && number.quantity == "absorbed";
    const bool of_wall = number.where.starts_with("wall ") && number.quantity == "incoming";
    if (of_region || of_wall || number.where.starts_with("probe ")) numbers.push_back(std::move(number));
  }
  const auto add = [&](const SensorTableRow& row) {
    numbers.push_back({"sensor " + row.sensor, row.band, row.quantity, row.value(), row.error});
  };
  for (const SensorRow& sensor : run.sensors) std::ranges::for_each(radiant_rows(run, sensor), add);
  for (const SensorTableRow& row : sensor_rows(run))
    if (is_derived(row)) add(row);
  return numbers;
}

}  // namespace

double change_of(const AnswerNumber& from, const AnswerNumber& to) {
  return to.value == from.value ? 0 : to.value - from.value;
}

KeptRun kept_of(const RunResult& run) {
  KeptRun kept;
  kept.numbers = asked_numbers(run);
  kept.directory = run.input.output.directory;
  kept.method = run.errors ? "photons" : run.radiosity ? "radiosity" : "ordinates";
  if (run.radiosity) kept.larger_patches = coarser_patches(run);
  if (run.errors) kept.histories = run.errors->histories;
  kept.cells = run.problem.mesh().cell_count();
  kept.directions = run.solution.directions;
  kept.tolerance = run.input.solve.tolerance;
  kept.memory = run.expected_memory;
  for (const BandConvergence& band : run.solution.convergence)
    kept.sweeps = std::max(kept.sweeps, band.sweeps);
  for (const auto& [stage, seconds] : stage_seconds(run, 0)) {
    if (stage == "total") kept.seconds = seconds;
    if (stage == "orders" || stage == "sweep" || stage == "low_order") kept.of_directions += seconds;
    if (stage == "probes" || stage == "sensors") kept.of_points += seconds;
  }
  if (run.input.solve.order == SpaceOrder::constant) kept.order_of_cells = 1;
  kept.is_flat = run.problem.space() != AngularSpace::sphere;
  kept.is_coarse = run.is_coarse;
  // From the temperatures of another run a repetition cannot begin: cells may be others.
  const bool begins_elsewhere = steps_temperatures(run.input) && run.input.initial;
  kept.whole = run.solution.converged() && !run.interrupted() && (!run.time || run.time->converged) &&
               !begins_elsewhere;
  return kept;
}

void agree_on_costs(KeptRun& run, RankGroup* ranks) {
  if (ranks == nullptr) return;
  for (double* cost : {&run.seconds, &run.of_directions, &run.of_points, &run.memory})
    *cost = ranks->of_first(*cost);
  run.whole = !ranks->any(!run.whole);
}

}  // namespace etendue
