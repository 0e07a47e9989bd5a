// SPDX-License-Identifier: AGPL-3.0-or-later
//
// What one core of this machine can do at most: numbers read from its caches and from memory, and additions
// and multiplications in its widest registers. The roofs of scripts/draw_roofline.
#include <benchmark/benchmark.h>

#include "solver/transport/state/aligned_array.h"

namespace etendue {
namespace {

constexpr int lanes = 8;
typedef double Wide __attribute__((vector_size(lanes * sizeof(double))));

/// Chains of operations that do not wait for each other: more than a core has in flight.
constexpr int chains = 12;

#define ETENDUE_WIDEST __attribute__((target_clones("default", "avx2", "avx512f"), noinline))

ETENDUE_WIDEST double sum_of(const double* from, std::size_t size) {
  Wide sum[4] = {};
  for (std::size_t i = 0; i + 4 * lanes <= size; i += 4 * lanes)
    for (int k = 0; k < 4; ++k) sum[k] += *reinterpret_cast<const Wide*>(from + i + k * lanes);
  return sum[0][0] + sum[1][0] + sum[2][0] + sum[3][0];
}

ETENDUE_WIDEST double multiply_and_add(double factor, double summand, int rounds) {
  Wide products[chains];
  Wide sums[chains] = {};
  for (Wide& product : products) product = factor - Wide{};
  for (int r = 0; r < rounds; ++r)
    for (int k = 0; k < chains; ++k) {
      products[k] *= factor;
      sums[k] += summand;
    }
  double total = 0;
  for (int k = 0; k < chains; ++k) total += products[k][0] + sums[k][0];
  return total;
}

void read(benchmark::State& bench) {
  const auto bytes = static_cast<std::size_t>(bench.range(0)) << 10;
  const AlignedArray numbers(bytes / sizeof(double));
  for (auto _ : bench) benchmark::DoNotOptimize(sum_of(numbers.data(), numbers.size()));
  bench.counters["bytes"] =
      benchmark::Counter(static_cast<double>(bytes), benchmark::Counter::kIsIterationInvariantRate);
}

void compute(benchmark::State& bench) {
  constexpr int rounds = 1000;
  double factor = 1.0000001, summand = 1e-9;
  benchmark::DoNotOptimize(factor);
  benchmark::DoNotOptimize(summand);
  for (auto _ : bench) benchmark::DoNotOptimize(multiply_and_add(factor, summand, rounds));
  bench.counters["flops"] =
      benchmark::Counter(2.0 * chains * lanes * rounds, benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK(read)->ArgName("KiB")->Arg(512)->Arg(8 << 10)->Arg(256 << 10);
BENCHMARK(compute);

}  // namespace
}  // namespace etendue

BENCHMARK_MAIN();
