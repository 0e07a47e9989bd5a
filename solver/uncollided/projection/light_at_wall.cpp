// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/projection/light_at_wall.h"

#include <algorithm>

#include "solver/uncollided/projection/face_light.h"

namespace etendue {

double part_at_wall(const LightPaths& paths, const std::vector<ShadowEdge>& shadow_edges,
                    const LightSource& source, const Wall& wall) {
  const Problem& problem = paths.problem();
  const TetrahedralMesh& mesh = problem.mesh();
  const ShadowPlanes planes(paths, shadow_edges, source);
  LightBeams beams(paths.bands());
  NodalMoments arriving(3, 1, paths.bands());
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    if (const FaceIndex face(f); &problem.wall(mesh.wall(face)) == &wall)
      add_irradiance(paths, source, planes, face, beams, arriving);
  double largest = 0;
  for (std::size_t b = 0; b < paths.bands(); ++b) {
    const double power = arriving.at(0, 0, b) + arriving.at(1, 0, b) + arriving.at(2, 0, b);
    if (source.power()[b] > 0) largest = std::max(largest, power / source.power()[b]);
  }
  return largest;
}

}  // namespace etendue
