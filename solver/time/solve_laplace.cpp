// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/solve_laplace.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "base/parallel/thread_count.h"
#include "solver/solution/mean_solution.h"
#include "solver/transport/solve/solve.h"
#include "solver/transport/solve/transport_solver.h"
#include "solver/uncollided/first_collision/first_collision.h"

namespace etendue {
namespace {

/// Real and imaginary parts of all bands and rates that are swept together: with more of them a cell's
/// numbers leave the cache.
constexpr std::size_t most_parts = 16;
/// Vectors that a cycle has at least: with fewer it begins anew too often.
constexpr double wanted_vectors = 8;

bool has_memory(const Problem& problem, const DirectionSet& directions, std::size_t rates,
                const SolveOptions& options) {
  const std::vector<std::complex<double>> any(rates, 0.0);
  const Slowness slowness(problem.mesh().region_names().size(), 0);
  const LaplaceProblem laplace = laplace_problem(problem, any, slowness);
  return longest_cycle(laplace.problem, directions, options) >= wanted_vectors;
}

}  // namespace

std::size_t rates_side_by_side(const Problem& problem, const DirectionSet& directions, std::size_t rates,
                               const SolveOptions& options) {
  std::size_t together = std::max<std::size_t>(
      1, std::min(rates, most_parts / (2 * static_cast<std::size_t>(problem.band_count()))));
  while (together > 1 && !has_memory(problem, directions, together, options)) together /= 2;
  return together;
}

void solve_laplace(const Problem& problem, const std::vector<DirectionSet>& sets,
                   std::span<const std::complex<double>> rates, const Slowness& slowness,
                   const SolveOptions& options, const SolvedRatesReader& reader,
                   const SolveObserver& observer, const UncollidedInTime* uncollided) {
  const Problem& swept = uncollided != nullptr ? uncollided->remaining() : problem;
  const std::size_t together = rates_side_by_side(problem, sets.front(), rates.size(), options);
  std::vector<std::shared_ptr<const SweepOrders>> orders(sets.size());
  for (std::size_t first = 0; first < rates.size(); first += together) {
    const std::size_t count = std::min(together, rates.size() - first);
    const std::span<const std::complex<double>> own_rates = rates.subspan(first, count);
    const LaplaceProblem laplace = laplace_problem(swept, own_rates, slowness);
    std::optional<UncollidedValues> unswept;
    if (uncollided != nullptr) unswept = uncollided->at(delay_factors(own_rates));
    const RayMatter by_direction(laplace.problem);
    SolveOptions own = options;
    own.added_extinction = &laplace.extinction;
    own.angular_input = nullptr;
    own.initial = nullptr;
    own.keep_ordinates.clear();
    MeanSolution mean;
    for (std::size_t i = 0; i < sets.size(); ++i) {
      std::optional<FirstCollision> first_collision;
      if (unswept)
        own.angular_input = &first_collision.emplace(laplace.problem, by_direction, unswept->field, sets[i],
                                                     thread_count(options.threads));
      // The last few rates have fewer bands.
      TransportSolver solver(laplace.problem, sets[i], own, count == together ? orders[i] : nullptr);
      if (count == together) orders[i] = solver.orders();
      const Solution on_set = solver.solve(observer);
      mean.add(on_set);
      if (on_set.interrupted) break;
    }
    const Solution solution = std::move(mean).take();
    if (!reader({first, count, laplace.problem, solution, unswept ? &*unswept : nullptr})) return;
  }
}

}  // namespace etendue
