// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/setup/run_options.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "app/case/build/build.h"
#include "app/readings/sensors.h"
#include "app/setup/memory.h"
#include "app/setup/run_context.h"
#include "solver/uncollided/first_collision/solve_rotated.h"

namespace etendue {

SolveOptions run_options(const Case& input, const DirectionSet& directions,
                         std::vector<IrradianceMeter> meters) {
  SolveOptions options = input.solve;
  options.threads = thread_count(input);
  options.keep_ordinates = input.output.radiance_ordinates;
  if (need_all_ordinates(input.sensors, directions.space())) {
    options.keep_ordinates.resize(directions.directions().size());
    std::iota(options.keep_ordinates.begin(), options.keep_ordinates.end(), 0);
  }
  options.meters = std::move(meters);
  return options;
}

RunMemory memory_of(const LightSetup& lights, const RunDirections& directions, const SolveOptions& options) {
  return {estimate_rotated_memory(lights, directions.sets, options, directions.first_collided),
          estimate_rotated_memory(lights, directions.sets, options, directions.first_collided,
                                  KrylovVectors::typical),
          matrix_memory_text(lights.problem(), directions.sets.front())};
}

RunMemory larger_of(RunMemory a, RunMemory b) {
  const std::size_t expected = std::max(a.expected, b.expected);
  RunMemory larger = std::move(a.solving < b.solving ? b : a);
  larger.expected = expected;
  return larger;
}

std::string memory_text(const RunMemory& memory, const Problem& problem) {
  return check_memory(memory.solving, problem.mesh(), problem.band_count(), memory.matrices, memory.expected);
}

}  // namespace etendue
