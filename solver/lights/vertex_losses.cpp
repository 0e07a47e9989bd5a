// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/vertex_losses.h"

#include "mesh/tetrahedra/vertex_cells.h"
#include "solver/lights/vertex_light.h"
#include "solver/lights/wide_source.h"

namespace etendue {

VertexLosses::VertexLosses(const LightPaths& paths, const LightSource& source, int threads) : paths_(paths) {
  const TetrahedralMesh& mesh = paths.problem().mesh();
  const std::vector<std::int32_t> cell_of = wanted_cells_of_vertices(
      mesh, [&](CellIndex cell) { return paths.matter().depends_on_direction(mesh.region(cell)); });
  beams_.resize(cell_of.size());
  if (source.as_wide() == nullptr || !source.as_wide()->is_soft()) return;
#pragma omp parallel num_threads(threads)
  {
    LightBeams light(paths.bands());
#pragma omp for schedule(dynamic, 64)
    for (std::size_t v = 0; v < cell_of.size(); ++v) {
      if (cell_of[v] < 0) continue;
      const CellIndex cell(cell_of[v]);
      look_at_vertex(source, {cell, mesh.points()[v]}, mesh.centroid(cell), light);
      std::vector<double> sum(paths.bands(), 0);
      for (std::size_t i = 0; i < light.size(); ++i)
        for (std::size_t b = 0; b < sum.size(); ++b) sum[b] += light.fluence(i)[b];
      for (std::size_t i = 0; i < light.size(); ++i) {
        Beam beam{paths.matter().view(light.direction(i)), {}};
        for (std::size_t b = 0; b < sum.size(); ++b)
          beam.share.push_back(sum[b] > 0 ? light.fluence(i)[b] / sum[b]
                                          : 1 / static_cast<double>(light.size()));
        beams_[v].push_back(std::move(beam));
      }
    }
  }
}

PathCoefficients VertexLosses::at(CellIndex cell, std::size_t corner, std::size_t band) const {
  const Problem& problem = paths_.problem();
  const auto vertex = static_cast<std::size_t>(problem.mesh().vertices(cell)[corner]);
  const Vec3& place = problem.mesh().points()[vertex];
  // In a vertex that is itself the light all directions are alike, as they are in most matter.
  if (beams_[vertex].empty() || !paths_.matter().depends_on_direction(problem.mesh().region(cell)))
    return paths_.matter().at(cell, band, paths_.matter().view(Vec3::UnitZ()), place);
  PathCoefficients mean;
  for (const Beam& beam : beams_[vertex]) {
    const PathCoefficients here = paths_.matter().at(cell, band, beam.view, place);
    mean.absorption += beam.share[band] * here.absorption;
    mean.scattering += beam.share[band] * here.scattering;
  }
  return mean;
}

}  // namespace etendue
