// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Processor time of a whole transport sweep (source from moments, walls, moments out) per cell, direction and
// band, on unit cubes by TetGen with 128 directions. Run with --benchmark_filter to choose.
#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <memory>

#include "solver/solution/added_extinction.h"
#include "solver/transport/sweep/transport_sweep.h"
#include "tests/benchmark/hardware_counts.h"
#include "tests/benchmark/unit_cube.h"

namespace etendue {
namespace {

const TetrahedralMesh& cube(double max_volume) {
  static std::map<double, std::unique_ptr<TetrahedralMesh>> meshes;
  auto& mesh = meshes[max_volume];
  if (!mesh) mesh = std::make_unique<TetrahedralMesh>(unit_cube(max_volume));
  return *mesh;
}

/// The figures of the experiment that showed what is possible on two Zen 5 cores, one thread, with eight
/// cells in the lanes or bands [ns].
const std::map<int, double> experiment = {{1, 8.5}, {8, 4.0}, {16, 2.6}};

/// Bytes of record, fluence and slots that one visit reads and writes, for each band.
template <class Real>
double bytes_per_band(int bands) {
  const auto stride = static_cast<std::size_t>(lane_stride(bands));
  const std::size_t record = record_layout(Basis::linear, static_cast<int>(stride), scalar_of<Real>).length;
  const std::size_t fluence = 2 * 4 * stride, slots = (4 * 3 + 4) * stride;
  return static_cast<double>((record + fluence + slots) * sizeof(Real)) / bands;
}

/// Additions, multiplications and divisions of a visit for each band: those of its projected areas are shared
/// by all bands, then come four inflows, the solution and the sum (cell_balance.h).
double flops_per_band(int bands) { return 4 * 12 + 48 + 8 + 41.0 / bands; }

/// The moments of Henyey and Greenstein with g = 0.5 up to a degree.
PhaseFunction forward(int degree) {
  PhaseLegendre phase;
  for (int l = 1; l <= degree; ++l) phase.moments.push_back(std::pow(0.5, l));
  return phase;
}

/// Makes a sweep of double or float.
template <class Real>
TransportSweepOf<Real> make_sweep(const Problem& problem, const DirectionSet& directions,
                                  std::span<const double> extinction, const SolveOptions& options) {
  if constexpr (scalar_of<Real> == Scalar::double_precision)
    return TransportSweep(problem, directions, extinction, options);
  else
    return TransportSweepOf<Real>(TransportSweep(problem, directions, extinction, options));
}

/// `is_complex`: two bands are one complex radiance.
template <class Real>
void sweep_of(benchmark::State& bench, double max_volume, int degree, bool is_complex = false) {
  const int bands = static_cast<int>(bench.range(0));
  const TetrahedralMesh& mesh = cube(max_volume);
  const Problem problem = smoke(mesh, bands, forward(degree));
  const DirectionSet directions = directions_product(8);
  std::vector<double> extinction(static_cast<std::size_t>(mesh.cell_count() * bands), 1.5);
  const AddedExtinction added{std::vector<double>(extinction.size() / 2, 0.3),
                              std::vector<double>(extinction.size() / 2, 0.7)};
  SolveOptions options;
  options.threads = static_cast<int>(bench.range(1));
  if (is_complex) options.added_extinction = &added;
  auto transport = make_sweep<Real>(problem, directions, extinction, options);
  TransportState last(transport.layout());
  TransportState next(transport.layout());
  transport.apply(last, next);
  const double before = transport.processor_seconds();
  const HardwareCounts counts;
  for (auto _ : bench) transport.apply(last, next);
  const auto [cycles, instructions] = counts.read();
  const double visits = static_cast<double>(mesh.cell_count()) * directions.count() * bands;
  const double sweeps = static_cast<double>(transport.band_sweep_count() / bands - 1);
  const double ns = 1e9 * (transport.processor_seconds() - before) / sweeps / visits;
  bench.counters["cells"] = mesh.cell_count();
  bench.counters["cpu_ns"] = ns;
  bench.counters["wall_ns"] = benchmark::Counter(
      visits * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  bench.counters["bytes"] = bytes_per_band<Real>(bands);
  bench.counters["flops"] = flops_per_band(bands);
  bench.counters["orders_in_sweeps"] = transport.order_seconds() / (ns * 1e-9 * visits) * transport.threads();
  if (degree == 0 && experiment.contains(bands)) bench.counters["of_experiment"] = experiment.at(bands) / ns;
  if (cycles > 0) {
    bench.counters["cycles"] = static_cast<double>(cycles) / sweeps / visits;
    bench.counters["instructions"] = static_cast<double>(instructions) / sweeps / visits;
  }
  bench.SetLabel(transport.instruction_set());
}

void sweep(benchmark::State& bench, double max_volume, int degree) {
  sweep_of<double>(bench, max_volume, degree);
}

void single_sweep(benchmark::State& bench, double max_volume, int degree) {
  sweep_of<float>(bench, max_volume, degree);
}

void arguments(benchmark::internal::Benchmark* bench, const std::vector<int>& band_counts) {
  bench->ArgNames({"bands", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
  for (const int bands : band_counts)
    for (const int threads : {1, 2}) bench->Args({bands, threads});
}

void all_bands(benchmark::internal::Benchmark* bench) { arguments(bench, {1, 2, 3, 8, 16}); }
void few_bands(benchmark::internal::Benchmark* bench) { arguments(bench, {1, 3}); }
void paired_bands(benchmark::internal::Benchmark* bench) { arguments(bench, {2, 4, 16}); }
void one_band(benchmark::internal::Benchmark* bench) { arguments(bench, {1}); }

void complex_sweep(benchmark::State& bench, double max_volume, int degree) {
  sweep_of<double>(bench, max_volume, degree, true);
}
void complex_single_sweep(benchmark::State& bench, double max_volume, int degree) {
  sweep_of<float>(bench, max_volume, degree, true);
}

BENCHMARK_CAPTURE(sweep, 12k, 2.25e-4, 0)->Apply(all_bands);
BENCHMARK_CAPTURE(sweep, 60k, 3.4e-5, 0)->Apply(all_bands);
BENCHMARK_CAPTURE(sweep, 60k_degree_3, 3.4e-5, 3)->Apply(few_bands);
BENCHMARK_CAPTURE(sweep, 60k_degree_5, 3.4e-5, 5)->Apply(few_bands);
BENCHMARK_CAPTURE(sweep, 200k, 1e-5, 0)->Apply(all_bands);
BENCHMARK_CAPTURE(sweep, 1M, 2e-6, 0)->Apply(one_band);
BENCHMARK_CAPTURE(single_sweep, 60k, 3.4e-5, 0)->Apply(all_bands);
BENCHMARK_CAPTURE(single_sweep, 60k_degree_3, 3.4e-5, 3)->Apply(few_bands);
BENCHMARK_CAPTURE(complex_sweep, 60k, 3.4e-5, 0)->Apply(paired_bands);
BENCHMARK_CAPTURE(complex_sweep, 60k_degree_5, 3.4e-5, 5)->Apply(paired_bands);
BENCHMARK_CAPTURE(complex_single_sweep, 60k, 3.4e-5, 0)->Apply(paired_bands);

}  // namespace
}  // namespace etendue

BENCHMARK_MAIN();
