// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Two whole sweeps of a small cube with one, three and eight bands, for scripts/count_instructions: run under
// callgrind, which counts what happens inside TransportSweep::apply. Prints the visits of cells.
#include <cstdio>
#include <cstdlib>

#include "solver/transport/sweep/transport_sweep.h"
#include "tests/benchmark/unit_cube.h"

int main(int count, char** arguments) {
  using namespace etendue;
  const int bands = count > 1 ? std::atoi(arguments[1]) : 1;
  const TetrahedralMesh mesh = unit_cube(1e-3);
  const DirectionSet directions = directions_product(4);
  const Problem problem = smoke(mesh, bands, 0);
  const std::vector<double> extinction(static_cast<std::size_t>(mesh.cell_count() * bands), 1.5);
  SolveOptions options;
  options.threads = 1;
  TransportSweep sweep(problem, directions, extinction, options);
  TransportState last(sweep.layout());
  TransportState next(sweep.layout());
  sweep.apply(last, next);
  sweep.apply(next, last);
  std::printf("%ld\n", 2L * mesh.cell_count() * directions.count());
}
