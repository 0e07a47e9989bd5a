// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/methods/visible_solution.h"

#include "app/progress/progress.h"
#include "app/setup/run_context.h"
#include "app/write/vtk/solution_file.h"
#include "base/errors.h"
#include "solver/solution/solve_observer.h"

namespace etendue {
namespace {

/// Writes the state of a run that continues, every so many sweeps. A disk that is full ends no run.
class Checkpoints {
 public:
  Checkpoints(const Case& input, const Problem& problem, std::ostream& err)
      : input_(input), problem_(problem), err_(err) {}

  void consider(const SweepProgress& progress) {
    const int every = input_.output.checkpoint_every;
    if (every == 0 || progress.sweep % every != 0) return;
    try {
      write_checkpoint(input_, problem_, progress.state());
    } catch (const FileError& error) {
      err_ << "no checkpoint after sweep " << progress.sweep << ": " << error.what() << std::endl;
    }
  }

 private:
  const Case& input_;
  const Problem& problem_;
  std::ostream& err_;
};

}  // namespace

std::optional<Solution> solve_visibly(UncollidedLight& uncollided, const VisibleSolving& solving,
                                      const DirectionSetObserver& reader) {
  const Interruption& interruption = solving.interruption;
  Checkpoints checkpoints(solving.input, solving.problem, solving.err);
  ProgressDisplay display(solving.stages.style, solving.stages.out);
  std::optional<ShownStage> stage(std::in_place, solving.stages, "sweep orders");
  bool is_sweeping = false;
  const auto observe = [&](const SweepProgress& progress) {
    stage.reset();
    solving.interruption.note_the_first();
    display.show(progress);
    checkpoints.consider(progress);
    return interruption.noted() ? SolveControl::stop : SolveControl::proceed;
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
