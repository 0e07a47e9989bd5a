// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/methods/visible_steps.h"

#include <algorithm>

namespace etendue {
namespace {

/// Writes the temperatures of a march that continues, after so many sweeps.
class StepCheckpoints {
 public:
  explicit StepCheckpoints(const VisibleSolving& solving) : solving_(solving) {}

  void consider(const Solution& solution) {
    int sweeps = 0;
    for (const BandConvergence& band : solution.convergence) sweeps = std::max(sweeps, band.sweeps);
    sweeps_ += sweeps;
    const int every = solving_.input.output.checkpoint_every;
    if (!solving_.leaves_state || every == 0 || sweeps_ < every) return;
    sweeps_ = 0;
    write_checkpoint_visibly(solving_, solution.state, "");
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
                         {[&] { return any_of(options.ranks, interruption.noted()); },
                          [&](double share, const Solution& solution) {
                            interruption.note_the_first();
                            show(share);
                            checkpoints.consider(solution);
                          }},
                         reader, result);
}

}  // namespace etendue
