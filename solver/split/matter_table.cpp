// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/split/matter_table.h"

#include <numeric>

#include "mesh/tetrahedra/vertex_cells.h"
#include "solver/angle/kernel_formula.h"
#include "solver/angle/scattered_light.h"
#include "solver/lights/vertex_light.h"

namespace etendue {
namespace {

/// [vertex] a cell around it that has matter of the kind, -1 without.
std::vector<std::int32_t> cells_with(const LightSetup& lights, int kind) {
  const TetrahedralMesh& mesh = lights.problem().mesh();
  return wanted_cells_of_vertices(mesh, [&](CellIndex cell) {
    for (std::size_t b = 0; b < lights.paths().bands(); ++b)
      if (lights.paths().matter().kind_of(mesh.region(cell), b) == kind) return true;
    return false;
  });
}

/// A copy that a thread may evaluate.
DirectionalScattering own_copy(const DirectionalScattering& scattering) {
  const auto* formula = std::get_if<KernelFormula>(&scattering);
  return formula != nullptr ? kernel_at(*formula, formula->place) : scattering;
}

ScatteredLight::Beams all_bands(const LightBeams& light) {
  ScatteredLight::Beams beams;
  for (std::size_t i = 0; i < light.size(); ++i)
    beams.emplace_back(light.direction(i),
                       std::accumulate(light.fluence(i).begin(), light.fluence(i).end(), 0.0));
  return beams;
}

}  // namespace

void tabulate_matter(const LightSetup& lights, const LightSource& source, int kind,
                     const DirectionSet& directions, int threads, std::span<double> table) {
  const TetrahedralMesh& mesh = lights.problem().mesh();
  const std::vector<std::int32_t> cell_of = cells_with(lights, kind);
  const std::span<const double> weights = directions.weights();
  std::vector<DirectionalScattering> copies;
  for (int i = 0; i < threads; ++i) copies.push_back(own_copy(lights.paths().matter().scattering(kind)));
  std::size_t next = 0;
#pragma omp parallel num_threads(threads)
  {
    std::size_t own = 0;
#pragma omp critical
    own = next++;
    const ScatteredLight scattered(copies[own], directions);
    LightBeams light(lights.paths().bands());
    ScatteredLight::Beams last;
    std::vector<double> values(weights.size());
#pragma omp for schedule(dynamic, 64)
    for (std::size_t v = 0; v < cell_of.size(); ++v) {
      if (cell_of[v] < 0) continue;
      const CellIndex cell(cell_of[v]);
      look_at_vertex(source, {cell, mesh.points()[v]}, mesh.centroid(cell), light);
      ScatteredLight::Beams beams = all_bands(light);
      // The sun stands in one place for all vertices, and only the shape counts.
      const bool same = beams.size() == 1 && last.size() == 1 && beams[0].first == last[0].first;
      if (!same) scattered.scatter(beams, values);
      last = std::move(beams);
      const double sum = std::inner_product(values.begin(), values.end(), weights.begin(), 0.0);
      if (!(sum > 0)) continue;
      for (std::size_t m = 0; m < values.size(); ++m) table[m * cell_of.size() + v] = values[m] / sum;
    }
  }
}

}  // namespace etendue
