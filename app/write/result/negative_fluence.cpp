// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/negative_fluence.h"

#include <cmath>

namespace etendue {

std::vector<NegativeFluence> negative_fluence(const Problem& problem, const Solution& solution) {
  const TetrahedralMesh& mesh = problem.mesh();
  const auto bands = static_cast<std::size_t>(problem.band_count());
  std::vector<NegativeFluence> found(bands);
  std::vector<double> negative(bands, 0), whole(bands, 0);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t b = 0; b < bands; ++b) {
        const double value = solution.fluence[(cell.at() * 4 + i) * bands + b];
        whole[b] += mesh.volume(cell) / 4 * value;
        if (value >= 0) continue;
        NegativeFluence& band = found[b];
        ++band.count;
        negative[b] -= mesh.volume(cell) / 4 * value;
        if (value >= band.smallest) continue;
        band.smallest = value;
        band.place = mesh.point(VertexIndex(mesh.vertices(cell)[i]));
        band.region = mesh.region(cell);
      }
  }
  for (std::size_t b = 0; b < bands; ++b)
    if (negative[b] > 0) found[b].share = negative[b] / std::abs(whole[b]);
  return found;
}

}  // namespace etendue
