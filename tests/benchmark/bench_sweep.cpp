// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Processor time of a whole transport sweep (source from moments, walls, moments out) per cell, direction and
// band, on unit cubes by TetGen with 128 directions. Run with --benchmark_filter to choose.
#include <benchmark/benchmark.h>

#include <map>
#include <memory>

#include "solver/ordinates/transport_sweep.h"
#include "tests/benchmark/unit_cube.h"

namespace etendue {
namespace {

const TetrahedralMesh& cube(double max_volume) {
  static std::map<double, std::unique_ptr<TetrahedralMesh>> meshes;
  auto& mesh = meshes[max_volume];
  if (!mesh) mesh = std::make_unique<TetrahedralMesh>(unit_cube(max_volume));
  return *mesh;
}

void sweep(benchmark::State& bench, double max_volume, double asymmetry) {
  const int bands = static_cast<int>(bench.range(0));
  const TetrahedralMesh& mesh = cube(max_volume);
  const Problem problem = smoke(mesh, bands, asymmetry);
  const DirectionSet directions = directions_product(8);
  std::vector<double> extinction(static_cast<std::size_t>(mesh.cell_count() * bands), 1.5);
  SolveOptions options;
  options.threads = static_cast<int>(bench.range(1));
  TransportSweep transport(problem, directions, extinction, options);
  TransportState last(transport.layout());
  TransportState next(transport.layout());
  for (auto _ : bench) transport.apply(last, next);
  const double visits = static_cast<double>(mesh.cell_count()) * directions.count() * bands;
  bench.counters["cells"] = mesh.cell_count();
  bench.counters["cpu_ns"] = 1e9 * transport.processor_seconds() / transport.sweep_count() / visits;
  bench.counters["wall_ns"] = benchmark::Counter(
      visits * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  bench.counters["orders_s"] = transport.order_seconds();
  bench.SetLabel(transport.instruction_set());
}

void arguments(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"bands", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
  for (const int bands : {1, 3, 8})
    for (const int threads : {1, 2}) bench->Args({bands, threads});
}

BENCHMARK_CAPTURE(sweep, 12k, 2.25e-4, 0.0)->Apply(arguments);
BENCHMARK_CAPTURE(sweep, 60k, 3.4e-5, 0.0)->Apply(arguments);
BENCHMARK_CAPTURE(sweep, 200k, 1e-5, 0.0)->Apply(arguments);
BENCHMARK_CAPTURE(sweep, 60k_henyey_greenstein, 3.4e-5, 0.5)->Apply(arguments);

}  // namespace
}  // namespace etendue

BENCHMARK_MAIN();
