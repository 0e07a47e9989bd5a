// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/methods/visible_steps.h"

#include <algorithm>

#include "app/write/vtk/solution_file.h"
#include "base/errors.h"

namespace etendue {
namespace {

/// Writes the temperatures of a march that continues, after so many sweeps. A disk that is full ends no run.
class StepCheckpoints {
 public:
  explicit StepCheckpoints(const VisibleSolving& solving) : solving_(solving) {}

  void consider(const Solution& solution) {
    int sweeps = 0;
    for (const BandConvergence& band : solution.convergence) sweeps = std::max(sweeps, band.sweeps);
    sweeps_ += sweeps;
    const int every = solving_.input.output.checkpoint_every;
    if (every == 0 || sweeps_ < every) return;
    sweeps_ = 0;
    try {
      write_checkpoint(solving_.input, solving_.problem, solution.state);
    } catch (const FileError& error) {
      solving_.err << "no checkpoint: " << error.what() << std::endl;
    }
  }

 private:
  const VisibleSolving& solving_;
  int sweeps_ = 0;
};

}  // namespace

std::optional<Solution> step_visibly(UncollidedLight& uncollided, const VisibleSolving& solving,
                                     const HeatStepsSetup& setup, const DirectionSetObserver& reader,
                                     TimeResult& result) {
  Interruption& interruption = solving.interruption;
  SolveOptions options = setup.options;
  options.stops = [&] { return interruption.is_overdue(); };
  StepCheckpoints checkpoints(solving);
  ShownStage stage(solving.stages, "temperatures in time");
  const StageObserver show = stage.observer();
  const HeatStepsSetup stopping{setup.input,      setup.problem, setup.temperatures,
                                setup.directions, options,       setup.locator};
  return take_heat_steps(stopping, uncollided,
                         {[&] { return interruption.noted(); },
                          [&](double share, const Solution& solution) {
                            interruption.note_the_first();
                            show(share);
                            checkpoints.consider(solution);
                          }},
                         reader, result);
}

}  // namespace etendue
