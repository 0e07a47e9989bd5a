// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/adjoint/emitter.h"

#include <algorithm>
#include <span>
#include <utility>

#include "solver/problem/darkened.h"
#include "solver/transport/source/directional_emission.h"

namespace etendue {
namespace {

bool emits(const Problem& problem, std::size_t region) {
  if (DirectionalEmission::emits(problem.media()[region])) return true;
  for (std::int32_t c = 0; c < problem.mesh().cell_count(); ++c)
    for (int b = 0; b < problem.band_count(); ++b)
      if (static_cast<std::size_t>(problem.mesh().region(CellIndex(c))) == region &&
          problem.emission(CellIndex(c), b) > 0)
        return true;
  return false;
}

bool emits(const Wall& wall) {
  return std::ranges::any_of(wall.radiance, [](double value) { return value > 0; }) ||
         std::ranges::any_of(wall.radiance_by_direction,
                             [](const auto& of_band) { return of_band.has_value(); });
}

enum class Kept { none, region, wall };

/// The problem with one region's or wall's emission and these lights, and nothing else that emits.
Problem alone(const Problem& problem, Kept kept, std::size_t which, std::span<const Light> lights) {
  std::vector<Medium> media(problem.media().begin(), problem.media().end());
  for (std::size_t i = 0; i < media.size(); ++i)
    if (kept != Kept::region || i != which) darken(media[i]);
  std::vector<Wall> walls(problem.walls().begin(), problem.walls().end());
  for (std::size_t i = 0; i < walls.size(); ++i)
    if (kept != Kept::wall || i != which) darken(walls[i]);
  return Problem(problem.mesh(), problem.bands(), std::move(media), std::move(walls), problem.space(),
                 {lights.begin(), lights.end()});
}

}  // namespace

std::vector<Emitter> emitters_of(const Problem& problem) {
  std::vector<Emitter> emitters;
  for (std::size_t i = 0; i < problem.media().size(); ++i)
    if (emits(problem, i))
      emitters.push_back({EmitterKind::region, problem.media()[i].name, alone(problem, Kept::region, i, {})});
  for (std::size_t i = 0; i < problem.walls().size(); ++i)
    if (emits(problem.walls()[i]))
      emitters.push_back({EmitterKind::wall, problem.walls()[i].name, alone(problem, Kept::wall, i, {})});
  const std::span<const Light> lights = problem.lights();
  for (std::size_t first = 0, end = 0; first < lights.size(); first = end) {
    while (end < lights.size() && lights[end].name == lights[first].name) ++end;
    emitters.push_back({EmitterKind::light, lights[first].name,
                        alone(problem, Kept::none, 0, lights.subspan(first, end - first))});
  }
  return emitters;
}

}  // namespace etendue
