// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/methods/visible_steps.h"

namespace etendue {

std::optional<Solution> step_visibly(UncollidedLight& uncollided, const VisibleSolving& solving,
                                     const HeatStepsSetup& setup, const DirectionSetObserver& reader,
                                     TimeResult& result) {
  Interruption& interruption = solving.interruption;
  SolveOptions options = setup.options;
  options.stops = [&] { return interruption.is_overdue(); };
  ShownStage stage(solving.stages, "temperatures in time");
  const StageObserver show = stage.observer();
  const HeatStepsSetup stopping{setup.input,      setup.problem, setup.temperatures,
                                setup.directions, options,       setup.locator};
  return take_heat_steps(stopping, uncollided,
                         {[&] { return interruption.noted(); },
                          [&](double share) {
                            interruption.note_the_first();
                            show(share);
                          }},
                         reader, result);
}

}  // namespace etendue
