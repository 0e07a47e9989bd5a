// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/solve/solve.h"

#include <chrono>
#include <optional>
#include <stdexcept>

#include "solver/solution/complex_extinction.h"
#include "solver/solution/following_emission.h"
#include "solver/transport/order/sweep_stopped.h"
#include "solver/transport/solve/acceleration_policy.h"
#include "solver/transport/solve/angular_multigrid.h"
#include "solver/transport/solve/iterate.h"
#include "solver/transport/solve/iterate_emission.h"
#include "solver/transport/solve/precision_policy.h"
#include "solver/transport/solve/read_out.h"
#include "solver/transport/source/directional_emission.h"
#include "solver/transport/source/ordinate_lights.h"
#include "solver/transport/state/state_copy.h"
#include "solver/transport/sweep/transport_sweep.h"

namespace etendue {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point a, Clock::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}

/// Extinction sigma_a + sigma_s, [cell][band], with the real part of what is added to it.
std::vector<double> extinction_of(const Problem& problem, const ComplexExtinction* added) {
  std::vector<double> extinction(problem.absorption().begin(), problem.absorption().end());
  for (std::size_t i = 0; i < extinction.size(); ++i)
    extinction[i] += problem.scattering()[i] + (added != nullptr ? added->real[i / 2] : 0);
  return extinction;
}

/// A complex radiance is not positive, and does not heat.
void refuse_complex(const SolveOptions& options) {
  if (options.complex_extinction == nullptr) return;
  if (options.positivity != Positivity::none || options.following_emission != nullptr ||
      (options.method == Method::source_iteration && options.acceleration == Acceleration::diffusion))
    throw std::invalid_argument("complex radiances with options that need real ones");
}

/// Lights and emission that depend on the direction, and the options with them as angular input.
struct DirectionalSources {
  DirectionalSources(const Problem& problem, const DirectionSet& directions, const SolveOptions& asked)
      : lights(problem, directions, asked.angular_input),
        emission(problem, directions, lights.empty() ? asked.angular_input : &lights),
        options(asked) {
    if (!lights.empty()) options.angular_input = &lights;
    if (!emission.empty()) options.angular_input = &emission;
  }
  DirectionalSources(const DirectionalSources&) = delete;
  DirectionalSources& operator=(const DirectionalSources&) = delete;

  OrdinateLights lights;
  DirectionalEmission emission;
  SolveOptions options;
};

void report_sources(const DirectionalSources& sources, Solution& solution) {
  solution.by_direction = sources.emission.powers();
  if (sources.lights.empty()) return;
  solution.lights.inside = sources.lights.power_inside();
  solution.lights.from_walls = sources.lights.power_through_walls();
}

/// Sets the cost of a sweep for each cell, direction and band [ns].
void report_cost(const TransportSweep& sweep, const std::optional<SingleTransportSweep>& single,
                 const CoarseDirections* coarse, Solution& solution) {
  double swept = sweep.processor_seconds() + (single ? single->processor_seconds() : 0);
  double ordinates =
      static_cast<double>(sweep.band_sweep_count() + (single ? single->band_sweep_count() : 0)) *
      sweep.directions().count();
  if (coarse != nullptr) {
    swept += coarse->processor_seconds();
    ordinates += static_cast<double>(coarse->band_sweep_count()) * coarse->count();
  }
  solution.sweep_cost = 1e9 * swept / (ordinates * sweep.mesh().cell_count());
}

/// solve(); `changing`, where it is not null, is the problem, whose emission follows from the light.
Solution solve_fixed_or_following(const Problem& problem, Problem* changing, const DirectionSet& directions,
                                  const SolveOptions& options, const SolveObserver& observer) {
  if (problem.space() != directions.space())
    throw std::invalid_argument("a plane problem needs directions in the plane, and only that");
  refuse_complex(options);
  const Clock::time_point begun = Clock::now();
  const std::vector<double> extinction = extinction_of(problem, options.complex_extinction);
  const DirectionalSources sources(problem, directions, options);
  TransportSweep sweep(problem, directions, extinction, sources.options);
  TransportState state(sweep.layout());
  FollowingEmission* const following = options.following_emission;
  if (options.initial != nullptr) {
    restore(*options.initial, problem.band_count(), state);
    if (following != nullptr && !options.initial->following.empty())
      following->start_from(options.initial->following);
  }
  Solution solution;
  solution.method = iteration_name(options.method);
  solution.directions = directions.count();

  const std::unique_ptr<CoarseDirections> coarse = make_coarse_directions(sweep, options);
  const Clock::time_point start = Clock::now();
  solution.seconds.orders = sweep.order_seconds() + (coarse ? coarse->order_seconds() : 0);
  solution.seconds.setup = seconds_between(begun, start) - solution.seconds.orders;
  std::optional<SingleTransportSweep> single;
  if (has_cycles_in_single_precision(problem, options) && !sweep.is_direct()) single.emplace(sweep);
  LowOrder low_order;
  SweepRecord record;
  try {
    low_order = choose_low_order(problem, sweep, extinction, options, solution.notes);
    const IterationSetup setup{sweep,   single ? &*single : nullptr, coarse.get(), low_order, options,
                               observer};
    if (changing != nullptr)
      iterate_emission(setup, *changing, state, record, solution);
    else
      iterate(setup, state, record, solution);
  } catch (const SweepStopped&) {
    SolveStopped stopped{saved(state, problem.band_count())};
    if (following != nullptr) stopped.state.following = following->state();
    throw stopped;
  }
  read_out(sweep, state, record, solution);
  if (following != nullptr) solution.state.following = following->state();
  if (low_order.diffusion) {
    solution.seconds.low_order_setup = low_order.diffusion->setup_seconds();
    solution.seconds.low_order = low_order.diffusion->seconds() + solution.seconds.low_order_setup;
  }
  solution.seconds.sweep = seconds_between(start, Clock::now()) - solution.seconds.low_order;
  report_sources(sources, solution);
  report_cost(sweep, single, coarse.get(), solution);
  const std::vector<std::string> notes = notes_of(sweep);
  solution.notes.insert(solution.notes.begin(), notes.begin(), notes.end());
  return solution;
}

}  // namespace

Solution solve(const Problem& problem, const DirectionSet& directions, const SolveOptions& options,
               const SolveObserver& observer) try {
  if (options.following_emission == nullptr)
    return solve_fixed_or_following(problem, nullptr, directions, options, observer);
  Problem changing = problem;
  return solve_fixed_or_following(changing, &changing, directions, options, observer);
} catch (const SweepStopped&) {
  throw SolveStopped{};  // before there was a state
}

}  // namespace etendue
