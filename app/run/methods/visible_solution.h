// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <ostream>
#include <string>

#include "app/case/case.h"
#include "app/progress/interruption.h"
#include "app/progress/stage_progress.h"
#include "app/setup/run_directions.h"
#include "solver/uncollided/first_collision/solve_rotated.h"

namespace etendue {

/// What a solution that is watched and may be interrupted takes.
struct VisibleSolving {
  const Case& input;
  const Problem& problem;
  const RunDirections& directions;
  const SolveOptions& options;
  const StageDisplay& stages;
  std::ostream& err;
  Interruption& interruption;
  bool leaves_state = true;  ///< whether a solution that is stopped within a sweep leaves its state
};

/// Writes the state of a run that continues. A disk that is full ends no run: the reason is printed, with
/// `when`, as " after sweep 5".
void write_checkpoint_visibly(const VisibleSolving& solving, const SavedState& state,
                              const std::string& when);

/// Solves, shows how it continues and writes checkpoints. Before the first sweep is done a signal ends the
/// program at once. Later ones end the iteration after its sweep; where that or the last sweep takes more
/// than half a second from then on, solution.vtu alone is written with the state so far where that is
/// wanted, and nothing comes back.
std::optional<Solution> solve_visibly(UncollidedLight& uncollided, const VisibleSolving& solving,
                                      const DirectionSetObserver& reader);

}  // namespace etendue
