// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/uncollided_field.h"

#include <array>
#include <optional>
#include <span>

#include "solver/lights/cell_light.h"
#include "solver/lights/directional_losses.h"
#include "solver/lights/extended_light.h"
#include "solver/lights/face_light.h"
#include "solver/lights/vertex_losses.h"
#include "solver/problem/cell_rule.h"

namespace etendue {
namespace {

/// The product of the fluence in a cell, [4][band], with what it meets at the corners, linear between them.
NodalMoments losses_of(const LitCell& cell, const VertexLosses& vertices, std::span<const double> fluence) {
  const std::size_t bands = fluence.size() / 4;
  NodalMoments moments(4, 6, bands);
  for (std::size_t b = 0; b < bands; ++b) {
    std::array<PathCoefficients, 4> corner;
    for (std::size_t i = 0; i < 4; ++i) corner[i] = vertices.at(cell.index, i, b);
    for (const CellRulePoint& point : cell_rule()) {
      double light = 0;
      PathCoefficients here;
      for (std::size_t i = 0; i < 4; ++i) {
        light += point.barycentric[i] * fluence[i * bands + b];
        here.absorption += point.barycentric[i] * corner[i].absorption;
        here.scattering += point.barycentric[i] * corner[i].scattering;
      }
      const double measure = point.weight * cell.volume * light;
      moments.add(point.barycentric, measure, b, here.absorption, NodalMoments::absorbed);
      moments.add(point.barycentric, measure, b, here.scattering, NodalMoments::collided);
    }
  }
  return moments;
}

/// Adds what is absorbed and scatters of a source's light in a cell: as it was integrated, or by what it
/// meets at the vertices.
void add_losses(const LightPaths& paths, const LitCell& cell, const VertexLosses* vertices,
                const NodalMoments& integrated, std::size_t source, UncollidedField& field) {
  const std::size_t bands = paths.bands();
  const RayMatter& matter = paths.matter();
  const std::span<const double> fluence =
      std::span(field.by_source[source]).subspan(cell.index.at() * 4 * bands, 4 * bands);
  const std::span<double> collided =
      std::span(field.collided_by_source[source]).subspan(cell.index.at() * 4 * bands, 4 * bands);
  double* absorbed = &field.absorbed[cell.index.at() * bands];
  if (matter.depends_on_direction(paths.problem().mesh().region(cell.index)) || matter.varies(cell.index)) {
    const NodalMoments moments = vertices ? losses_of(cell, *vertices, fluence) : integrated;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t b = 0; b < bands; ++b) {
        collided[i * bands + b] = moments.nodal(i, NodalMoments::collided, b, cell.volume);
        absorbed[b] += moments.at(i, NodalMoments::absorbed, b) / cell.volume;
      }
    return;
  }
  const RayMatter::View any;  // asked only where directions are alike
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t b = 0; b < bands; ++b) {
      const PathCoefficients here = matter.at(cell.index, b, any);
      collided[i * bands + b] = here.scattering * fluence[i * bands + b];
      absorbed[b] += here.absorption * fluence[i * bands + b] / 4;
    }
}

void add_cells(const LightPaths& paths, const LightSource& source, const CreasePlanes& creases,
               const std::optional<ExtendedLight>& extended, int threads, UncollidedField& field) {
  const bool with_losses = !paths.matter().empty();
  std::optional<VertexLosses> vertices;
  if (with_losses && extended) vertices.emplace(paths, source, threads);
  std::vector<double>& fluence = field.by_source.back();
  const TetrahedralMesh& mesh = paths.problem().mesh();
  const std::size_t bands = paths.bands();
#pragma omp parallel num_threads(threads)
  {
    LightBeams beams(bands);
    NodalMoments moments(4, with_losses ? 6 : 4, bands);
#pragma omp for schedule(dynamic, 64)
    for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
      const LitCell cell(paths, CellIndex(c));
      moments.clear();
      if (extended)
        extended->add(cell, beams, moments);
      else
        add_directly(paths, source, creases, cell, beams, moments);
      const bool from_points = extended && !source.as_wide()->is_soft() &&
                               paths.matter().depends_on_direction(mesh.region(cell.index));
      if (from_points) add_directional_losses(paths, source, cell, beams, moments);
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t b = 0; b < bands; ++b) {
          const std::size_t node = cell.index.at() * 4 + i;
          fluence[node * bands + b] = moments.nodal(i, 0, b, cell.volume);
          for (std::size_t axis = 0; axis < 3; ++axis)
            field.net_flux[(node * 3 + axis) * bands + b] += moments.nodal(i, 1 + axis, b, cell.volume);
        }
      if (with_losses)
        add_losses(paths, cell, vertices && !from_points ? &*vertices : nullptr, moments,
                   field.by_source.size() - 1, field);
    }
  }
}

void add_walls(const LightPaths& paths, const LightSource& source, const CreasePlanes& creases,
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
        add_irradiance(paths, source, creases, face, beams, moments);
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
  const std::vector<Crease> creases = creases_of(paths);
  for (const auto& source : sources) {
    field.by_source.emplace_back(field.fluence.size(), 0);
    if (!paths.matter().empty()) field.collided_by_source.emplace_back(field.fluence.size(), 0);
    std::optional<ExtendedLight> extended;
    if (source->as_wide() != nullptr) extended.emplace(paths, *source->as_wide(), threads);
    const CreasePlanes planes(paths, creases, *source);
    add_cells(paths, *source, planes, extended, threads, field);
    add_walls(paths, *source, planes, extended, threads, field.irradiance);
    for (std::size_t i = 0; i < field.fluence.size(); ++i) field.fluence[i] += field.by_source.back()[i];
  }
  field.glossy = GlossyBeams(paths, sources, threads);
  return field;
}

}  // namespace etendue
