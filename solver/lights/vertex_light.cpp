// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/vertex_light.h"

#include <algorithm>
#include <cmath>

#include "solver/lights/simplex_rules.h"

namespace etendue {
namespace {

/// Largest range of log T in a cell: linear between them it is off by less than an eighth of its curvature.
constexpr double widest_range = 1.0;
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

bool VertexLight::add(const LitCell& cell, LightBeams& beams, NodalMoments& moments) const {
  if (source_.is_near(cell.centroid, near_in_sizes * cell.size)) return false;
  const auto& vertices = paths_.problem().mesh().vertices(cell.index);
  for (std::size_t b = 0; b < bands_; ++b) {
    double lowest = log_transmittance_[at(vertices[0], b)], highest = lowest;
    for (const std::int32_t v : vertices) {
      lowest = std::min(lowest, log_transmittance_[at(v, b)]);
      highest = std::max(highest, log_transmittance_[at(v, b)]);
    }
    if (!(highest - lowest <= widest_range)) return false;
  }
  std::vector<double> clear(bands_);
  for (const CellPointWeight& point : four_point_rule()) {
    beams.clear();
    source_.add_beams({cell.index, cell.position(point.barycentric)}, Sight::clear, coarse_light, beams);
    add_up(beams, clear);
    for (std::size_t b = 0; b < bands_; ++b) {
      double log_transmittance = 0;
      Vec3 direction = Vec3::Zero();
      for (std::size_t i = 0; i < 4; ++i) {
        log_transmittance += point.barycentric[i] * log_transmittance_[at(vertices[i], b)];
        direction += point.barycentric[i] * mean_direction_[at(vertices[i], b)];
      }
      const double value = point.weight * cell.volume * clear[b] * std::exp(log_transmittance);
      for (std::size_t i = 0; i < 4; ++i) {
        moments.at(i, 0, b) += point.barycentric[i] * value;
        for (std::size_t axis = 0; axis < 3; ++axis)
          moments.at(i, 1 + axis, b) +=
              point.barycentric[i] * value * direction[static_cast<Eigen::Index>(axis)];
      }
    }
  }
  return true;
}

}  // namespace etendue
