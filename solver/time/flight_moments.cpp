// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/flight_moments.h"

#include "solver/time/angular_history.h"
#include "solver/time/timed_sources.h"
#include "solver/transport/solve/transport_solver.h"

namespace etendue {

void solve_flight_moments(const Problem& problem, const DirectionSet& directions, const Slowness& slowness,
                          int highest, const SolveOptions& options, const MomentReader& reader,
                          const SolveObserver& observer) {
  // Moment k stands in the place of the time: all sources emit at 0 and nothing later.
  const TimedSources sources(problem, directions,
                             one_course(problem, {false, [](double k) { return k == 0 ? 1.0 : 0.0; }}));
  AngularHistory history(problem, sources, slowness);
  Problem dark = darkened(problem);
  SolveOptions own = options;
  own.keep_ordinates = all_ordinates(directions);
  own.angular_input = &history;
  own.initial = nullptr;
  TransportSolver solver(dark, directions, own);
  for (int k = 0; k <= highest; ++k) {
    history.set_time(1, k);
    history.mix(k, 0);
    dark.set_following(sources.isotropic_at(k));
    Solution moment = solver.solve(observer);
    if (moment.interrupted) throw SolveStopped{};
    reader(k, dark, moment);
    history.accept(std::move(moment.radiance), false);
  }
}

}  // namespace etendue
