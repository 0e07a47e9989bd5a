// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/first_collision/solve_rotated.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/solution/mean_solution.h"
#include "solver/solution/node_means.h"
#include "solver/solution/solve_observer.h"

namespace etendue {

double relative_direction_error(const TetrahedralMesh& mesh, const Solution& solution) {
  const std::size_t bands = solution.convergence.size();
  const std::vector<double> means = node_means(solution.fluence, 4, bands);
  double largest = 0;
  for (std::size_t band = 0; band < bands; ++band) {
    double error = 0, size = 0;
    for (std::size_t c = 0; c < mesh.volumes().size(); ++c) {
      size += mesh.volumes()[c] * std::pow(means[c * bands + band], 2);
      error += mesh.volumes()[c] * std::pow(solution.direction_error[c * bands + band], 2);
    }
    if (size > 0) largest = std::max(largest, std::sqrt(error / size));
  }
  return largest;
}

std::size_t estimate_rotated_memory(const LightSetup& lights, const std::vector<DirectionSet>& sets,
                                    const SolveOptions& options,
                                    const std::vector<DirectionSet>& first_collided, KrylovVectors vectors) {
  const std::size_t one = estimate_split_memory(
      lights, sets.front(), options, first_collided.empty() ? nullptr : &first_collided.front(), vectors);
  if (sets.size() == 1) return one;
  // Fluence, net flux and state of the mean and of the state to start from, means of cells and deviations.
  const auto values = static_cast<std::size_t>(lights.problem().mesh().cell_count()) * lights.paths().bands();
  return one + 8 * values * (4 + 12 + 2 * 4 + 2);
}

Solution solve_rotated(const LightSetup& lights, const std::vector<DirectionSet>& sets,
                       const SolveOptions& options, const SolveObserver& observer,
                       const std::vector<DirectionSet>& first_collided, const DirectionSetObserver& reader) {
  UncollidedLight uncollided(lights, options);
  return solve_rotated(uncollided, sets, options, observer, first_collided, reader);
}

Solution solve_rotated(UncollidedLight& uncollided, const std::vector<DirectionSet>& sets,
                       const SolveOptions& options, const SolveObserver& observer,
                       const std::vector<DirectionSet>& first_collided, const DirectionSetObserver& reader) {
  MeanSolution mean;
  SavedState last;
  SolveOptions warm = options;
  int before = 0;
  bool interrupted = false;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    int sweeps = 0;
    const auto shifted = [&](const SweepProgress& progress) {
      sweeps = progress.sweep;
      SweepProgress all = progress;
      all.sweep += before;
      all.max_sweeps += before;
      return observer(all);
    };
    Solution solution;
    try {
      solution = uncollided.solve_rest(sets[i], first_collided.empty() ? nullptr : &first_collided[i], warm,
                                       observer ? SolveObserver(shifted) : SolveObserver(), reader);
    } catch (const SolveStopped&) {
      if (mean.count() == 0) throw;
      interrupted = true;  // the mean of the sets that are done is a result
      break;
    }
    before += sweeps;
    interrupted = solution.interrupted;
    if (interrupted && mean.count() > 0) break;
    mean.add(solution);
    if (interrupted) break;
    last = std::move(solution.state);
    last.is_turned = true;
    warm.initial = &last;
  }
  const int count = mean.count();
  Solution solution = std::move(mean).take();
  solution.interrupted = interrupted;
  if (count > 1)
    solution.notes.insert(
        solution.notes.begin(),
        fmt::format("mean of {} rotated sets of directions; the standard error of the fluence is {:.2g} % "
                    "(root mean square over the volume)",
                    count, 100 * relative_direction_error(uncollided.lights().problem().mesh(), solution)));
  uncollided.finish(solution);
  return solution;
}

}  // namespace etendue
