// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/memory_forecast.h"

#include <cmath>

#include "app/case/build/build.h"
#include "app/case/temperatures.h"
#include "app/case/volume_bounds.h"
#include "app/run/check_run.h"
#include "app/run/methods/photon_memory.h"
#include "app/setup/memory.h"
#include "app/setup/run_context.h"
#include "app/time/heat_steps.h"
#include "app/time/solve_in_time.h"

namespace etendue {
namespace {

/// The largest volume that cells may have is about this many times their mean volume: in a cube of 3,000 to
/// 137,000 cells 2.8 to 2.0 times.
constexpr double bound_in_means = 2;
/// Meshes with more cells need memory for little else than cells.
constexpr int many_cells = 20000;

RunMemory run_memory(const Case& input, const Problem& problem) {
  return input.photons ? photon_run_memory(input, problem)
                       : directions_run_memory(input, problem, OrdinatesSetup(input, problem));
}

}  // namespace

RunMemory directions_run_memory(const Case& input, const Problem& problem, const OrdinatesSetup& setup) {
  RunMemory memory = setup.memory();
  if (!input.time) return memory;
  if (steps_temperatures(input)) {
    const std::size_t steps = heat_steps_memory(input, problem, setup.options);
    memory.solving += steps;
    memory.expected += steps;
    return memory;
  }
  return larger_of(std::move(memory), time_memory({input, problem, setup.directions.sets, setup.options,
                                                   setup.locator, setup.lights}));
}

std::string expected_memory_text(const RunMemory& memory, const Case& input, const Problem& coarse,
                                 const Log& log) {
  const double cells = expected_cells(input.mesh, coarse.mesh()), known = coarse.mesh().cell_count();
  const auto solving = static_cast<double>(memory.solving);
  double by_cell = solving / known;
  if (known < many_cells) {
    Case finer = with_coarsest_cells(input);
    finer.mesh.refine = 1;
    const TetrahedralMesh mesh = build_mesh(finer, log);
    const Problem problem = build_problem(input, mesh);
    by_cell =
        (static_cast<double>(run_memory(input, problem).solving) - solving) / (mesh.cell_count() - known);
  }
  return check_expected_memory(solving + by_cell * (cells - known), cells, coarse.band_count(), "");
}

double expected_cells(const MeshCase& wanted, const TetrahedralMesh& coarse) {
  const std::vector<double> bounds = volume_bounds(wanted, coarse.region_names());
  double cells = coarse.cell_count();
  for (std::int32_t c = 0; c < coarse.cell_count(); ++c) {
    const CellIndex cell(c);
    const double bound = bounds[static_cast<std::size_t>(coarse.region(cell))];
    if (bound > 0) cells += bound_in_means * coarse.volume(cell) / bound;
  }
  return std::ldexp(cells, 3 * wanted.refine);
}

}  // namespace etendue
