// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "solver/angular/sets/direction_set.h"
#include "solver/solution/solution.h"
#include "solver/solution/solve_observer.h"
#include "solver/solution/solve_options.h"
#include "solver/stepping/step_plan.h"
#include "solver/time/emission_course.h"
#include "solver/time/slowness.h"
#include "solver/time/uncollided_in_time.h"
#include "solver/transport/solve/solve.h"

namespace etendue {

/// Numbers that are read of a solution, linear in it.
using NumbersReader = std::function<std::vector<double>(const Problem& problem, const Solution& solution)>;

/// Errors are by how much a step of first order would change the fluence, relative to its largest value so
/// far, both as root mean squares over the volume.
struct StepOptions : StepPlan {
  /// Root mean square of a fluence that counts as one of those so far [power/length^2]: from darkness the
  /// first steps have nothing that they could be compared with.
  double scale = 0;
  NumbersReader read = {};
  /// The same numbers of light along rays.
  std::function<std::vector<double>(const UncollidedValues& values)> read_uncollided = {};
};

/// A step that was taken.
struct TimeStep {
  double begin = 0, end = 0;          ///< [time]
  double error = 0;                   ///< what StepOptions::tolerance bounds
  std::vector<double> values;         ///< at its end, as StepOptions::read made them
  std::vector<double> errors;         ///< by how much they would differ in first order
  std::vector<double> energy;         ///< [band] of all light at its end [power time]
  std::vector<double> energy_errors;  ///< [band] by how much it would differ in first order
  /// Emitted less absorbed energy and outflow in the step, less the change of the energy: of the worst band
  /// [power time]. The iteration leaves it.
  double imbalance = 0;
  int sweeps = 0;            ///< of all its solutions
  double residual = 0;       ///< the largest of them
  bool converged = true;     ///< all of them
  const Problem& problem;    ///< with the emission at its end
  const Solution& solution;  ///< at its end
  /// At its end light along rays, which is not in the solution; of pulses the mean over the step. Null where
  /// all light is.
  const UncollidedValues* uncollided;
};

/// Root mean square of a fluence [cell][4][band] over the volume, of the values at the vertices, all bands
/// together [power/length^2].
double rms_fluence(const Problem& problem, std::span<const double> fluence);

/// Takes steps while they last. Returns false where no more are wanted.
using TimeStepReader = std::function<bool(const TimeStep&)>;

/// Marches in time from darkness, by (L8) to (L10) of docs/theory/time.md:
///
///     n/c du/dt + w.grad u + sigma_t u = integral of sigma_s p(w.w') u(w') dw' + f(t) q,  u(0) = pulses c/n
///
/// The radiance is kept for all directions, twice. Light that `uncollided` knows is not swept until it has
/// collided, and what it emits counts where and when it scatters and is reflected: as its mean over each
/// step, so that none is lost. Null: all is left to the directions. Options are those of a steady solution;
/// an angular input, a state to start from and ordinates to keep are not used. Throws as solve() and
/// TimedSources do, std::invalid_argument where the options make no sense, and std::domain_error where steps
/// that adapt become too short.
void march_in_time(const Problem& problem, const DirectionSet& directions, const Slowness& slowness,
                   const EmissionCourses& courses, const StepOptions& steps, const SolveOptions& options,
                   const TimeStepReader& reader, const SolveObserver& observer = {},
                   const UncollidedInTime* uncollided = nullptr);

/// Bytes that march_in_time() takes at its peak, with so many vectors of GMRES in a step.
std::size_t estimate_march_memory(const Problem& problem, const DirectionSet& directions,
                                  const SolveOptions& options, KrylovVectors vectors);

}  // namespace etendue
