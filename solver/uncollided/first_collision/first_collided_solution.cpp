// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/first_collision/first_collided_solution.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "base/errors.h"
#include "base/vector_sums.h"
#include "solver/angular/harmonics/harmonics.h"
#include "solver/transport/scattering/scattering_plan.h"
#include "solver/transport/solve/solve.h"

namespace etendue {
namespace {

using Plan = std::vector<ScatteringTreatment>;

void require_moments(const Problem& problem, const Plan& plan) {
  const auto bands = static_cast<std::size_t>(problem.band_count());
  for (std::size_t i = 0; i < plan.size(); ++i)
    if (plan[i].is_dense())
      throw InputError(
          fmt::format("directions.first_collided: light scatters through a matrix in {} ({}), and light of "
                      "another set is "
                      "handed on by its moments only (not in this version); use scattering_method = "
                      "\"moments\" there, or "
                      "no first_collided",
                      problem.media()[i / bands].name, plan[i].reason));
}

/// The problem without emission, with scattering carried to the degrees of a plan.
Problem dark_problem(const Problem& problem, const Plan& plan) {
  const auto bands = static_cast<std::size_t>(problem.band_count());
  std::vector<Medium> media(problem.media().begin(), problem.media().end());
  std::vector<Wall> walls(problem.walls().begin(), problem.walls().end());
  for (std::size_t i = 0; i < media.size(); ++i) {
    media[i].emission.assign(bands, Coefficient(0.0));
    media[i].emission_by_direction.clear();
    media[i].blackbody.clear();
    media[i].choice.clear();
    for (std::size_t b = 0; b < bands; ++b) {
      const ScatteringTreatment& how = plan[i * bands + b];
      media[i].choice.push_back({ScatteringBackend::moments, how.degree,
                                 how.forward != 0 ? ForwardPeak::delta_m : ForwardPeak::keep});
    }
  }
  for (Wall& wall : walls) {
    wall.radiance.assign(bands, 0);
    wall.radiance_by_direction.clear();
  }
  return Problem(problem.mesh(), problem.bands(), std::move(media), std::move(walls));
}

std::vector<int> degrees_of(const DirectionSet& set, int degree) {
  const DiscreteHarmonics harmonics(set, degree);
  std::vector<int> degrees;
  for (int k = 0; k < harmonics.count(); ++k) degrees.push_back(harmonics.degree_of(k));
  return degrees;
}

/// Moments are handed on one by one, so both sets must have the same.
void require_same_moments(const Plan& plan, const Plan& finer_plan, const DirectionSet& set,
                          const DirectionSet& finer) {
  int highest = 0;
  bool same = true;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    highest = std::max(highest, plan[i].degree);
    same = same && plan[i].degree == finer_plan[i].degree;
  }
  if (same && degrees_of(set, highest) == degrees_of(finer, highest)) return;
  throw InputError(fmt::format(
      "directions.first_collided: the set {} {} has not the moments of degree {} that light scatters through "
      "on {} {}; use a finer set",
      finer.name(), finer.order(), highest, set.name(), set.order()));
}

/// A state in which nothing is known but what mirrors and lagged faces hand on.
SavedState traces_of(const SavedState& state) {
  SavedState traces = state;
  for (auto* values : {&traces.fluence, &traces.moments, &traces.irradiance})
    std::fill(values->begin(), values->end(), 0.0);
  return traces;
}

bool keeps_all(const SolveOptions& options, const DirectionSet& directions) {
  return options.keep_ordinates.size() == static_cast<std::size_t>(directions.count());
}

/// The largest change of the fluence relative to its size, both as sums over all nodes.
double change(const std::vector<double>& before, const std::vector<double>& after) {
  double moved = 0, size = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    moved += std::abs(after[i] - (before.empty() ? 0 : before[i]));
    size += std::abs(after[i]);
  }
  return size > 0 ? moved / size : 0;
}

}  // namespace

FirstCollidedSolution::FirstCollidedSolution(const LightSetup& lights, const UncollidedField& field,
                                             const Problem& remaining, const DirectionSet& finer,
                                             const DirectionSet& directions, const SolveOptions& options,
                                             int threads)
    : finer_(finer) {
  const Plan plan = plan_scattering(remaining, directions);
  require_moments(remaining, plan);
  const Problem dark = dark_problem(remaining, plan);
  require_same_moments(plan, plan_scattering(dark, finer), directions, finer);
  const auto start = std::chrono::steady_clock::now();
  input_.emplace(lights, field, finer, threads);
  seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  SolveOptions with_input = options;
  with_input.angular_input = &*input_;
  with_input.keep_ordinates.clear();
  for (int m = 0; m < finer.count() && keeps_all(options, directions); ++m)
    with_input.keep_ordinates.push_back(m);
  sweep(dark, with_input);
}

// Where mirrors or lagged faces hand light to the next sweep, as many as that takes: nothing else is.
void FirstCollidedSolution::sweep(const Problem& problem, const SolveOptions& options) {
  SolveOptions one_sweep = options;
  one_sweep.method = Method::source_iteration;
  one_sweep.acceleration = Acceleration::none;
  one_sweep.max_sweeps = 1;
  one_sweep.initial = nullptr;
  SavedState traces;
  std::vector<double> before;
  SolveSeconds seconds;
  do {
    before = std::move(solution_.fluence);
    solution_ = solve(problem, finer_, one_sweep);
    seconds.orders += solution_.seconds.orders;
    seconds.sweep += solution_.seconds.sweep;
    seconds.setup += solution_.seconds.setup;
    ++sweeps_;
    traces = traces_of(solution_.state);
    one_sweep.initial = &traces;
  } while ((!traces.mirrors.empty() || !traces.lagged.empty()) && sweeps_ < options.max_sweeps &&
           change(before, solution_.fluence) > options.tolerance);
  solution_.seconds = seconds;
}

void FirstCollidedSolution::add_to(Solution& rest) const {
  etendue::add_to(rest.net_flux, solution_.net_flux);
  etendue::add_to(rest.exitance, solution_.exitance);
  etendue::add_to(rest.meters, solution_.meters);
  rest.seconds.orders += solution_.seconds.orders;
  rest.seconds.sweep += solution_.seconds.sweep;
  rest.seconds.setup += solution_.seconds.setup;
  rest.seconds.lights += seconds_;
  rest.notes.insert(rest.notes.begin(),
                    fmt::format("light that collided once: {} {} of {} directions", sweeps_,
                                sweeps_ == 1 ? "sweep" : "sweeps", solution_.directions));
}

std::size_t FirstCollidedSolution::memory(const Problem& problem, const DirectionSet& directions,
                                          const DirectionSet& finer, const SolveOptions& options) {
  const auto values = static_cast<std::size_t>(problem.mesh().cell_count()) * 4 *
                      static_cast<std::size_t>(problem.band_count());
  // Fluence and net flux, and the fluence of the state; and radiance.
  const std::size_t fields = 5 + (keeps_all(options, directions) ? 2 * finer.directions().size() : 0);
  return sizeof(double) * values * fields;
}

}  // namespace etendue
