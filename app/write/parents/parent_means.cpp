// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/parents/parent_means.h"

#include "base/position.h"

namespace etendue {

std::vector<double> parent_volumes(const TetrahedralMesh& mesh) {
  const ParentCells& parents = mesh.parents();
  std::vector<double> volumes(parents.mesh->cell_count(), 0.0);
  for (std::size_t c = 0; c < parents.cells.size(); ++c)
    volumes[position(parents.cells[c])] += mesh.volumes()[c];
  return volumes;
}

std::vector<std::int32_t> parent_regions(const TetrahedralMesh& mesh) {
  const ParentCells& parents = mesh.parents();
  std::vector<std::int32_t> regions(parents.mesh->cell_count(), 0);
  for (std::size_t c = 0; c < parents.cells.size(); ++c)
    regions[position(parents.cells[c])] = mesh.cell_regions()[c];
  return regions;
}

std::vector<double> parent_means(const TetrahedralMesh& mesh, std::span<const double> values,
                                 std::size_t components) {
  const ParentCells& parents = mesh.parents();
  const std::vector<double> volumes = parent_volumes(mesh);
  std::vector<double> means(volumes.size() * components, 0.0);
  for (std::size_t c = 0; c < parents.cells.size(); ++c)
    for (std::size_t k = 0; k < components; ++k)
      means[position(parents.cells[c]) * components + k] += mesh.volumes()[c] * values[c * components + k];
  for (std::size_t i = 0; i < means.size(); ++i) means[i] /= volumes[i / components];
  return means;
}

std::vector<double> parent_heat_flux(const RunResult& result) {
  const TetrahedralMesh& mesh = result.problem.mesh();
  const ParentCells& parents = mesh.parents();
  const auto values = 3 * static_cast<std::size_t>(result.problem.band_count());
  std::vector<double> fluxes(parents.mesh->face_count(), 0.0), areas(fluxes.size(), 0.0);
  for (int f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    if (parents.faces[face.at()] < 0) continue;
    const std::size_t parent = position(parents.faces[face.at()]);
    double net = 0;
    for (std::size_t i = face.at() * values; i < (face.at() + 1) * values; ++i)
      net += result.solution.irradiance[i] - result.solution.exitance[i];
    fluxes[parent] += mesh.area(face) * net / 3;
    areas[parent] += mesh.area(face);
  }
  for (std::size_t f = 0; f < fluxes.size(); ++f)
    if (areas[f] > 0) fluxes[f] /= areas[f];
  return fluxes;
}

}  // namespace etendue
