// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/projection/directional_losses.h"

#include "base/quadrature/cell_rule.h"

namespace etendue {
namespace {

/// Fluence, and what is absorbed and scatters of it, by rays from the points of a rule.
NodalMoments seen_from_points(const LightPaths& paths, const LightSource& source, Sight sight,
                              const LitCell& cell, LightBeams& beams) {
  NodalMoments seen(4, NodalMoments::collided + 1, beams.bands());
  for (const CellRulePoint& point : cell_rule()) {
    const Vec3 place = cell.position(point.barycentric);
    beams.clear();
    source.add_beams({cell.index, place}, sight, coarse_light, beams);
    for (std::size_t i = 0; i < beams.size(); ++i) {
      const RayMatter::View view = paths.matter().view(beams.direction(i));
      for (std::size_t b = 0; b < beams.bands(); ++b) {
        const double fluence = beams.fluence(i)[b];
        const PathCoefficients here = paths.matter().at(cell.index, b, view, place);
        seen.add(point.barycentric, point.weight, b, fluence);
        seen.add(point.barycentric, point.weight, b, here.absorption * fluence, NodalMoments::absorbed);
        seen.add(point.barycentric, point.weight, b, here.scattering * fluence, NodalMoments::collided);
      }
    }
  }
  return seen;
}

bool any_light(const NodalMoments& seen, std::size_t bands) {
  for (std::size_t b = 0; b < bands; ++b)
    if (!(seen.integral(0, b) > 0)) return false;
  return true;
}

}  // namespace

// Where no point sees any of the light that a part of the cell gets, it comes as in empty space.
void add_directional_losses(const LightPaths& paths, const LightSource& source, const LitCell& cell,
                            LightBeams& beams, NodalMoments& moments) {
  NodalMoments seen = seen_from_points(paths, source, Sight::attenuated, cell, beams);
  if (!any_light(seen, beams.bands())) seen = seen_from_points(paths, source, Sight::clear, cell, beams);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t b = 0; b < beams.bands(); ++b) {
      const double fluence = seen.at(i, 0, b);
      if (!(fluence > 0)) continue;
      for (const std::size_t loss : {NodalMoments::absorbed, NodalMoments::collided})
        moments.at(i, loss, b) += moments.at(i, 0, b) * seen.at(i, loss, b) / fluence;
    }
}

}  // namespace etendue
