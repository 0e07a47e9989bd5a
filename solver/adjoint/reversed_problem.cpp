// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/adjoint/reversed_problem.h"

#include <utility>
#include <vector>

#include "solver/problem/darkened.h"

namespace etendue {
namespace {

bool scatters_by_any_kernel(const Medium& medium) {
  for (const DirectionalScattering& scattering : medium.directional)
    if (std::holds_alternative<KernelFormula>(scattering) || std::holds_alternative<KernelMatrix>(scattering))
      return true;
  return false;
}

void check(const Problem& problem, const SolveOptions& options) {
  if (options.following_emission != nullptr)
    throw InputError(
        "temperatures follow from the light, so that a quantity is not the sum of what its sources bring; "
        "give "
        "media and walls their temperature in place of heat_source, heat_flux, conductivity and convection");
  if (options.positivity != Positivity::none)
    throw InputError(
        "space.positivity keeps values positive, so that a quantity is not the sum of what its sources "
        "bring; "
        "use space.positivity = \"none\"");
  std::vector<Fault> faults;
  for (const Medium& medium : problem.media())
    if (scatters_by_any_kernel(medium))
      faults.push_back(fault_at(medium.origin, "",
                                "a kernel of both directions has no adjoint in this version; use a phase "
                                "function, leaves or flakes"));
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace

Problem reversed_problem(const Problem& problem, const SolveOptions& options) {
  check(problem, options);
  std::vector<Medium> media(problem.media().begin(), problem.media().end());
  for (Medium& medium : media) {
    darken(medium);
    for (auto& absorption : medium.absorption_by_direction)
      if (absorption) absorption = absorption->reversed();
  }
  std::vector<Wall> walls(problem.walls().begin(), problem.walls().end());
  for (Wall& wall : walls) darken(wall);
  return Problem(problem.mesh(), problem.bands(), std::move(media), std::move(walls), problem.space());
}

}  // namespace etendue
