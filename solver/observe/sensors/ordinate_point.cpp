// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/sensors/ordinate_point.h"

#include <algorithm>

#include "base/field_view.h"

namespace etendue {

OrdinatesAtPoint ordinates_at_point(const TetrahedralMesh& mesh, const DirectionSetSolution& swept,
                                    std::span<const CellPoint> cells, const Vec3& normal) {
  const std::size_t bands = swept.solution.fluence.size() / 4 / static_cast<std::size_t>(mesh.cell_count());
  OrdinatesAtPoint found{std::vector<double>(bands, 0), std::vector<double>(bands, 0)};
  double volume = 0;
  for (const CellPoint& place : cells) volume += mesh.volume(place.cell);
  for (const OrdinateRadiance& ordinate : swept.solution.radiance) {
    const OrdinateIndex n(ordinate.ordinate);
    const double weight = swept.directions.weight(n);
    const ConstCellField values(ordinate.values, bands);
    const double across = weight * std::max(0.0, -normal.dot(swept.directions.direction(n)));
    for (const CellPoint& place : cells)
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t b = 0; b < bands; ++b) {
          const double radiance =
              mesh.volume(place.cell) / volume * place.barycentric[i] * values(place.cell, i, b);
          found.irradiance[b] += across * radiance;
          found.fluence[b] += weight * radiance;
        }
  }
  return found;
}

}  // namespace etendue
