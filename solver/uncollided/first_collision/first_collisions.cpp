// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/first_collision/first_collisions.h"

#include <algorithm>
#include <utility>

namespace etendue {

FirstCollisions first_collisions_of(const Problem& problem, UncollidedField field) {
  std::vector<double> scattered(field.fluence.size());
  for (std::size_t i = 0; i < scattered.size(); ++i) scattered[i] = scattered_density(problem, field, i);
  return {std::move(scattered), std::move(field.collisions)};
}

std::shared_ptr<const FirstCollisions> find_first_collisions(const LightSetup& lights, int threads,
                                                             const StageObserver& observer) {
  const Problem& problem = lights.problem();
  const bool scatters = std::ranges::any_of(problem.scattering(), [](double value) { return value > 0; });
  if (lights.empty() || !scatters) return std::make_shared<const FirstCollisions>();
  return std::make_shared<const FirstCollisions>(
      first_collisions_of(problem, uncollided_field(lights.paths(), lights.sources(), threads, observer)));
}

}  // namespace etendue
