// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/vertex_light.h"

#include <algorithm>
#include <cmath>

#include "solver/lights/simplex_rules.h"

namespace etendue {
namespace {

/// Cells that are nearer to the light than this many of their sizes are looked at point by point.
constexpr double near_in_sizes = 1.5;

std::vector<CellIndex> cells_of_vertices(const TetrahedralMesh& mesh) {
  std::vector<CellIndex> cells(static_cast<std::size_t>(mesh.vertex_count()), CellIndex(0));
  for (std::int32_t c = mesh.cell_count() - 1; c >= 0; --c)
    for (const std::int32_t v : mesh.vertices(CellIndex(c)))
      cells[static_cast<std::size_t>(v)] = CellIndex(c);
  return cells;
}

void add_up(const LightBeams& beams, std::span<double> fluence) {
  std::fill(fluence.begin(), fluence.end(), 0.0);
  for (std::size_t i = 0; i < beams.size(); ++i)
    for (std::size_t b = 0; b < fluence.size(); ++b) fluence[b] += beams.fluence(i)[b];
}

}  // namespace

VertexLight::VertexLight(const LightPaths& paths, const LightSource& source, int threads)
    : paths_(paths), source_(source), bands_(paths.bands()) {
  const TetrahedralMesh& mesh = paths.problem().mesh();
  const std::vector<CellIndex> cells = cells_of_vertices(mesh);
  log_transmittance_.resize(cells.size() * bands_);
  mean_direction_.assign(cells.size() * bands_, Vec3::Zero());
#pragma omp parallel num_threads(threads)
  {
    LightBeams beams(bands_);
    std::vector<double> clear(bands_), seen(bands_);
#pragma omp for schedule(dynamic, 64)
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      const PointInCell here{cells[static_cast<std::size_t>(v)], mesh.point(VertexIndex(v))};
      beams.clear();
      source.add_beams(here, Sight::clear, coarse_light, beams);
      add_up(beams, clear);
      beams.clear();
      source.add_beams(here, Sight::attenuated, coarse_light, beams);
      add_up(beams, seen);
      for (std::size_t b = 0; b < bands_; ++b) {
        log_transmittance_[at(v, b)] = clear[b] > 0 ? std::log(seen[b] / clear[b]) : 0;
        for (std::size_t i = 0; i < beams.size() && seen[b] > 0; ++i)
          mean_direction_[at(v, b)] += beams.fluence(i)[b] / seen[b] * beams.direction(i);
      }
    }
  }
}

bool VertexLight::is_lit(std::span<const std::int32_t> vertices) const {
  for (const std::int32_t v : vertices)
    for (std::size_t b = 0; b < bands_; ++b)
      if (!std::isfinite(log_transmittance_[at(v, b)])) return false;
  return true;
}

std::vector<VertexLight::LightHere> VertexLight::look(const PointInCell& here,
                                                      std::span<const double> barycentric,
                                                      std::span<const std::int32_t> vertices,
                                                      LightBeams& beams) const {
  beams.clear();
  source_.add_beams(here, Sight::clear, coarse_light, beams);
  std::vector<double> clear(bands_);
  add_up(beams, clear);
  std::vector<LightHere> light(bands_);
  for (std::size_t b = 0; b < bands_; ++b) {
    double log_transmittance = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      log_transmittance += barycentric[i] * log_transmittance_[at(vertices[i], b)];
      light[b].direction += barycentric[i] * mean_direction_[at(vertices[i], b)];
    }
    light[b].fluence = clear[b] * std::exp(log_transmittance);
  }
  return light;
}

bool VertexLight::add(const LitCell& cell, LightBeams& beams, NodalMoments& moments) const {
  if (source_.is_near(cell.centroid, near_in_sizes * cell.size)) return false;
  const auto& vertices = paths_.problem().mesh().vertices(cell.index);
  if (!is_lit(vertices)) return false;
  for (const CellPointWeight& point : four_point_rule()) {
    const PointInCell here{cell.index, cell.position(point.barycentric)};
    const std::vector<LightHere> light = look(here, point.barycentric, vertices, beams);
    for (std::size_t b = 0; b < bands_; ++b)
      for (std::size_t i = 0; i < 4; ++i) {
        const double value = point.barycentric[i] * point.weight * cell.volume * light[b].fluence;
        moments.at(i, 0, b) += value;
        for (std::size_t axis = 0; axis < 3; ++axis)
          moments.at(i, 1 + axis, b) += value * light[b].direction[static_cast<Eigen::Index>(axis)];
      }
  }
  return true;
}

// Where no mirror sends light back, all of it travels out of the domain: E = F.n.
bool VertexLight::add(FaceIndex face, LightBeams& beams, NodalMoments& moments) const {
  const TetrahedralMesh& mesh = paths_.problem().mesh();
  const double area = mesh.area(face);
  if (paths_.mirrors().of(face) >= 0 ||
      source_.is_near(mesh.centroid(face), near_in_sizes * std::sqrt(2 * area)) ||
      !is_lit(mesh.vertices(face)))
    return false;
  const Vec3 normal = mesh.area_normal(face) / area;
  const auto& vertices = mesh.vertices(face);
  for (const FacePointWeight& point : three_point_rule()) {
    Vec3 position = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i)
      position += point.barycentric[i] * mesh.point(VertexIndex(vertices[i]));
    const std::vector<LightHere> light =
        look({mesh.owner(face), position}, point.barycentric, vertices, beams);
    for (std::size_t b = 0; b < bands_; ++b)
      for (std::size_t i = 0; i < 3; ++i)
        moments.at(i, 0, b) += point.barycentric[i] * point.weight * area * light[b].fluence *
                               std::max(0.0, light[b].direction.dot(normal));
  }
  return true;
}

}  // namespace etendue
