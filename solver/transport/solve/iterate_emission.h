// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/problem/problem.h"
#include "solver/transport/solve/iterate.h"

namespace etendue {

/// iterate() of a problem whose emission follows from the light (SolveOptions::following_emission): solves
/// for one emission after another, each as far as the emission is known, and in the end for the last.
/// `problem` is that of the sweep. A band has converged where the emission has too.
void iterate_emission(const IterationSetup& setup, Problem& problem, TransportState& state,
                      SweepRecord& record, Solution& solution);

}  // namespace etendue
