// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Ray-cell steps per second of processor time on one core: rays from one point to the middles of all cells of
// unit cubes by TetGen, cell after cell as the light of a lamp is computed, with the optical depth added up.
#include <benchmark/benchmark.h>

#include "base/parallel/processor_timer.h"
#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "mesh/tetrahedra/search/ray_mesh.h"

namespace etendue {
namespace {

void rays_to_a_lamp(benchmark::State& bench, double max_volume) {
  Geometry geometry;
  BoxPrimitive box;
  box.region = "cube";
  geometry.primitives.emplace_back(box);
  const TetrahedralMesh mesh(tetrahedralize(arrange(geometry), {{max_volume}, 1.4, {}}));
  const RayMesh rays(mesh);
  const std::vector<double> extinction(static_cast<std::size_t>(mesh.cell_count()), 1.5);
  const Vec3 lamp(0.5, 0.5, 0.95);
  double steps = 0;
  const double start = processor_seconds();
  for (auto _ : bench)
    for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
      const Vec3 from = mesh.centroid(CellIndex(c));
      const double distance = (lamp - from).norm();
      double depth = 0;
      rays.walk(CellIndex(c), from, (lamp - from) / distance, distance, [&](CellIndex cell, double length) {
        depth += extinction[cell.at()] * length;
        ++steps;
      });
      benchmark::DoNotOptimize(depth);
    }
  bench.counters["cells"] = mesh.cell_count();
  bench.counters["million_steps_per_second"] = 1e-6 * steps / (processor_seconds() - start);
  bench.counters["steps_per_ray"] = steps / (static_cast<double>(bench.iterations()) * mesh.cell_count());
}

BENCHMARK_CAPTURE(rays_to_a_lamp, 12k, 2.25e-4)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(rays_to_a_lamp, 100k, 2e-5)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace etendue

BENCHMARK_MAIN();
