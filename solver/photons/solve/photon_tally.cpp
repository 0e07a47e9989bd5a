// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/solve/photon_tally.h"

#include <algorithm>
#include <numbers>

#include "base/field_view.h"
#include "mesh/tetrahedra/sheet_faces.h"
#include "solver/photons/sampling/directional_medium.h"
#include "solver/problem/lights/beam_pieces.h"
#include "solver/problem/mirror.h"

namespace etendue {
namespace {

void add_beam(const Problem& problem, const BeamLight& beam, Solution& fields) {
  const TetrahedralMesh& mesh = problem.mesh();
  const auto bands = static_cast<std::size_t>(problem.band_count());
  const FaceField exitance(fields.exitance, bands);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    if (std::ranges::count(beam.walls, mesh.wall(face)) == 0) continue;
    const double seen = entering_area(beam, mesh, face);
    for (std::size_t b = 0; b < bands; ++b) {
      const double sent = seen * beam.irradiance[b];
      fields.lights.from_walls[static_cast<std::size_t>(mesh.wall(face))][b] += sent;
      for (std::size_t i = 0; i < 3; ++i) exitance(face, i, b) += sent / mesh.area(face);
    }
  }
}

double power_inside(const Light& light, std::size_t band) {
  if (const auto* point = std::get_if<PointLight>(&light.kind)) return point->power[band];
  const auto* surface = std::get_if<SurfaceLight>(&light.kind);
  if (surface == nullptr) return 0;
  double area = 0;
  for (std::size_t t = 0; t + 2 < surface->triangles.size(); t += 3)
    area += (surface->triangles[t + 1] - surface->triangles[t])
                .cross(surface->triangles[t + 2] - surface->triangles[t])
                .norm() /
            2;
  return std::numbers::pi * surface->radiance[band] * area;
}

}  // namespace

void TallySums::clear() {
  std::ranges::fill(cells_, 0);
  std::ranges::fill(faces_, 0);
  std::ranges::fill(absorbed_, 0);
}

void TallySums::to_fields(const Problem& problem, int band, double scale, Solution& fields) const {
  const TetrahedralMesh& mesh = problem.mesh();
  const auto bands = static_cast<std::size_t>(problem.band_count()), b = static_cast<std::size_t>(band);
  const CellField fluence(fields.fluence, bands);
  const CellVectors net_flux(fields.net_flux, bands);
  const BandTable absorbed(fields.absorbed, bands);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    const double factor = scale / mesh.volume(cell);
    if (!fields.absorbed.empty()) absorbed(cell, b) = factor * absorbed_[cell.at()];
    for (std::size_t quantity = 0; quantity < 4; ++quantity) {
      const double* m = cells_.data() + 16 * cell.at() + 4 * quantity;
      const double sum = m[0] + m[1] + m[2] + m[3];
      for (std::size_t i = 0; i < 4; ++i) {
        const double value = factor * (20 * m[i] - 4 * sum);
        if (quantity == 0)
          fluence(cell, i, b) = value;
        else
          net_flux(cell, i, quantity - 1, b) = value;
      }
    }
  }
  const FaceField irradiance(fields.irradiance, bands), exitance(fields.exitance, bands);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const double factor = scale / mesh.area(face);
    const double* m = faces_.data() + 4 * face.at();
    for (std::size_t i = 0; i < 3; ++i) {
      irradiance(face, i, b) = factor * (12 * m[i] - 3 * (m[0] + m[1] + m[2]));
      exitance(face, i, b) = factor * m[3];
    }
  }
}

Solution empty_fields(const Problem& problem) {
  const TetrahedralMesh& mesh = problem.mesh();
  const auto bands = static_cast<std::size_t>(problem.band_count());
  const auto cells = static_cast<std::size_t>(mesh.cell_count());
  const auto faces = static_cast<std::size_t>(mesh.boundary_face_count());
  Solution fields;
  fields.fluence.assign(4 * cells * bands, 0);
  fields.net_flux.assign(12 * cells * bands, 0);
  if (depends_on_direction(problem)) fields.absorbed.assign(cells * bands, 0);
  fields.irradiance.assign(3 * faces * bands, 0);
  fields.exitance.assign(3 * faces * bands, 0);
  return fields;
}

void complete_fields(const Problem& problem, Solution& fields) {
  const TetrahedralMesh& mesh = problem.mesh();
  const auto bands = static_cast<std::size_t>(problem.band_count());
  fields.half_range.assign(static_cast<std::size_t>(mesh.boundary_face_count()), half_range(problem.space()));
  const std::vector<std::int32_t> behind = faces_behind(mesh);
  for (std::size_t f = 0; f < fields.half_range.size(); ++f) {
    const Wall& wall = problem.wall(mesh.wall(FaceIndex(static_cast<std::int64_t>(f))));
    fields.half_range[f] *= entering_part(wall);
    for (std::size_t node = 3 * f; node < 3 * f + 3; ++node)
      for (std::size_t b = 0; b < bands; ++b) {
        fields.exitance[node * bands + b] +=
            fields.half_range[f] * wall.radiance[b] +
            (wall.diffuse[b] + wall.specular[b]) * fields.irradiance[node * bands + b];
        if (wall.transmitted(b) > 0)
          fields.exitance[node * bands + b] +=
              wall.transmitted(b) *
              fields.irradiance[(3 * static_cast<std::size_t>(behind[f]) + node % 3) * bands + b];
      }
  }
  fields.lights.from_walls.assign(problem.walls().size(), std::vector<double>(bands, 0));
  fields.lights.inside.assign(bands, 0);
  for (const Light& light : problem.lights()) {
    if (const auto* beam = std::get_if<BeamLight>(&light.kind)) add_beam(problem, *beam, fields);
    for (std::size_t b = 0; b < bands; ++b) fields.lights.inside[b] += power_inside(light, b);
  }
}

}  // namespace etendue
