// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/vertex_light.h"

namespace etendue {
namespace {

/// Part of the way to the cell's centroid from which a vertex of a flat light is looked at: in its own plane
/// it is dark.
constexpr double step_inside = 1e-6;

bool dark(const LightBeams& beams) {
  for (std::size_t i = 0; i < beams.size(); ++i)
    for (const double value : beams.fluence(i))
      if (value > 0) return false;
  return true;
}

}  // namespace

void look_at_vertex(const LightSource& source, const PointInCell& here, const Vec3& centroid,
                    LightBeams& beams) {
  const PointInCell inside{here.cell, here.position + step_inside * (centroid - here.position)};
  for (const PointInCell& from : {here, inside})
    for (const Sight sight : {Sight::attenuated, Sight::clear}) {
      beams.clear();
      source.add_beams(from, sight, coarse_light, beams);
      if (!dark(beams)) return;
    }
}

}  // namespace etendue
