// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/methods/visible_solution.h"

#include "app/progress/progress.h"
#include "app/setup/run_context.h"
#include "app/write/vtk/solution_file.h"
#include "base/errors.h"
#include "solver/solution/solve_observer.h"

namespace etendue {

void write_checkpoint_visibly(const VisibleSolving& solving, const SavedState& state,
                              const std::string& when) {
  try {
    write_checkpoint(solving.input, solving.problem, state);
  } catch (const FileError& error) {
    solving.err << "no checkpoint" << when << ": " << error.what() << std::endl;
  }
}

std::optional<Solution> solve_visibly(UncollidedLight& uncollided, const VisibleSolving& solving,
                                      const DirectionSetObserver& reader) {
  const Interruption& interruption = solving.interruption;
  const int every = solving.input.output.checkpoint_every;
  ProgressDisplay display(solving.stages.style, solving.stages.out);
  std::optional<ShownStage> stage(std::in_place, solving.stages, "sweep orders");
  bool is_sweeping = false;
  const auto observe = [&](const SweepProgress& progress) {
    stage.reset();
    solving.interruption.note_the_first();
    display.show(progress);
    if (solving.leaves_state && every != 0 && progress.sweep % every == 0)
      write_checkpoint_visibly(solving, progress.state(), " after sweep " + std::to_string(progress.sweep));
    return any_of(solving.options.ranks, interruption.noted()) ? SolveControl::stop : SolveControl::proceed;
  };
  SolveOptions options = solving.options;
  options.stops = [&] { return interruption.is_overdue(); };
  options.orders_share = [&](double share) {
    if (stage && !is_sweeping) stage->observer()(share);
  };
  options.sweep_share = [&](double share) {
    if (stage && !is_sweeping) stage.emplace(solving.stages, "first sweep");
    is_sweeping = true;
    if (stage) stage->observer()(share);
  };
  try {
    Solution solution = solve_rotated(uncollided, solving.directions.sets, options, observe,
                                      solving.directions.first_collided, reader);
    stage.reset();
    display.finish();
    return solution;
  } catch (const SolveStopped& stopped) {
    display.finish();
    if (!solving.leaves_state) return std::nullopt;
    solving.interruption.note_all();
    write_checkpoint(solving.input, solving.problem, stopped.state);
    solving.err
        << "interrupted within a long sweep: solution.vtu alone is written, with the state of the last "
           "whole one; "
        << how_to_go_on(solving.input);
    return std::nullopt;
  }
}

}  // namespace etendue
