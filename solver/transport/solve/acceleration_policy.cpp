// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/solve/acceleration_policy.h"

#include <fmt/format.h>

#include <algorithm>

#include "solver/transport/solve/returned_light.h"

namespace etendue {
namespace {

/// Reflectance and albedo below which plain iteration is quick: with half of the light scattered, Kobayashi's
/// first problem takes 11 sweeps and with acceleration 10, which cost more than one.
constexpr double little_return = 0.5;

/// Scatterings on a mean chord below which diffusion saves less than it costs, unless walls are brighter than
/// `bright_wall`: the smoke room, with 0.2 of them, takes 13 sweeps and with acceleration 12.
constexpr double few_scatterings = 1;
constexpr double bright_wall = 0.8;

/// Returns the reason why diffusion would not pay; empty where it does.
std::string reason_to_do_without(const Problem& problem) {
  const double wall = brightest_wall(problem);
  if (const double part = std::max(wall, largest_albedo(problem)); part <= little_return)
    return fmt::format("cells and walls send back at most {:.2g} of the light", part);
  if (const double scatterings = scatterings_on_a_chord(problem);
      wall <= bright_wall && scatterings < few_scatterings)
    return fmt::format("light scatters only {:.2g} times on its way through", scatterings);
  return "";
}

/// Returns the reason why a run is not accelerated; empty where it is.
std::string reason_against_acceleration(const Problem& problem, const SolveOptions& options) {
  if (options.acceleration == Acceleration::diffusion) return "";
  if (options.acceleration == Acceleration::none) return "as asked";
  if (options.method == Method::source_iteration)
    return "source iteration is plain unless diffusion is asked for";
  // Solved for each of the temperatures, so that it pays even where a single solution would do without.
  if (options.following_emission != nullptr && largest_albedo(problem) > 0) return "";
  return reason_to_do_without(problem);
}

}  // namespace

LowOrderPlan plan_low_order(const Problem& problem, const SolveOptions& options) {
  if (options.max_sweeps <= 2) return {};
  const std::string reason = reason_against_acceleration(problem, options);
  // Where acceleration would pay, residuals alone are a poor estimate of the error.
  return {reason.empty() || reason_to_do_without(problem).empty(), reason};
}

LowOrder choose_low_order(const Problem& problem, TransportSweep& sweep, std::span<const double> extinction,
                          const SolveOptions& options, std::vector<std::string>& notes) {
  if (sweep.is_direct()) return {};
  const LowOrderPlan plan = plan_low_order(problem, options);
  if (!plan.reason.empty()) notes.push_back("not accelerated: " + plan.reason);
  if (!plan.is_needed) return {};
  return {std::make_unique<DiffusionAcceleration>(problem, sweep, extinction, options.diffusion_length),
          plan.reason.empty()};
}

}  // namespace etendue
