// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/flight_moments.h"

#include <cmath>
#include <optional>

#include "base/parallel/thread_count.h"
#include "solver/time/angular_history.h"
#include "solver/time/collisions_in_time.h"
#include "solver/time/timed_sources.h"
#include "solver/transport/solve/transport_solver.h"

namespace etendue {

void solve_flight_moments(const Problem& problem, const DirectionSet& directions, const Slowness& slowness,
                          int highest, const SolveOptions& options, const MomentReader& reader,
                          const SolveObserver& observer, const UncollidedInTime* uncollided) {
  const Problem& swept = uncollided != nullptr ? uncollided->remaining() : problem;
  // Moment k stands in the place of the time: all sources emit at 0 and nothing later.
  const TimedSources sources(swept, directions,
                             one_course(swept, {false, [](double k) { return k == 0 ? 1.0 : 0.0; }}));
  std::optional<CollisionsInTime> collisions;
  if (uncollided != nullptr) collisions.emplace(*uncollided, directions, thread_count(options.threads));
  AngularHistory history(swept, sources, slowness, collisions ? &collisions->input() : nullptr);
  Problem dark = darkened(swept);
  SolveOptions own = options;
  own.keep_ordinates = all_ordinates(directions);
  own.angular_input = &history;
  own.initial = nullptr;
  TransportSolver solver(dark, directions, own);
  for (int k = 0; k <= highest; ++k) {
    history.set_time(1, k);
    history.mix(k, 0);
    dark.set_following(sources.isotropic_at(k));
    if (collisions)
      collisions->set({1, 1, [k](const PathTime& path, std::span<double> factors) {
                         factors[0] = std::pow(path.time, k);
                       }});
    Solution moment = solver.solve(observer);
    if (moment.interrupted) throw SolveStopped{};
    reader(k, dark, moment, collisions ? &collisions->values() : nullptr);
    history.accept(std::move(moment.radiance), false);
  }
}

}  // namespace etendue
