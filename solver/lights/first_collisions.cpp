// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/first_collisions.h"

#include <algorithm>
#include <utility>

namespace etendue {

FirstCollisions first_collisions_of(const Problem& problem, UncollidedField field) {
  const auto bands = static_cast<std::size_t>(problem.band_count());
  FirstCollisions found{std::move(field.collided), std::move(field.collisions)};
  if (!found.scattered.empty()) return found;
  found.scattered = std::move(field.fluence);
  for (std::size_t at = 0; at < found.scattered.size(); ++at)
    found.scattered[at] *= problem.scattering()[at / (4 * bands) * bands + at % bands];
  return found;
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
