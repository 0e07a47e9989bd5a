// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/solution/flux_divergence.h"

#include <algorithm>

#include "base/angular_space.h"
#include "solver/solution/node_means.h"

namespace etendue {

bool emits_isotropically(const Problem& problem) {
  return std::ranges::none_of(problem.media(), [](const Medium& medium) {
    return std::ranges::any_of(medium.emission_by_direction,
                               [](const auto& emission) { return emission.has_value(); });
  });
}

std::vector<double> flux_divergence(const Problem& problem, const Solution& solution) {
  const auto bands = static_cast<std::size_t>(problem.band_count());
  const std::vector<double> fluence = node_means(solution.fluence, 4, bands);
  std::vector<double> divergence(static_cast<std::size_t>(problem.mesh().cell_count()), 0.0);
  for (std::size_t i = 0; i < fluence.size(); ++i) {
    const double absorbed =
        solution.absorbed.empty() ? problem.absorption()[i] * fluence[i] : solution.absorbed[i];
    divergence[i / bands] += full_range(problem.space()) * problem.emission()[i] - absorbed;
  }
  return divergence;
}

}  // namespace etendue
