// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/solve/transport_solver.h"

#include <stdexcept>
#include <utility>

#include "base/wall_clock.h"
#include "solver/solution/added_extinction.h"
#include "solver/solution/following_emission.h"
#include "solver/transport/order/sweep_stopped.h"
#include "solver/transport/solve/angular_multigrid.h"
#include "solver/transport/solve/iterate.h"
#include "solver/transport/solve/iterate_emission.h"
#include "solver/transport/solve/precision_policy.h"
#include "solver/transport/solve/read_out.h"
#include "solver/transport/state/state_copy.h"

namespace etendue {
namespace {

/// Extinction sigma_a + sigma_s, [cell][band], with the real part of what is added to it.
std::vector<double> extinction_of(const Problem& problem, const AddedExtinction* added) {
  std::vector<double> extinction(problem.absorption().begin(), problem.absorption().end());
  for (std::size_t i = 0; i < extinction.size(); ++i)
    extinction[i] += problem.scattering()[i] + (added != nullptr ? added->real_at(i) : 0);
  return extinction;
}

/// A complex radiance is not positive, and does not heat.
void refuse_complex(const SolveOptions& options) {
  if (options.added_extinction == nullptr || !options.added_extinction->is_complex()) return;
  if (options.positivity != Positivity::none || options.following_emission != nullptr ||
      (options.method == Method::source_iteration && options.acceleration == Acceleration::diffusion))
    throw std::invalid_argument("complex radiances with options that need real ones");
}

/// The options, once they are known to suit the problem and the directions.
const SolveOptions& checked(const SolveOptions& options, const Problem& problem,
                            const DirectionSet& directions) {
  if (problem.space() != directions.space())
    throw std::invalid_argument("a plane problem needs directions in the plane, and only that");
  refuse_complex(options);
  return options;
}

}  // namespace

TransportSolver::DirectionalSources::DirectionalSources(const Problem& problem,
                                                        const DirectionSet& directions,
                                                        const SolveOptions& asked)
    : lights(problem, directions, asked.angular_input),
      emission(problem, directions, lights.empty() ? asked.angular_input : &lights),
      options(asked) {
  if (!lights.empty()) options.angular_input = &lights;
  if (!emission.empty()) options.angular_input = &emission;
}

TransportSolver::TransportSolver(const Problem& problem, const DirectionSet& directions,
                                 const SolveOptions& options,
                                 std::shared_ptr<const SweepOrders> known_orders) try
    : changing_(options.following_emission != nullptr ? std::optional<Problem>(problem) : std::nullopt),
      problem_(changing_ ? *changing_ : problem),
      options_(checked(options, problem, directions)),
      extinction_(extinction_of(problem, options.added_extinction)),
      sources_(problem_, directions, options),
      sweep_(problem_, directions, extinction_, sources_.options, std::move(known_orders)),
      state_(sweep_.layout()) {
  if (options.initial != nullptr) {
    restore(*options.initial, problem.band_count(), state_);
    if (options.following_emission != nullptr && !options.initial->following.empty())
      options.following_emission->start_from(options.initial->following);
  }
  coarse_ = make_coarse_directions(sweep_, options);
  if (has_cycles_in_single_precision(problem, options) && !sweep_.is_direct()) single_.emplace(sweep_);
} catch (const SweepStopped&) {
  throw SolveStopped{};  // before there was a state
}

Solution TransportSolver::solve(const SolveObserver& observer) {
  const WallClock::time_point start = WallClock::now();
  FollowingEmission* const following = options_.following_emission;
  Solution solution;
  solution.method = iteration_name(options_.method);
  solution.directions = sweep_.directions().count();
  const double low_order_before = low_order_seconds();
  SweepRecord record;
  try {
    if (!low_order_) low_order_ = choose_low_order(problem_, sweep_, extinction_, options_, low_order_notes_);
    solution.notes = low_order_notes_;
    const IterationSetup setup{sweep_,  single_ ? &*single_ : nullptr, coarse_.get(), *low_order_, options_,
                               observer};
    if (following != nullptr)
      iterate_emission(setup, *changing_, state_, record, solution);
    else
      iterate(setup, state_, record, solution);
  } catch (const SweepStopped&) {
    SolveStopped stopped{saved(state_, problem_.band_count())};
    if (following != nullptr) stopped.state.following = following->state();
    throw stopped;
  }
  read_out(sweep_, state_, record, solution);
  if (following != nullptr) solution.state.following = following->state();
  solution.seconds.orders = sweep_.order_seconds() + (coarse_ ? coarse_->order_seconds() : 0);
  if (low_order_->diffusion) solution.seconds.low_order_setup = low_order_->diffusion->setup_seconds();
  solution.seconds.low_order = low_order_seconds() - low_order_before;
  solution.seconds.sweep = seconds_since(start) - solution.seconds.low_order;
  report_sources(solution);
  solution.sweep_cost = sweep_cost();
  const std::vector<std::string> notes = notes_of(sweep_);
  solution.notes.insert(solution.notes.begin(), notes.begin(), notes.end());
  return solution;
}

void TransportSolver::report_sources(Solution& solution) const {
  solution.by_direction = sources_.emission.powers();
  if (sources_.lights.empty()) return;
  solution.lights.inside = sources_.lights.power_inside();
  solution.lights.from_walls = sources_.lights.power_through_walls();
}

/// In diffusion so far, with its setup.
double TransportSolver::low_order_seconds() const {
  if (!low_order_ || !low_order_->diffusion) return 0;
  return low_order_->diffusion->seconds() + low_order_->diffusion->setup_seconds();
}

double TransportSolver::sweep_cost() const {
  double swept = sweep_.processor_seconds() + (single_ ? single_->processor_seconds() : 0);
  double ordinates =
      static_cast<double>(sweep_.band_sweep_count() + (single_ ? single_->band_sweep_count() : 0)) *
      sweep_.directions().count();
  if (coarse_ != nullptr) {
    swept += coarse_->processor_seconds();
    ordinates += static_cast<double>(coarse_->band_sweep_count()) * coarse_->count();
  }
  // Other ranks took as long.
  const RankGroup* ranks = sweep_.discretization().options.ranks;
  if (ranks != nullptr) swept *= ranks->count();
  return 1e9 * swept / (ordinates * sweep_.mesh().cell_count());
}

}  // namespace etendue
