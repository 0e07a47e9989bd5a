// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/adjoint/solve_adjoint.h"

#include <utility>

#include "base/parallel/thread_count.h"
#include "base/vector_sums.h"
#include "solver/adjoint/response_source.h"
#include "solver/adjoint/reversed_problem.h"
#include "solver/solution/mean_solution.h"
#include "solver/transport/solve/solve.h"

namespace etendue {
namespace {

using Emitters = std::vector<std::unique_ptr<const EmitterSource>>;

void refuse_directional_absorption(const Problem& problem, const Response& response) {
  const auto* absorbed = std::get_if<AbsorbedPower>(&response);
  if (absorbed == nullptr) return;
  const Medium& medium = problem.medium(absorbed->region);
  for (int b = 0; b < problem.band_count(); ++b)
    if (medium.absorbs_by_direction(b) || medium.is_directional(b))
      throw InputError(
          fault_at(medium.origin, "",
                   "what this medium absorbs depends on the direction of light, and has no adjoint "
                   "in this version"));
}

Solution solve_on(const Emitters& emitters, const Problem& reversed, const DirectionSet& directions,
                  const Response& response, const SolveOptions& wanted, const SolveObserver& observer) {
  const ResponseSource source(reversed, directions, response);
  std::vector<std::unique_ptr<const SweptSource>> paired;
  SolveOptions options = wanted;
  options.angular_input = &source;
  options.meters.clear();
  options.keep_ordinates.clear();
  options.initial = nullptr;
  for (const auto& emitter : emitters) {
    paired.push_back(emitter->on(directions));
    options.paired_sources.push_back(paired.back().get());
  }
  return solve(reversed, directions, options, observer);
}

}  // namespace

std::vector<double> AdjointSolution::response() const {
  std::vector<double> sum(importance.convergence.size(), 0);
  for (const EmitterShare& share : shares) {
    add_to(sum, share.uncollided);
    add_to(sum, share.swept);
  }
  return sum;
}

void check_adjoint(const Problem& problem, const Response& response, const SolveOptions& options) {
  refuse_directional_absorption(problem, response);
  reversed_problem(problem, options);
}

AdjointSolution solve_adjoint(const Emitters& emitters, const Problem& problem,
                              const std::vector<DirectionSet>& sets, const Response& response,
                              const SolveOptions& options, const SolveObserver& observer) {
  refuse_directional_absorption(problem, response);
  const Problem reversed = reversed_problem(problem, options);
  MeanSolution mean;
  for (const DirectionSet& directions : sets) {
    mean.add(solve_on(emitters, reversed, directions, response, options, observer));
  }
  AdjointSolution result{std::move(mean).take(), {}};
  const auto bands = static_cast<std::ptrdiff_t>(problem.band_count());
  auto product = result.importance.source_products.cbegin();
  for (const auto& emitter : emitters) {
    result.shares.push_back({emitter->emitter().kind, emitter->emitter().name, emitter->uncollided(response),
                             std::vector<double>(product, product + bands)});
    product += bands;
  }
  return result;
}

Emitters emitter_sources(const Problem& problem, int threads, const StageObserver& observer) {
  Emitters sources;
  for (Emitter& emitter : emitters_of(problem))
    sources.push_back(
        std::make_unique<const EmitterSource>(std::move(emitter), thread_count(threads), observer));
  return sources;
}

}  // namespace etendue
