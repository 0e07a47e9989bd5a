// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/uncollided_field.h"

#include <optional>

#include "solver/lights/cell_light.h"
#include "solver/lights/extended_light.h"
#include "solver/lights/face_light.h"
#include "solver/lights/vertex_losses.h"

namespace etendue {
namespace {

/// Cells thicker than this are integrated in the polar frame of a point light wherever they are: along the
/// ray that is exact.
constexpr double thick = 1.5;

void add_cell(const LightPaths& paths, const LightSource& source,
              const std::optional<ExtendedLight>& extended, const LitCell& cell, LightBeams& beams,
              NodalMoments& moments) {
  const PointSource* point = source.as_point();
  if (point != nullptr && (cell.thickness > thick || source.is_near(cell.centroid, cell.size)))
    return add_in_polar_frame(paths, *point, cell, moments);
  if (extended) return extended->add(cell, beams, moments);
  add_by_points(paths, source, cell, beams, moments);
}

/// Adds what is absorbed and scatters of a source's light in a cell.
void add_losses(const LightPaths& paths, const LitCell& cell, const std::optional<VertexLosses>& vertices,
                const NodalMoments& moments, std::size_t source, UncollidedField& field) {
  const int region = paths.problem().mesh().region(cell.index);
  const bool integrated = paths.matter().depends_on_direction(region) && !vertices;
  const RayMatter::View any;  // asked only where directions are alike
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t b = 0; b < paths.bands(); ++b) {
      const std::size_t node = (cell.index.at() * 4 + i) * paths.bands() + b;
      double& collided = field.collided_by_source[source][node];
      double& absorbed = field.absorbed[cell.index.at() * paths.bands() + b];
      if (integrated) {
        collided = moments.nodal(i, NodalMoments::collided, b, cell.volume);
        absorbed += moments.at(i, NodalMoments::absorbed, b) / cell.volume;
        continue;
      }
      const PathCoefficients here = paths.matter().depends_on_direction(region)
                                        ? vertices->at(cell.index, i, b)
                                        : paths.matter().at(cell.index, b, any);
      collided = here.scattering * field.by_source[source][node];
      absorbed += here.absorption * field.by_source[source][node] / 4;
    }
}

void add_cells(const LightPaths& paths, const LightSource& source,
               const std::optional<ExtendedLight>& extended, int threads, UncollidedField& field) {
  const bool by_direction = !paths.matter().empty();
  std::optional<VertexLosses> vertices;
  if (by_direction && extended) vertices.emplace(paths, source, threads);
  std::vector<double>& fluence = field.by_source.back();
  const TetrahedralMesh& mesh = paths.problem().mesh();
  const std::size_t bands = paths.bands();
#pragma omp parallel num_threads(threads)
  {
    LightBeams beams(bands);
    NodalMoments moments(4, by_direction ? 6 : 4, bands);
#pragma omp for schedule(dynamic, 64)
    for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
      const LitCell cell(paths, CellIndex(c));
      moments.clear();
      add_cell(paths, source, extended, cell, beams, moments);
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t b = 0; b < bands; ++b) {
          const std::size_t node = cell.index.at() * 4 + i;
          fluence[node * bands + b] = moments.nodal(i, 0, b, cell.volume);
          for (std::size_t axis = 0; axis < 3; ++axis)
            field.net_flux[(node * 3 + axis) * bands + b] += moments.nodal(i, 1 + axis, b, cell.volume);
        }
      if (by_direction) add_losses(paths, cell, vertices, moments, field.by_source.size() - 1, field);
    }
  }
}

void add_walls(const LightPaths& paths, const LightSource& source,
               const std::optional<ExtendedLight>& extended, int threads, std::vector<double>& irradiance) {
  const TetrahedralMesh& mesh = paths.problem().mesh();
  const std::size_t bands = paths.bands();
#pragma omp parallel num_threads(threads)
  {
    LightBeams beams(bands);
    NodalMoments moments(3, 1, bands);
#pragma omp for schedule(dynamic, 64)
    for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
      const FaceIndex face(f);
      moments.clear();
      // Sky light comes in by walls too: their net flux says little.
      if (extended && !source.as_wide()->is_soft())
        extended->add(face, beams, moments);
      else
        add_irradiance(paths, source, face, beams, moments);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t b = 0; b < bands; ++b)
          irradiance[(face.at() * 3 + i) * bands + b] += moments.nodal(i, 0, b, mesh.area(face));
    }
  }
}

}  // namespace

UncollidedField uncollided_field(const LightPaths& paths, const LightSources& sources, int threads) {
  const TetrahedralMesh& mesh = paths.problem().mesh();
  UncollidedField field;
  field.fluence.assign(static_cast<std::size_t>(mesh.cell_count()) * 4 * paths.bands(), 0);
  field.net_flux.assign(3 * field.fluence.size(), 0);
  field.irradiance.assign(static_cast<std::size_t>(mesh.boundary_face_count()) * 3 * paths.bands(), 0);
  if (!paths.matter().empty())
    field.absorbed.assign(static_cast<std::size_t>(mesh.cell_count()) * paths.bands(), 0);
  for (const auto& source : sources) {
    field.by_source.emplace_back(field.fluence.size(), 0);
    if (!paths.matter().empty()) field.collided_by_source.emplace_back(field.fluence.size(), 0);
    std::optional<ExtendedLight> extended;
    if (source->as_wide() != nullptr) extended.emplace(paths, *source->as_wide(), threads);
    add_cells(paths, *source, extended, threads, field);
    add_walls(paths, *source, extended, threads, field.irradiance);
    for (std::size_t i = 0; i < field.fluence.size(); ++i) field.fluence[i] += field.by_source.back()[i];
  }
  return field;
}

}  // namespace etendue
